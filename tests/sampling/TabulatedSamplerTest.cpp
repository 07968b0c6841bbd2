// Tabulated samplers draw what their density says and follow the BRDF they were made from.
#include <brdf/base/Error.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/measured/Format.h>
#include <brdf/sampling/SampledBrdf.h>
#include <brdf/sampling/SamplerChecks.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "FunctionBrdf.h"

namespace brdf {
namespace {

using Kind = TabulatedSampler::Kind;

constexpr double kAngles[] = {0, 30, 55, 75, 85};  // degrees from the normal
constexpr std::size_t kTests = 180;                // chi-square tests of all materials, kinds and angles below

BrdfPointer material(const std::string& text) { return parseMaterialExpression(text); }

/// A material and its name, for parameterized tests.
struct Case {
  const char* name;
  BrdfPointer (*make)();
  double worst;  ///< bound of the relative variance at kAngles
};

const Case kCases[] = {
    {"RoughGgx", [] { return material("GGX(alpha=0.5)"); }, 0.25},
    {"GlossyGgx", [] { return material("GGX(alpha=0.05)"); }, 0.25},
    {"SharpGgx", [] { return material("GGX(alpha=0.001)"); }, 0.25},
    {"AnisotropicGgx", [] { return material("GGX(alpha=0.05, alpha_y=0.3)"); }, 0.5},
    {"ShiftedGamma", [] { return material("SGD"); }, 0.5},
    {"OrenNayar", [] { return material("OrenNayar"); }, 0.25},
    {"DiffuseAndGlossy", [] { return material("0.3*Lambertian + 0.5*GGX(alpha=0.1)"); }, 0.25},
    {"Table", [] { return BrdfPointer(TableBrdf::tabulate(*material("CookTorrance(m=0.1)"))); }, 0.5},
    {"Retro", [] { return BrdfPointer(std::make_shared<test::FunctionBrdf>(test::retroReflector())); }, 0.25},
    {"Brushed", [] { return BrdfPointer(std::make_shared<test::FunctionBrdf>(test::brushed())); }, 0.5},
};

class TabulatedSamplerOf : public testing::TestWithParam<Case> {};

TEST_P(TabulatedSamplerOf, DrawsWhatItsDensitySaysAndFollowsItsBrdf) {
  const BrdfPointer brdf = GetParam().make();
  for (const Kind kind : {Kind::Half, Kind::HalfAndRetro, Kind::Light}) {
    const TabulatedSampler sampler(*brdf, kind);
    for (const double angle : {0.0, 30.0, 55.0, 75.0, 85.0, 89.0}) {
      const SamplerTest test = testSampler(samplerOf(sampler), fromSpherical(radians(angle), 0.7));
      const std::string where = std::string(name(kind)) + " at " + std::to_string(angle) + " degrees";
      EXPECT_GT(test.chiSquare.probability, sidakSignificance(1e-3, kTests)) << where;
      EXPECT_LT(std::fabs(test.deviation), 5) << where << ": integral " << test.integral << ", failed " << test.failed;
      EXPECT_EQ(test.bad, 0u) << where;
      EXPECT_EQ(test.uncovered, 0u) << where;
    }
  }
  const TabulatedSampler best(*brdf);
  const DirectionSampler samplers[] = {samplerOf(best), cosineSampler()};
  for (const double angle : kAngles) {
    const SamplerVariances found = relativeVariances(*brdf, fromSpherical(radians(angle), 0.7), samplers, 8192);
    EXPECT_LT(found.relativeVariance[0], GetParam().worst) << name(best.report().kind) << " at " << angle << " degrees";
  }
}

INSTANTIATE_TEST_SUITE_P(Materials, TabulatedSamplerOf, testing::ValuesIn(kCases),
                         [](const auto& one) { return one.param.name; });

TEST(TabulatedSampler, OfAGlossyLobeHasAHundredthOfTheCosinesVariance) {
  const BrdfPointer ggx = material("GGX(alpha=0.05)");
  const TabulatedSampler sampler(*ggx);
  const DirectionSampler samplers[] = {samplerOf(sampler), cosineSampler()};
  for (const double angle : {0.0, 30.0, 55.0, 75.0}) {
    const auto found = relativeVariances(*ggx, fromSpherical(radians(angle), 0.7), samplers, 8192).relativeVariance;
    EXPECT_LT(found[0], 0.25) << angle;
    EXPECT_GT(found[1], 25) << angle;
  }
}

TEST(TabulatedSampler, FindsTheKindThatSuits) {
  EXPECT_EQ(TabulatedSampler(*material("GGX(alpha=0.02)")).report().kind, Kind::Half);
  EXPECT_EQ(TabulatedSampler(test::retroReflector()).report().kind, Kind::HalfAndRetro);
}

TEST(TabulatedSampler, CostsMoreCellsForLessVariance) {
  const BrdfPointer ggx = material("GGX(alpha=0.1)");
  double lastVariance = 1e9;
  std::size_t lastCells = 0;
  for (const double tolerance : {0.5, 0.05, 0.005}) {
    SamplerOptions options;
    options.tolerance = tolerance;
    options.cosineShare = 0.01;
    const TabulatedSampler::Report report = TabulatedSampler(*ggx, options).report();
    EXPECT_LT(report.relativeVariance, lastVariance) << tolerance;
    EXPECT_GT(report.cells, lastCells) << tolerance;
    EXPECT_LT(report.relativeVariance, tolerance + 0.011) << tolerance;
    lastVariance = report.relativeVariance;
    lastCells = report.cells;
  }
}

TEST(TabulatedSampler, StaysInItsMemory) {
  SamplerOptions options;
  options.tolerance = 1e-4;
  options.maximumBytes = 200'000;
  EXPECT_LT(TabulatedSampler(test::brushed(), Kind::Half, options).report().bytes, 400'000u);
}

TEST(TabulatedSampler, OfALambertianIsTheCosine) {
  const BrdfPointer lambertian = material("0.7*Lambertian");
  const TabulatedSampler sampler(*lambertian);
  EXPECT_LT(sampler.report().relativeVariance, 1e-9);
  EXPECT_EQ(sampler.report().cells, 0u);
}

TEST(TabulatedSampler, OfBlackDrawsTheCosine) {
  const test::FunctionBrdf black([](const Direction&, const Direction&) { return 0.0; });
  const TabulatedSampler sampler(black);
  const SamplerTest test = testSampler(samplerOf(sampler), fromSpherical(0.5, 0));
  EXPECT_NEAR(test.integral, 1, 1e-3);
}

TEST(TabulatedSampler, SurvivesTheEndsOfTheRandomNumbersAndTheHorizon) {
  const TabulatedSampler sampler(test::brushed());
  const double ends[] = {0, 0x1p-53, 0.5, 1 - 0x1p-53};
  for (const double angle : {0.0, 89.9, 89.9999, 90.0, 120.0})
    for (const double u : ends)
      for (const double v : ends) {
        const Direction wo = fromSpherical(radians(angle), 0.4);
        Direction wi{};
        sampler.sample({&wo[0], &wo[1], &wo[2]}, {&u, &v}, {&wi[0], &wi[1], &wi[2]}, 1);
        const double squared = dot(wi, wi);
        EXPECT_TRUE(squared == 0 || (wi[2] > 0 && std::fabs(squared - 1) < 1e-12)) << angle << " " << u << " " << v;
        EXPECT_TRUE(wo[2] > 0 || squared == 0) << angle;
      }
}

TEST(TabulatedSampler, RefusesOptionsOutOfRange) {
  const BrdfPointer lambertian = material("Lambertian");
  for (const auto& [tolerance, share] : {std::pair{0.0, 0.05}, {std::nan(""), 0.05}, {0.05, 0.0}, {0.05, 1.5}}) {
    SamplerOptions options;
    options.tolerance = tolerance;
    options.cosineShare = share;
    EXPECT_THROW(TabulatedSampler(*lambertian, options), Error) << tolerance << " " << share;
  }
}

TEST(WithSampler, DelegatesAllButTheSampler) {
  const auto retro = std::make_shared<const test::FunctionBrdf>(test::retroReflector());
  const BrdfPointer sampled = withSampler(retro);
  ASSERT_NE(sampled, retro);
  EXPECT_EQ(withSampler(sampled), sampled);
  const Direction wi = fromSpherical(0.3, 1), wo = fromSpherical(0.5, 2);
  EXPECT_EQ(sampled->evaluate(wi, wo), retro->evaluate(wi, wo));
  EXPECT_EQ(sampled->description(), retro->description());
  EXPECT_EQ(sampled->samples(), retro->samples());
}

TEST(WithSampler, KeepsAnAnalyticSamplerThatFits) {
  const BrdfPointer ggx = material("GGX(alpha=0.1)"), lambertian = material("Lambertian");
  EXPECT_EQ(withSampler(ggx), ggx);
  EXPECT_EQ(withSampler(lambertian), lambertian);
}

TEST(WithSampler, SamplesAMeasuredMaterialWithATenthOfTheCosinesVariance) {
  const std::filesystem::path path = std::filesystem::path(BRDF_SHARED_DIR) / "data/measured/garnet_red.brdf";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const BrdfPointer sampled = withSampler(readMeasured(path).brdf);
  const double thetas[] = {radians(15), radians(40), radians(65)};
  for (const Efficiency& found : efficiency(*sampled, thetas)) {
    EXPECT_LT(found.relativeVariance, 0.3);
    EXPECT_GT(found.cosineRelativeVariance, 10 * found.relativeVariance);
    const SamplerTest test = testSampler(samplerOf(*sampled), found.wo);
    EXPECT_GT(test.chiSquare.probability, sidakSignificance(1e-3, 3));
    EXPECT_LT(std::fabs(test.deviation), 5);
  }
}

}  // namespace
}  // namespace brdf
