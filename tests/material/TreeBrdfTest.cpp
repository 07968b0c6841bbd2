// Tensor trees: the map of the disk, cells and their order, look-up, marginals, sampling and averaging.
#include <brdf/base/Error.h>
#include <brdf/geometry/Directions.h>
#include <brdf/geometry/DiskSquare.h>
#include <brdf/material/Averages.h>
#include <brdf/material/LobeSum.h>
#include <brdf/sampling/SamplerChecks.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace brdf {
namespace {

/// Divided to level 1, and child 0, 5 and the last again; every cell another value.
TensorTree unevenTree(int rank, std::size_t channels = 1) {
  TensorTree tree(rank, channels);
  const TensorTree::Node first = tree.divide(0);
  tree.divide(first);
  tree.divide(first + 5);
  const TensorTree::Node deep = tree.divide(first + static_cast<TensorTree::Node>(tree.children()) - 1);
  tree.divide(deep + 2);
  for (std::size_t cell = 0; cell < tree.cells(); ++cell)
    for (std::size_t c = 0; c < channels; ++c)
      tree.values(cell)[c] = 0.01 * static_cast<double>((cell * 7 + c * 3) % 13);
  return tree;
}

TensorTree::Point randomPoint(std::mt19937_64& engine) {
  TensorTree::Point point;
  for (std::uint32_t& x : point) x = static_cast<std::uint32_t>(engine());
  return point;
}

}  // namespace

TEST(DiskSquare, MapsTheSquaresLandmarks) {
  const double c = std::cos(kPi / 8), s = std::sin(kPi / 8), h = std::sqrt(0.5);
  const struct {
    double u, v, x, y;
  } cases[] = {{0.5, 0.5, 0, 0}, {1, 0.5, 1, 0},    {0.5, 1, 0, 1},      {0, 0.5, -1, 0},
               {0.5, 0, 0, -1},  {1, 1, h, h},      {0, 1, -h, h},       {0, 0, -h, -h},
               {1, 0, h, -h},    {1, 0.75, c, s},   {0.75, 1, s, c},     {0.25, 1, -s, c},
               {0, 0.75, -c, s}, {0, 0.25, -c, -s}, {0.75, 0.5, 0.5, 0}, {0.75, 0.75, h / 2, h / 2}};
  for (const auto& [u, v, x, y] : cases) {
    const auto disk = squareToDisk(u, v);
    EXPECT_NEAR(disk[0], x, 1e-15) << u << " " << v;
    EXPECT_NEAR(disk[1], y, 1e-15) << u << " " << v;
    const auto square = diskToSquare(x, y);
    EXPECT_NEAR(square[0], u, 1e-15) << x << " " << y;
    EXPECT_NEAR(square[1], v, 1e-15) << x << " " << y;
  }
}

TEST(DiskSquare, IsInvertedAndKeepsAreas) {
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> uniform(0.001, 0.999);
  for (int k = 0; k < 10000; ++k) {
    const double u = uniform(engine), v = uniform(engine), step = 1e-6;
    const auto disk = squareToDisk(u, v);
    const auto square = diskToSquare(disk[0], disk[1]);
    EXPECT_NEAR(square[0], u, 1e-14);
    EXPECT_NEAR(square[1], v, 1e-14);
    const double a = 2 * u - 1, b = 2 * v - 1;
    if (std::abs(std::abs(a) - std::abs(b)) < 1e-5 || std::max(std::abs(a), std::abs(b)) < 1e-3) continue;  // the seams
    const auto du0 = squareToDisk(u - step, v), du1 = squareToDisk(u + step, v);
    const auto dv0 = squareToDisk(u, v - step), dv1 = squareToDisk(u, v + step);
    const double area =
        ((du1[0] - du0[0]) * (dv1[1] - dv0[1]) - (du1[1] - du0[1]) * (dv1[0] - dv0[0])) / (4 * step * step);
    EXPECT_NEAR(area, kPi, 1e-6);
  }
}

TEST(TensorTree, ChildBitIIsTheUpperHalfOfDimensionI) {
  for (const int rank : {3, 4}) {
    TensorTree tree(rank, 1);
    const TensorTree::Node first = tree.divide(0);
    for (std::size_t c = 0; c < tree.children(); ++c)
      tree.values(tree.cell(first + static_cast<TensorTree::Node>(c)))[0] = static_cast<double>(c);
    for (unsigned c = 0; c < tree.children(); ++c) {
      TensorTree::Point point{};
      for (std::size_t i = 0; i < 4; ++i) point[i] = TensorTree::fixedPoint(c >> i & 1u ? 0.7 : 0.3);
      EXPECT_EQ(tree.values(tree.find(point))[0], c);
    }
  }
  EXPECT_EQ(TensorTree::fixedPoint(0.5), 1u << 31);
  EXPECT_EQ(TensorTree::fixedPoint(1), 0xffffffffu);
  EXPECT_EQ(TensorTree::fixedPoint(std::nan("")), 0u);
}

TEST(TensorTree, GridsHaveTheLastDimensionFastest) {
  for (const int rank : {3, 4}) {
    TensorTree tree(rank, 1);
    std::vector<double> values(std::size_t{1} << (2 * rank));  // 4 along each dimension
    std::iota(values.begin(), values.end(), 0.0);
    tree.divideIntoGrid(0, 2, values);
    EXPECT_EQ(tree.uniformDepth(0), 2);
    std::mt19937_64 engine(5);
    for (int k = 0; k < 1000; ++k) {
      const TensorTree::Point point = randomPoint(engine);
      double expected = 0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(rank); ++i) expected = 4 * expected + (point[i] >> 30);
      EXPECT_EQ(tree.values(tree.find(point))[0], expected);
    }
    const auto cells = tree.gridCells(0, 2);
    for (std::size_t k = 0; k < cells.size(); ++k) EXPECT_EQ(tree.values(cells[k])[0], static_cast<double>(k));
  }
}

TEST(TensorTree, ReversedAndMergedAreTheSameFunctions) {
  std::mt19937_64 engine(6);
  for (const int rank : {3, 4}) {
    const TensorTree tree = unevenTree(rank), mirror = tree.reversed(5);
    TensorTree coarse(rank, 2);
    coarse.divide(coarse.divide(0) + 3);
    for (std::size_t cell = 0; cell < coarse.cells(); ++cell) coarse.values(cell)[1] = static_cast<double>(cell);
    const TensorTree trees[] = {tree, coarse};
    const TensorTree both = TensorTree::merged(trees);
    EXPECT_EQ(both.channels(), 3u);
    EXPECT_EQ(both.cells(), tree.cells() + coarse.children() - 1);
    EXPECT_EQ(tree.uniformDepth(0), -1);
    for (int k = 0; k < 2000; ++k) {
      const TensorTree::Point point = randomPoint(engine);
      TensorTree::Point reversed = point;
      reversed[0] = ~reversed[0];
      reversed[2] = ~reversed[2];
      EXPECT_EQ(mirror.values(mirror.find(point))[0], tree.values(tree.find(reversed))[0]);
      const double* values = both.values(both.find(point));
      EXPECT_EQ(values[0], tree.values(tree.find(point))[0]);
      EXPECT_EQ(values[2], coarse.values(coarse.find(point))[1]);
    }
  }
}

TEST(TreeMarginal, MeansAreTheSumsOverAFineGrid) {
  for (const unsigned freeDimensions : {3u, 5u, 6u, 12u}) {
    const int rank = freeDimensions == 12 ? 4 : freeDimensions == 3 ? 4 : 3;
    const TensorTree tree = unevenTree(rank);
    std::vector<double> weights(tree.cells());
    for (std::size_t cell = 0; cell < weights.size(); ++cell) weights[cell] = tree.values(cell)[0];
    const TreeMarginal marginal(tree, freeDimensions, weights);
    std::mt19937_64 engine(8);
    for (int k = 0; k < 200; ++k) {
      TensorTree::Point point = randomPoint(engine);
      double sum = 0;
      for (std::uint32_t a = 0; a < 8; ++a)
        for (std::uint32_t b = 0; b < 8; ++b) {
          TensorTree::Point place = point;
          std::uint32_t next[] = {a, b};
          for (std::size_t i = 0, used = 0; i < static_cast<std::size_t>(rank); ++i)
            if (freeDimensions >> i & 1u) place[i] = (next[used++] << 29) + (1u << 28);
          sum += tree.values(tree.find(place))[0];
        }
      EXPECT_NEAR(marginal.mean(point), sum / 64, 1e-14);
    }
  }
}

TEST(TreeBrdf, CoordinatesAreTheTravelOfLightAndTheViewer) {
  const Direction wi = fromSpherical(radians(30), 0);
  // Rank 3: x0 = (1 - sin)/2 = 1/4; a viewer in the mirror direction, a little to one side: x1 > 1/2, x2 < 1/2.
  const auto three = treePoint(3, wi, fromSpherical(radians(30), radians(150)));
  EXPECT_NEAR(three[0] / 4294967296.0, 0.25, 1e-9);
  // Radius 1/2 at -30 degrees from the mirror direction: u = (1/2 + 1)/2, v = (-1/2 * 30/45 + 1)/2.
  EXPECT_NEAR(three[1] / 4294967296.0, 0.75, 1e-9);
  EXPECT_NEAR(three[2] / 4294967296.0, (1 - 1.0 / 3) / 2, 1e-9);
  // Turning the surface changes nothing.
  const auto turned = treePoint(3, fromSpherical(radians(30), 1), fromSpherical(radians(30), radians(150) + 1));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(turned[i] / 4294967296.0, three[i] / 4294967296.0, 1e-9);
  EXPECT_LT(treePoint(3, {0, 0, 1}, wi)[0], 1u << 31) << "the normal belongs to the half that is used";
  // Rank 4: the light's x negated, radius 1/2: u = (1 - 1/2)/2.
  const auto four = treePoint(4, wi, fromSpherical(radians(90), radians(90)));
  EXPECT_NEAR(four[0] / 4294967296.0, 0.25, 1e-9);
  EXPECT_NEAR(four[1] / 4294967296.0, 0.5, 1e-9);
  EXPECT_NEAR(four[2] / 4294967296.0, 0.5, 1e-9);
  EXPECT_NEAR(four[3] / 4294967296.0, 1, 1e-9);
}

TEST(TreeBrdf, KnowsWhetherBothSidesOfThePlaneOfIncidenceAgree) {
  TensorTree tree(3, 1);
  const TensorTree::Node first = tree.divide(0);
  for (unsigned c = 0; c < 8; ++c) tree.values(tree.cell(first + c))[0] = 0.1 * (c & 3u);
  EXPECT_EQ(TreeBrdf(tree, Channels::monochrome(), "a").symmetry(), Symmetry::Isotropic);
  tree.values(tree.cell(first + 6))[0] += 1e-6;
  EXPECT_EQ(TreeBrdf(tree, Channels::monochrome(), "a").symmetry(), Symmetry::Bilateral);
  EXPECT_EQ(TreeBrdf(unevenTree(4), Channels::monochrome(), "a").symmetry(), Symmetry::Anisotropic);
}

TEST(TreeBrdf, LargestAlbedoIsThatOfTheBrightestIncidence) {
  TensorTree tree(3, 1);
  const TensorTree::Node first = tree.divide(0);
  const TensorTree::Node near = tree.divide(first);  // x0 < 1/4 there: grazing light
  for (unsigned c = 0; c < 8; ++c) tree.values(tree.cell(near + c))[0] = c & 1u ? 0.4 : 0.8;
  for (unsigned c = 1; c < 8; ++c) tree.values(tree.cell(first + c))[0] = c & 1u ? 100 : 0.1;
  const double one[] = {1};
  // Grazing: a quarter of the outgoing square has 0.8, the rest 0.1.
  EXPECT_NEAR(TreeBrdf(tree, Channels::monochrome(), "a").largestAlbedo(one), kPi * (0.8 + 0.3) / 4, 1e-14);
}

TEST(TreeBrdf, DrawsByItsOwnValues) {
  for (const int rank : {3, 4}) {
    const TreeBrdf brdf(unevenTree(rank, 3), Channels::rgb(), "uneven");
    for (const auto& [theta, phi] : {std::pair{3.0, 40.0}, {35.0, 100.0}, {60.0, 200.0}, {85.0, 300.0}}) {
      SamplerTestOptions options;
      options.draws = 60000;
      options.cells = 300;
      const SamplerTest test = testSampler(samplerOf(brdf), fromSpherical(radians(theta), radians(phi)), options);
      EXPECT_GT(test.chiSquare.probability, sidakSignificance(0.001, 8)) << rank << " " << theta;
      EXPECT_NEAR(test.integral, 1, 5e-3) << rank << " " << theta;
      EXPECT_EQ(test.failed + static_cast<double>(test.bad + test.uncovered), 0) << rank << " " << theta;
    }
  }
}

TEST(TreeBrdf, OfRankFourIsSampledWithoutVariance) {
  // One channel: value times cosine over density is the albedo for every draw.
  const TreeBrdf brdf(unevenTree(4), Channels::monochrome(), "uneven");
  std::mt19937_64 engine(9);
  std::uniform_real_distribution<double> uniform;
  const Direction wo = fromSpherical(radians(50), radians(77));
  double albedo = 0;
  for (int k = 0; k < 1000; ++k) {
    const double u = uniform(engine), v = uniform(engine);
    Direction wi;
    brdf.sample({&wo[0], &wo[1], &wo[2]}, {&u, &v}, {&wi[0], &wi[1], &wi[2]}, 1);
    DirectionPairBuffer<double> pair;
    pair.push(wi, wo);
    double density = 0;
    brdf.pdf(pair.view(), &density);
    const double weight = brdf.evaluate(wi, wo)[0] * wi[2] / density;
    if (k == 0) albedo = weight;
    ASSERT_NEAR(weight, albedo, 1e-12);
  }
  EXPECT_GT(albedo, 0);
}

TEST(TreeAverage, LambertianIsOneCellWithItsEnergy) {
  for (const int rank : {3, 4}) {
    AverageReport report;
    const auto tree =
        averageOverTree(*parseMaterialExpression("(0.5,0.7,0.2)*Lambertian"), rank, {.levels = 3}, report);
    EXPECT_EQ(tree->tree().cells(), rank == 3 ? 8u : 1u);  // of rank 3 the half that is used has four children
    EXPECT_LT(report.error, 1e-14);
    const auto value = tree->evaluate(fromSpherical(0.3, 1), fromSpherical(1.2, 3));
    EXPECT_NEAR(value[0], 0.5 / kPi, 1e-15);
    EXPECT_NEAR(value[2], 0.2 / kPi, 1e-15);
    const double green[] = {0, 1, 0};
    EXPECT_NEAR(tree->largestAlbedo(green), 0.7, 1e-14);
    EXPECT_EQ(tree->symmetry(), rank == 3 ? Symmetry::Isotropic : Symmetry::Anisotropic);
  }
}

TEST(TreeAverage, FollowsAGlossyLobeAndPrunesWhereItIsSmooth) {
  const auto glossy = parseMaterialExpression("0.3*Lambertian + GGX(alpha=0.4)");
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> uniform;
  for (const int rank : {3, 4}) {
    AverageReport report;
    const auto fine = averageOverTree(*glossy, rank, {.levels = rank == 3 ? 6 : 4, .tolerance = 0}, report);
    EXPECT_LT(report.error, 0.2);
    EXPECT_GT(report.error, 1e-6);
    const auto pruned = averageOverTree(*glossy, rank, {.levels = rank == 3 ? 6 : 4, .tolerance = 0.05}, report);
    EXPECT_LT(pruned->tree().cells(), fine->tree().cells() / 2);
    double difference = 0, distance = 0, sum = 0;
    for (int k = 0; k < 4000; ++k) {
      const auto cosine = [&] {
        const double r = std::sqrt(0.9 * uniform(engine)), phi = 2 * kPi * uniform(engine);
        return Direction{r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - r * r)};
      };
      const Direction wi = cosine(), wo = cosine();
      const double exact = glossy->evaluate(wi, wo)[0], a = fine->evaluate(wi, wo)[0], b = pruned->evaluate(wi, wo)[0];
      EXPECT_LE(std::abs(a - b), 0.1001 * std::max(a, 1e-3)) << "no cell may leave the tolerance about its mean";
      difference += std::abs(a - exact);
      distance += std::abs(a - b);
      sum += exact;
    }
    EXPECT_LT(difference / sum, rank == 3 ? 0.03 : 0.15);
    EXPECT_LT(distance / sum, 0.05);
  }
}

TEST(TreeAverage, RefusesLevelsThatWouldFillTheMemory) {
  AverageReport report;
  const auto lambertian = parseMaterialExpression("Lambertian");
  EXPECT_THROW(averageOverTree(*lambertian, 4, {.levels = 7}, report), Error);
  EXPECT_THROW(averageOverTree(*lambertian, 3, {.levels = 9}, report), Error);
}

}  // namespace brdf
