// Draws made in advance, read as brdf_draws.glsl reads them, against sums over the BRDF itself.
#include <brdf/base/Error.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/sampling/DrawnTable.h>
#include <brdf/sampling/SampledBrdf.h>
#include <brdf/sampling/ViewerDraws.h>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "FunctionBrdf.h"

namespace {

using brdf::BrdfPointer;
using brdf::Direction;
using brdf::kPi;
using brdf::ViewerDraws;

/// Radiance by the direction it comes from and the viewer's.
using Light = double (*)(const Direction& wi, const Direction& wo);

double smooth(const Direction& wi, const Direction&) { return 1 + 0.9 * std::sin(7 * wi[0] + 1) * std::cos(5 * wi[1]); }

/// A lamp of about a degree behind the viewer.
double lamp(const Direction& wi, const Direction& wo) {
  const Direction apart{wi[0] - wo[0], wi[1] - wo[1], wi[2] - wo[2]};
  return std::exp(-brdf::dot(apart, apart) / (0.02 * 0.02));
}

double weightOf(std::uint32_t word, std::size_t channel, float unit) {
  const int bits = static_cast<int>(word << (23 - 9 * channel)) >> 23;
  return bits * std::exp2(static_cast<double>(word >> 27) - 31) * double(unit);
}

/// Light reflected to a viewer at `theta` by the draws of one set: `rgb` as in ViewerDraws::words.
std::array<double, 3> reflected(const ViewerDraws& draws, double theta, bool rgb, std::size_t set,
                                Light light = smooth) {
  const double last = ViewerDraws::kViewers - 1, place = (1 - std::sqrt(1 - theta / (kPi / 2))) * last;
  const auto lower = static_cast<std::size_t>(place);
  std::array<double, 3> sum{};
  for (std::size_t t = lower; t <= lower + 1; ++t) {
    const double left = 1 - double(t) / last, turn = theta - kPi / 2 * (1 - left * left);
    const double near = t == lower ? double(lower + 1) - place : place - double(lower);
    for (std::size_t i = 0; i < draws.samples; ++i) {
      const std::uint32_t* word = draws.words.data() + 4 * ((t * draws.sets + set) * draws.stride + i);
      const double x = double(std::bit_cast<float>(word[0])), y = double(std::bit_cast<float>(word[1]));
      const bool turns = std::bit_cast<float>(word[3]) < 0;
      const double c = turns ? std::cos(turn) : 1, s = turns ? std::sin(turn) : 0;
      const Direction h = brdf::normalized({c * x + s, y, c - s * x}), wo = brdf::fromSpherical(theta, 0.0);
      const double twice = 2 * brdf::dot(h, wo);
      const Direction wi{twice * h[0] - wo[0], twice * h[1] - wo[1], twice * h[2] - wo[2]};
      if (wi[2] <= 0) continue;
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] += near * light(wi, wo) / double(draws.samples) *
                  (rgb ? weightOf(word[2], k, draws.unit) : double(std::bit_cast<float>(word[2])));
    }
  }
  return sum;
}

/// The same by a sum over the hemisphere, finer toward the mirror direction, the viewer and the normal.
std::array<double, 3> summed(const brdf::Brdf& brdf, double theta, Light light = smooth) {
  const std::size_t channels = brdf.channels().count();
  const Direction wo = brdf::fromSpherical(theta, 0.0);
  // Polar charts about the three poles, each direction with the share that its pole has in 1 / distance^4.
  const Direction poles[] = {brdf::fromSpherical(theta, kPi), wo, {0, 0, 1}};
  std::array<double, 3> sum{};
  constexpr std::size_t rings = 400, spokes = 180;
  brdf::DirectionPairBuffer<double> pairs;
  std::vector<double> weights;
  for (const Direction& pole : poles) {
    const Direction across =
        std::abs(pole[1]) < 0.9 ? brdf::normalized(brdf::cross(pole, {0, 1, 0})) : Direction{1, 0, 0};
    const Direction third = brdf::cross(pole, across);
    for (std::size_t r = 0; r < rings; ++r) {
      // Angles grow as the third power of the ring's number.
      const double t = (double(r) + 0.5) / rings, angle = kPi * t * t * t, width = 3 * kPi * t * t / rings;
      for (std::size_t k = 0; k < spokes; ++k) {
        const double phi = 2 * kPi * (double(k) + 0.5) / spokes, s = std::sin(angle);
        Direction wi;
        for (std::size_t axis = 0; axis < 3; ++axis)
          wi[axis] = std::cos(angle) * pole[axis] + s * (std::cos(phi) * across[axis] + std::sin(phi) * third[axis]);
        if (wi[2] <= 0) continue;
        double own = 0, all = 0;
        for (const Direction& other : poles) {
          const double distance = std::max(1e-9, 1 - brdf::dot(wi, other));
          all += 1 / (distance * distance);
          if (&other == &pole) own = 1 / (distance * distance);
        }
        pairs.wi[0].push_back(wi[0]), pairs.wi[1].push_back(wi[1]), pairs.wi[2].push_back(wi[2]);
        pairs.wo[0].push_back(wo[0]), pairs.wo[1].push_back(wo[1]), pairs.wo[2].push_back(wo[2]);
        weights.push_back(own / all * s * width * 2 * kPi / spokes * wi[2] * light(wi, wo));
      }
    }
  }
  std::vector<double> values(channels * pairs.size());
  brdf.evaluateParallel(pairs.view(), values.data(), nullptr);
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weights[i] * values[(channels == 1 ? 0 : c) * weights.size() + i];
  return sum;
}

/// Half way between two tabulated viewers, where interpolation is worst.
double between(std::size_t t) {
  const double left = 1 - (double(t) + 0.5) / (ViewerDraws::kViewers - 1);
  return kPi / 2 * (1 - left * left);
}

void expectTheSums(const brdf::Brdf& brdf, double tolerance, const std::string& what, Light light = smooth) {
  const ViewerDraws draws = brdf::viewerDraws(brdf, 16381, 1);  // a prime: the last texels of a set are filled up
  ASSERT_EQ(draws.stride, 16384u);
  ASSERT_EQ(draws.words.size(), 4 * draws.stride * ViewerDraws::kViewers);
  double worst = 0;
  for (const std::size_t t : {3, 20, 41, 60, 75, 90, 105, 118}) {
    const auto expected = summed(brdf, between(t), light);
    const auto found = reflected(draws, between(t), brdf.channels().count() == 3, 0, light);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(found[c], expected[c], tolerance * expected[1]) << what << ", viewer " << t;
      worst = std::max(worst, std::abs(found[c] / expected[c] - 1));
    }
  }
  testing::Test::RecordProperty(what, std::to_string(worst));
}

}  // namespace

TEST(ViewerDraws, ReflectBetweenTheTabulatedViewersWhatTheBrdfDoes) {
  for (const char* text :
       {"GGX(alpha=0.2)", "GGX(alpha=0.5, ior=5)", "GGXConductor(alpha=0.05)", "OrenNayar(sigma=0.5)", "SheenCharlie",
        "Phong(n=200)", "Lafortune(Cx=0.6, Cy=0.6, Cz=0.6, n=20)", "BlinnPhong(n=50)"})
    expectTheSums(*brdf::parseMaterialExpression(text), 2e-3, text);
}

TEST(ViewerDraws, OfTablesReflectTheGridLessItsBase) {
  const auto lobes = brdf::parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + (0.5,0.4,0.3)*GGX(alpha=0.15)");
  const brdf::DrawnTable table = brdf::drawnTable(brdf::TableBrdf::tabulate(*lobes));
  expectTheSums(*brdf::aboveBase(table), 1.5e-3, "table");
}

TEST(ViewerDraws, TurnWithTheViewerWhereLightGoesBack) {
  // Within 1.7 degrees of the viewer: half vectors that stayed where they are would smear it between two viewers.
  const auto retro = std::make_shared<const brdf::test::FunctionBrdf>(brdf::test::retroReflector());
  expectTheSums(brdf::SampledBrdf(retro, brdf::TabulatedSampler(*retro)), 8e-3, "retro-reflector", lamp);
}

TEST(ViewerDraws, SetsDifferAndEachCoversTheLobe) {
  const auto lobe = brdf::parseMaterialExpression("GGX(alpha=0.2)");
  const ViewerDraws draws = brdf::viewerDraws(*lobe, 100, 6);
  EXPECT_EQ(draws.stride, 100u);
  const double theta = between(50), expected = summed(*lobe, theta)[0];
  for (std::size_t set = 0; set < 6; ++set) {
    // A hundred random draws would be off by 7 %.
    EXPECT_NEAR(reflected(draws, theta, false, set)[0], expected, 0.04 * expected) << set;
    EXPECT_NE(draws.words[4 * set * 100], draws.words[4 * ((set + 1) % 6) * 100]);
  }
}

TEST(ViewerDraws, HoldNothingForABlackBrdf) {
  const auto black =
      std::make_shared<const brdf::test::FunctionBrdf>([](const Direction&, const Direction&) { return 0.0; });
  const ViewerDraws draws = brdf::viewerDraws(*black, 5, 1);
  EXPECT_EQ(draws.stride, 8u);
  EXPECT_EQ(reflected(draws, 0.5, false, 0)[0], 0);
}

TEST(ViewerDraws, RefuseWhatMayNotBeTurnedAndSpectra) {
  EXPECT_THROW(brdf::viewerDraws(brdf::test::brushed(), 8, 1), brdf::Error);
  const auto spectral = brdf::parseMaterialExpression("GGX(alpha=0.2)", brdf::Channels::spectral({400, 500, 600, 700}));
  EXPECT_THROW(brdf::viewerDraws(*spectral, 8, 1), brdf::Error);
}
