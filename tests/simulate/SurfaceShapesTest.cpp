#include "../TestFolder.h"
#include "SurfaceSupport.h"

#include <brdf/geometry/Directions.h>
#include <brdf/io/ImageFile.h>
#include <brdf/simulate/HeightStatistics.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace brdf {
namespace {

TiledMesh mesh(std::string_view expression) { return std::get<TiledMesh>(makeSurface(expression).surface.shape); }
SpherePacking packing(std::string_view expression) {
  return std::get<SpherePacking>(makeSurface(expression).surface.shape);
}

/// Heights of the triangles that face up and hold (x, y), over all copies of the tile.
std::vector<double> heightsAt(const TiledMesh& mesh, double x, double y) {
  std::vector<double> found;
  for (int v = -6; v <= 6; ++v)
    for (int u = -6; u <= 6; ++u) {
      const double px = x + u * mesh.periodX, py = y + v * mesh.periodY;
      for (const auto& t : mesh.triangles) {
        const auto &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        const double area =
            (double{b[0]} - a[0]) * (double{c[1]} - a[1]) - (double{b[1]} - a[1]) * (double{c[0]} - a[0]);
        if (area <= 1e-9) continue;
        const double s = ((px - a[0]) * (double{c[1]} - a[1]) - (py - a[1]) * (double{c[0]} - a[0])) / area;
        const double r = ((double{b[0]} - a[0]) * (py - a[1]) - (double{b[1]} - a[1]) * (px - a[0])) / area;
        if (s < 0 || r < 0 || s + r > 1) continue;
        found.push_back(a[2] + s * (double{b[2]} - a[2]) + r * (double{c[2]} - a[2]));
      }
    }
  return found;
}

TEST(Gratings, CoverThePlaneOnceWithTheirSectionInAnyDirection) {
  for (const double azimuth : {0.0, 90.0, 180.0, -90.0, 30.0, 123.0, -55.0, 211.0}) {
    SCOPED_TRACE(azimuth);
    const std::string orientation = ", orientation=" + std::to_string(azimuth + 90) + ")";
    const TiledMesh lamellar = mesh("lamellar(pitch=10, depth=2, duty=0.3" + orientation);
    const TiledMesh blazed = mesh("blazed(pitch=10, blaze=20, back=70" + orientation);
    const double ax = std::cos(radians(azimuth)), ay = std::sin(radians(azimuth));
    const double up = std::tan(radians(20)), down = std::tan(radians(70)), peak = 10 * down / (up + down);
    for (int k = 0; k < 60; ++k) {
      const double x = 0.618 * k - 7.1, y = 0.381 * k - 3.3;
      const double phase = x * ax + y * ay, s = phase - 10 * std::floor(phase / 10);
      if (std::abs(std::abs(std::remainder(phase, 10)) - 1.5) < 1e-3 || std::abs(s - peak) < 1e-3) continue;
      const auto flat = heightsAt(lamellar, x, y);
      ASSERT_EQ(flat.size(), 1u) << k;
      EXPECT_NEAR(flat[0], std::abs(std::remainder(phase, 10)) < 1.5 ? 0 : -2, 1e-5);
      const auto tooth = heightsAt(blazed, x, y);
      ASSERT_EQ(tooth.size(), 1u) << k;
      EXPECT_NEAR(tooth[0], s < peak ? s * up : (10 - s) * down, 1e-4);
    }
    // The walls are vertical, and face along and against the direction across the lines.
    std::set<int> faces;
    for (const auto& t : lamellar.triangles) {
      const auto &a = lamellar.points[t[0]], &b = lamellar.points[t[1]], &c = lamellar.points[t[2]];
      const Direction n = normalized(cross({double{b[0]} - a[0], double{b[1]} - a[1], double{b[2]} - a[2]},
                                           {double{c[0]} - a[0], double{c[1]} - a[1], double{c[2]} - a[2]}));
      const double across = n[0] * ax + n[1] * ay;
      EXPECT_NEAR(std::abs(across) + n[2], 1, 1e-5);
      faces.insert(static_cast<int>(std::lround(across)));
    }
    EXPECT_EQ(faces, (std::set<int>{-1, 0, 1}));
  }
}

TEST(Gratings, BlazedWithAVerticalBackHasThePitchUnderItsFacet) {
  EXPECT_NEAR(factOf(makeSurface("blazed(pitch=10, blaze=30)"), "height"), 10 * std::tan(radians(30)), 1e-12);
}

TEST(Gratings, SinusoidIsOneInAnyDirection) {
  for (const double azimuth : {0.0, 90.0, 37.0, -120.0}) {
    const HeightField field =
        heightField("sinusoidal(pitch=10, depth=2, orientation=" + std::to_string(azimuth + 90) + ")");
    const double ax = std::cos(radians(azimuth)), ay = std::sin(radians(azimuth));
    for (std::size_t j = 0; j < field.rows; j += 7)
      for (std::size_t i = 0; i < field.columns; i += 11) {
        const double s = static_cast<double>(i) * field.spacingX * ax + static_cast<double>(j) * field.spacingY * ay;
        EXPECT_NEAR(field.height(i, j), std::cos(2 * kPi * s / 10), 1e-6) << azimuth;
      }
  }
}

TEST(Scratches, CutAsMuchAsTheCoverageSays) {
  // Uniform places: a Boolean model, whose share is 1 - exp(-coverage) on average.
  std::vector<double> shares;
  for (int seed = 0; seed < 24; ++seed)
    shares.push_back(
        factOf(makeSurface("scratched(coverage=0.7, length=6, width=1, width_spread=0.4, period=60, ridge=0, "
                           "spacing=0.1, seed=" +
                           std::to_string(seed) + ")"),
               "share of the surface that is cut"));
  EXPECT_LT(std::abs(deviation(shares, 1 - std::exp(-0.7))), 4);
}

TEST(Scratches, OneHasTheSectionOfItsParameters) {
  // One scratch along y of width 4 and wall slope 30 degrees: cut as area / tile says.
  const double area = 40 * 4 + kPi * 4, coverage = area / 10000;
  const HeightField field = heightField("scratched(coverage=" + std::to_string(coverage) +
                                        ", length=40, width=4, width_spread=0, slope=30, ridge=0.5, orientation=90, "
                                        "spread=0, period=100, spacing=0.1)");
  const double slope = std::tan(radians(30)), step = field.spacingX;
  // The row through its middle: the deepest node's.
  const auto deepest = std::ranges::min_element(field.heights) - field.heights.begin();
  const std::size_t row = static_cast<std::size_t>(deepest) / field.columns;
  std::size_t cut = 0, raised = 0;
  double highest = 0, lowest = 0;
  for (std::size_t i = 0; i < field.columns; ++i) {
    const double a = field.height(i, row), b = field.height((i + 1) % field.columns, row);
    lowest = std::min(lowest, a);
    highest = std::max(highest, a);
    cut += a < 0;
    raised += a > 0;
    if (a < -slope * step && b < a) {
      EXPECT_NEAR(a - b, slope * step, 2e-5 + (b <= lowest ? slope * step : 0));
    }
  }
  EXPECT_NEAR(static_cast<double>(cut) * step, 4, 0.11);
  EXPECT_NEAR(static_cast<double>(raised) * step, 4, 0.21);  // two ridges of half the width
  EXPECT_NEAR(lowest, -2 * slope, slope * step);
  EXPECT_NEAR(highest, 0.5 * 2 * slope, 0.5 * 2 * slope * step);
  const HeightStatistics statistics = statisticsOf(field);
  EXPECT_LT(statistics.rmsSlopeY, 0.3 * statistics.rmsSlopeX);  // only its round ends slope along it
}

TEST(Scratches, RefuseWhatWouldNeverEnd) {
  EXPECT_NE(surfaceError("scratched(period=1e6)").find("too many nodes"), std::string::npos);
  EXPECT_NE(surfaceError("scratched(length=1e6, coverage=100, width=4, period=2000)").find("too much to cut"),
            std::string::npos);
  EXPECT_NE(
      surfaceError("scratched(length=0, width=0.01, coverage=100, period=50, spacing=1)").find("too many scratches"),
      std::string::npos);
}

TEST(Triangles, HaveTheDistributionsOfTheOriginal) {
  const HeightField radical = heightField("triangles(grid=4, scale=2, distribution=radical_inverse)");
  const std::vector<float> expected{0, 1, 0.5F, 1.5F, 0.25F, 1.25F, 0.75F, 1.75F};
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), radical.heights.begin()));
  EXPECT_EQ(statisticsOf(heightField("triangles(distribution=flat)")).rms, 0);
  const HeightStatistics uniform = statisticsOf(heightField("triangles(grid=200, scale=3, distribution=random)"));
  EXPECT_NEAR(uniform.mean, 1.5, 4 * 3 / std::sqrt(12.0) / 200);
  EXPECT_NEAR(uniform.rms, 3 / std::sqrt(12.0), 0.02);
  EXPECT_GE(uniform.lowest, 0);
  EXPECT_LE(uniform.highest, 3);
  const HeightStatistics gaussian = statisticsOf(heightField("triangles(grid=200, scale=3)"));
  EXPECT_NEAR(gaussian.mean, 0, 4 * 3.0 / 200);
  EXPECT_NEAR(gaussian.rms, 3, 4 * 3 / std::sqrt(2.0) / 200);
}

TEST(HeightFieldOfAPicture, IsUprightAndScaled) {
  const auto path = testFolder("heights") / "heights.exr";
  Image image(3, 2, 1);
  image.values = {10, 20, 30, 1, 2, 3};  // rows from the top
  writeExr(image, path);
  const std::string file = "heightfield(file=\"" + path.string() + "\"";
  const HeightField field = heightField(file + ", depth=0.5, spacing=2)");
  EXPECT_EQ(field.columns, 3u);
  EXPECT_EQ(field.spacingY, 2);
  EXPECT_EQ(field.heights, (std::vector<float>{0.5F, 1, 1.5F, 5, 10, 15}));
  EXPECT_EQ(heightField(file + ", depth=-1)").height(2, 1), -30);
  const HeightField mirrored = heightField(file + ", edges=mirrored)");
  EXPECT_EQ(mirrored.columns, 6u);
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(mirrored.height(i, j), mirrored.height(5 - i, 3 - j));
  EXPECT_NE(surfaceError(file + ", channel=alpha)").find("no alpha"), std::string::npos);
  EXPECT_NE(surfaceError("heightfield(file=missing.exr)").find("missing.exr"), std::string::npos);
  Image colour(2, 2, 3);
  colour.values = {1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3};
  SurfaceReaders readers;
  readers.picture = [&](const std::filesystem::path&) { return colour; };
  EXPECT_EQ(
      std::get<HeightField>(makeSurface("heightfield(file=x.png, channel=blue)", readers).surface.shape).heights[0], 3);
  EXPECT_NEAR(std::get<HeightField>(makeSurface("heightfield(file=x.png)", readers).surface.shape).heights[0],
              0.2126 + 2 * 0.7152 + 3 * 0.0722, 1e-6);
}

TEST(MeshOfAFile, IsScaledTurnedAndTiled) {
  SurfaceReaders readers;
  readers.mesh = [](const std::filesystem::path&) {
    return TiledMesh{{{0, 0, 0}, {2, 0, -3}, {0, 1, -3}}, {{0, 1, 2}}, {}, 0, 0};
  };
  const auto make = [&](const char* expression) {
    return std::get<TiledMesh>(makeSurface(expression, readers).surface.shape);
  };
  EXPECT_EQ(make("mesh(file=a.ply, scale=10)").periodX, 20);
  EXPECT_EQ(make("mesh(file=a.ply, scale=10)").periodY, 10);
  EXPECT_EQ(make("mesh(file=a.ply, period_x=7)").periodX, 7);
  const TiledMesh turned = make("mesh(file=a.ply, up=y)");
  EXPECT_EQ(turned.points[1], (std::array<float, 3>{2, 3, 0}));
  EXPECT_EQ(turned.points[2], (std::array<float, 3>{0, 3, 1}));
  EXPECT_EQ(turned.periodY, 3);
  EXPECT_NE(surfaceError("mesh(file=a.ply)").find("no reader"), std::string::npos);
  EXPECT_NE(surfaceError("mesh").find("file: must be given"), std::string::npos);
}

TEST(Spheres, DoNotOverlapAcrossTheEdgesEither) {
  for (const char* expression :
       {"spheres(count=150, radius=0.5, period=16)",
        "spheres(count=300, radius=0.6, spread=0.4, distribution=lognormal, period=12, height=9)",
        "spheres(count=9, radius=1, period=3, height=30, spread=0.3, distribution=uniform)"}) {
    SCOPED_TRACE(expression);
    const MadeSurface made = makeSurface(expression);
    const auto& p = std::get<SpherePacking>(made.surface.shape);
    EXPECT_EQ(factOf(made, "spheres placed"), static_cast<double>(p.spheres.size()));
    ASSERT_GT(p.spheres.size(), 5u);
    for (std::size_t a = 0; a < p.spheres.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        for (int u = -1; u <= 1; ++u)
          for (int v = -1; v <= 1; ++v) {
            const auto &s = p.spheres[a], &t = p.spheres[b];
            const double d = std::hypot(s.centre[0] - t.centre[0] + u * p.periodX,
                                        s.centre[1] - t.centre[1] + v * p.periodY, s.centre[2] - t.centre[2]);
            EXPECT_GT(d, double{s.radius} + double{t.radius} - 1e-5) << a << "," << b;
          }
  }
}

TEST(Spheres, FillTheirLayerAndRestOnItsBottom) {
  for (const auto& s : packing("spheres(count=200, radius=0.3, bottom=-6, height=4, overlap=yes)").spheres) {
    EXPECT_GE(s.centre[2] - s.radius, -6 - 1e-5);
    EXPECT_LE(s.centre[2] + s.radius, -2 + 1e-5);
  }
  for (const auto& s : packing("spheres(count=50, distribution=lognormal, bottom=1)").spheres)
    EXPECT_NEAR(s.centre[2] - s.radius, 1, 1e-6);
}

TEST(Spheres, RadiiHaveTheirDistribution) {
  std::vector<double> logs, squares, uniform;
  for (const auto& s :
       packing("spheres(count=4000, radius=0.2, spread=0.4, distribution=lognormal, overlap=yes, period=100)")
           .spheres) {
    logs.push_back(std::log(s.radius / 0.2));
    squares.push_back(logs.back() * logs.back());
  }
  EXPECT_LT(std::abs(deviation(logs, 0)), 4);
  EXPECT_LT(std::abs(deviation(squares, 0.16)), 4);
  for (const auto& s :
       packing("spheres(count=4000, radius=0.2, spread=0.5, distribution=uniform, overlap=yes, period=100)").spheres) {
    EXPECT_GE(s.radius, 0.1F - 1e-7F);
    EXPECT_LE(s.radius, 0.3F + 1e-7F);
    uniform.push_back((s.radius - 0.2) * (s.radius - 0.2));
  }
  EXPECT_LT(std::abs(deviation(uniform, 0.01 / 3)), 4);
}

TEST(Spheres, ThoseWithoutAPlaceAreCounted) {
  const MadeSurface made = makeSurface("spheres(count=1000, radius=1, period=20)");
  const double placed = factOf(made, "spheres placed");
  EXPECT_EQ(placed + factOf(made, "spheres that found no place"), 1000);
  // Random sequential addition of discs jams at a covered share of 0.547 (Feder 1980,
  // doi:10.1016/0022-5193(80)90358-6).
  EXPECT_LT(placed * kPi / 400, 0.60);
  EXPECT_GT(placed * kPi / 400, 0.45);
  EXPECT_EQ(packing("spheres(count=0)").spheres.size(), 0u);
  EXPECT_FALSE(packing("spheres(substrate=no)").substrate);
  EXPECT_EQ(makeSurface("spheres").surface.facets.size(), 2u);
  EXPECT_NE(surfaceError("spheres(radius=11)").find("wider than the tile"), std::string::npos);
  EXPECT_NE(surfaceError("spheres(radius=1, height=1.5)").find("higher than the layer"), std::string::npos);
}

}  // namespace
}  // namespace brdf
