#include <brdf/fit/DataStart.h>
#include <brdf/fit/Fit.h>

#include <gtest/gtest.h>

#include <cmath>

#include "SyntheticTarget.h"

namespace brdf {
namespace {

/// Pairs of equal directions, so that theta_h is theta; the values have the projection D(tan theta) and nothing else.
std::optional<LobeMeasures> measuredDistribution(double (*distribution)(double slope, double alpha), double alpha) {
  DirectionPairBuffer<double> pairs;
  std::vector<double> values;
  for (int k = 0; k < 20000; ++k) {
    const double root = (k + 0.5) / 20000, theta = root * root * kPi / 2, cosine = std::cos(theta);
    pairs.push(fromSpherical(theta, 0), fromSpherical(theta, 0));
    values.push_back(distribution(std::tan(theta), alpha) / (cosine * cosine * cosine * cosine) / (cosine * cosine));
  }
  return measureLobe(pairs.view(), values.data());
}

TEST(DataStart, TheSharesOfProjectedAreaAreThoseOfTheClosedForms) {
  // Shares within a slope t: 1 - exp(-t^2 / alpha^2) of Beckmann's distribution, t^2 / (alpha^2 + t^2) of GGX (Walter
  // et al. 2007). Bins are a few hundredths of a slope wide.
  for (const double alpha : {0.01, 0.1, 0.5}) {
    const auto beckmann = measuredDistribution([](double t, double a) { return std::exp(-t * t / (a * a)); }, alpha);
    ASSERT_TRUE(beckmann);
    EXPECT_NEAR(beckmann->median, std::log(alpha * std::sqrt(std::log(2.0))), 0.05) << alpha;
    EXPECT_NEAR(beckmann->wide, std::log(alpha * std::sqrt(std::log(10.0))), 0.05) << alpha;
    const auto ggx =
        measuredDistribution([](double t, double a) { return 1 / ((a * a + t * t) * (a * a + t * t)); }, alpha);
    ASSERT_TRUE(ggx);
    EXPECT_NEAR(ggx->median, std::log(alpha), 0.05) << alpha;
    EXPECT_NEAR(ggx->wide, std::log(3 * alpha), 0.05) << alpha;
    EXPECT_NEAR(ggx->grazing, 0, 1e-12);
  }
}

TEST(DataStart, ValuesThatSayNothingHaveNoMeasures) {
  const ScatteredSamples samples = synthesize(*parseMaterialExpression("Lambertian"), 100);
  EXPECT_FALSE(measureLobe(samples.pairs.view(), std::vector<double>(100).data()));
  EXPECT_FALSE(measureLobe(samples.pairs.view(), std::vector<double>(100, -1.0).data()));
  EXPECT_FALSE(measureLobe(DirectionPairBuffer<double>().view(), nullptr));
}

TEST(DataStart, LiesNearTheTruthWhereTheDefaultsDoNot) {
  for (const double truth : {0.02, 0.08, 0.6}) {
    const std::string expression = "0.3*Lambertian + 0.5*CookTorrance(m=" + std::to_string(truth) + ", ior=1.5)";
    const ScatteredBrdf target = syntheticTarget(expression, 3000, 1e-3);
    const FitData data = FitData::read(*target.samples(), findMetric("rms"), {});
    const FitProblem problem({{findModel("Lambertian"), {}, {}, {}}, {findModel("CookTorrance"), {}, {}, {}}},
                             Symmetry::Isotropic);
    const std::vector<double> shape = shapeFromData(problem, data.subset(2000).mean(0, 1));
    EXPECT_NEAR(shape[0], std::log(truth), 0.5) << truth;
    EXPECT_EQ(shape, shapeFromData(problem, data.subset(2000).mean(0, 1)));
  }
}

TEST(DataStart, DataWithoutALobeKeepTheRequestsStart) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian", 500);
  const FitData data = FitData::read(*target.samples(), findMetric("rms"), {});
  const FitProblem problem({{findModel("Lambertian"), {}, {}, {}}, {findModel("GGX"), {}, {{"alpha", 0.37}}, {}}},
                           Symmetry::Isotropic);
  EXPECT_EQ(shapeFromData(problem, data), problem.start());
}

TEST(DataStart, SparesAFitTheScan) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*GGX(alpha=0.02, ior=1.8)", 3000);
  FitOptions options;
  options.scan = false;
  options.dataStart = true;
  const FitReport report =
      fit(target, {{findModel("Lambertian"), {}, {}, {}}, {findModel("GGX"), {}, {}, {}}}, options);
  EXPECT_LT(report.error, 1e-8 * report.zeroModel.at("rms"));
}

}  // namespace
}  // namespace brdf
