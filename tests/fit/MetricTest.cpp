#include <brdf/base/Error.h>
#include <brdf/fit/Fit.h>
#include <brdf/fit/FitData.h>
#include <brdf/fit/Metric.h>
#include <brdf/material/GridBrdf.h>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

#include "SyntheticTarget.h"

namespace brdf {
namespace {

/// One pair with this cosine of theta_i, the viewer at 30 degrees.
DirectionPairBuffer<double> pairWith(double cosine) {
  DirectionPairBuffer<double> pairs;
  pairs.push({std::sqrt(1 - cosine * cosine), 0, cosine}, fromSpherical(radians(30), 1));
  return pairs;
}

/// The residual of f against the target value t.
double residual(const Metric& metric, double f, double t, double cosine) {
  const DirectionPairBuffer<double> pairs = pairWith(cosine);
  double target = 0, r = 0;
  metric.prepare(&t, pairs.view(), &target);
  metric.residual(&f, &target, pairs.view(), &r);
  return r;
}

double slope(const Metric& metric, double f, double t, double cosine) {
  const DirectionPairBuffer<double> pairs = pairWith(cosine);
  double target = 0, s = 0;
  metric.prepare(&t, pairs.view(), &target);
  metric.slope(&f, &target, pairs.view(), &s);
  return s;
}

/// All metrics ready for use, with some that have arguments.
std::vector<MetricPointer> usableMetrics() {
  std::vector<MetricPointer> metrics = allMetrics();
  for (const char* text : {"relative:0.5", "huber:0.3", "formula:cbrt(f*cos_i)", "formula:f*cos_i*cos_o",
                           "formula:(f - t)/sqrt(sqr(t) + 0.01)"})
    metrics.push_back(findMetric(text));
  for (MetricPointer& metric : metrics)
    if (metric->needsScale()) metric = metric->scaledTo(0.1);
  return metrics;
}

TEST(Metric, NamesHoldTheContractOfTheCommandLine) {
  const std::vector<std::string> names = metricNames();
  for (const char* name : {"rms", "rms_cos", "log", "cuberoot"}) EXPECT_TRUE(std::ranges::count(names, name)) << name;
  EXPECT_EQ(names.front(), "rms");
}

TEST(Metric, ResidualsAreThoseOfTheCommandLineContract) {
  EXPECT_DOUBLE_EQ(residual(*findMetric("rms"), 3, 1, 0.5), 2);
  EXPECT_DOUBLE_EQ(residual(*findMetric("rms_cos"), 3, 1, 0.5), 1);
  EXPECT_DOUBLE_EQ(residual(*findMetric("log"), 3, 0, 0.5), std::log(2.5));
  EXPECT_DOUBLE_EQ(residual(*findMetric("cuberoot"), 16, 2, 0.5), 1);
  EXPECT_DOUBLE_EQ(residual(*findMetric("cuberoot"), -16, 0, 0.5), -2);
}

TEST(Metric, ResidualsAreThoseOfTheirFormulas) {
  EXPECT_DOUBLE_EQ(residual(*findMetric("ngan"), 3, 1, 0.5), 1);
  EXPECT_DOUBLE_EQ(residual(*findMetric("relative"), 3, 2, 0.5), 0.5);
  EXPECT_DOUBLE_EQ(residual(*findMetric("relative:4"), 3, -2, 0.5), 1.25);
  // Huber's function: d^2/2 up to delta, then delta |d| - delta^2/2; r^2 is twice that.
  const MetricPointer huber = findMetric("huber:0.5");
  EXPECT_DOUBLE_EQ(residual(*huber, 1.25, 1, 0.5), 0.25);
  EXPECT_NEAR(residual(*huber, 1, 4, 0.5), -std::sqrt(2 * (0.5 * 3 - 0.125)), 1e-15);
  EXPECT_NEAR(residual(*findMetric("formula:cbrt(f*cos_i)"), 16, 2, 0.5), 1, 1e-14);
  EXPECT_NEAR(residual(*findMetric("formula:sqr(f - t)*cos_o"), 3, 1, 0.5), 4 * std::cos(radians(30)), 1e-14);
}

TEST(Metric, SlopesAgreeWithDifferencesAndTargetsComeBack) {
  for (const MetricPointer& metric : usableMetrics())
    for (const double f : {1e-3, 0.04, 1.0, 250.0})
      for (const double t : {2e-3, 0.05, 300.0})
        for (const double cosine : {0.05, 0.5, 1.0}) {
          const double step = 1e-5 * f;
          const double difference =
              (residual(*metric, f + step, t, cosine) - residual(*metric, f - step, t, cosine)) / (2 * step);
          const double rounding = 1e-15 * std::abs(residual(*metric, f, t, cosine)) / step;
          EXPECT_NEAR(slope(*metric, f, t, cosine), difference, 1e-8 * std::abs(difference) + rounding)
              << metric->name() << " at " << f;
          const DirectionPairBuffer<double> pairs = pairWith(cosine);
          double target = 0, back = 0;
          metric->prepare(&t, pairs.view(), &target);
          metric->restore(&target, pairs.view(), &back);
          EXPECT_NEAR(back, t, 1e-13 * t) << metric->name();
          EXPECT_NEAR(residual(*metric, t, t, cosine), 0, 1e-16 * (1 + t)) << metric->name();
        }
}

TEST(Metric, QuadraticOnesHaveSlopesThatDoNotDependOnTheValue) {
  for (const MetricPointer& metric : usableMetrics()) {
    const double low = slope(*metric, 0.01, 0.2, 0.7), high = slope(*metric, 5, 0.2, 0.7);
    if (metric->quadratic()) {
      EXPECT_EQ(low, high) << metric->name();
      EXPECT_NEAR(residual(*metric, 5, 0.2, 0.7), low * 4.8, 1e-13) << metric->name();
    } else if (metric->name() != "formula:(f - t)/sqrt(sqr(t) + 0.01)") {  // with t it is not taken for one
      EXPECT_NE(low, high) << metric->name();
    }
  }
}

TEST(Metric, EverythingIsFiniteForEveryFiniteValue) {
  for (const MetricPointer& metric : usableMetrics())
    for (const double f : {-1e6, -1.0, -1e-300, 0.0, 1e-300, 1e12})
      for (const double t : {-1.0, 0.0, 1e-300, 1e12})
        EXPECT_TRUE(std::isfinite(slope(*metric, f, t, 1e-9)) && std::isfinite(residual(*metric, f, t, 1e-9)))
            << metric->name() << " at " << f << ", " << t;
}

TEST(Metric, UnknownNamesAndUnusableArgumentsAreErrors) {
  const auto refusal = [](const char* text) {
    try {
      findMetric(text);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(refusal("l7").find("rms, rms_cos, log, cuberoot"), std::string::npos);
  EXPECT_NE(refusal("huber:-1").find("above 0"), std::string::npos);
  EXPECT_NE(refusal("relative:much").find("above 0"), std::string::npos);
  EXPECT_NE(refusal("formula:f*coz_i").find("cos_i"), std::string::npos);
  EXPECT_NE(refusal("formula:cos_i").find("does not use f"), std::string::npos);
  EXPECT_NE(refusal("formula:f*random1").find("random"), std::string::npos);
}

TEST(Metric, AFormulaThatHasNoValueAtASampleIsRefusedThere) {
  const ScatteredBrdf black = syntheticTarget("0*Lambertian", 20);
  EXPECT_THROW(FitData::read(*black.samples(), findMetric("formula:log(f)"), {}), Error);
}

TEST(Metric, FormulasFitAsTheMetricsTheySpellOut) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*CookTorrance(m=0.2, ior=1.5)", 500, 1e-3);
  const std::vector<LobeRequest> lobes = {{findModel("Lambertian"), {}, {}, {}}, {findModel("GGX"), {}, {}, {}}};
  for (const auto& [own, spelled] : std::vector<std::pair<std::string, std::string>>{
           {"rms_cos", "formula:f*cos_i"}, {"log", "formula:log1p(f*cos_i)"}}) {
    FitOptions options;
    options.tolerance = 1e-12;
    options.metric = own;
    const FitReport expected = fit(target, lobes, options);
    options.metric = spelled;
    const FitReport found = fit(target, lobes, options);
    EXPECT_EQ(found.strategy, expected.strategy);
    EXPECT_NEAR(found.error, expected.error, 1e-9 * expected.error) << own;
    EXPECT_NEAR(found.metrics.at(own), expected.error, 1e-9 * expected.error);
  }
}

/// Weighted means by Eigen: the best constant is one column of ones.
double bestConstant(const std::vector<double>& values, const std::vector<double>& weights) {
  const Eigen::Map<const Eigen::VectorXd> w(weights.data(), static_cast<Eigen::Index>(weights.size()));
  const Eigen::Map<const Eigen::VectorXd> v(values.data(), static_cast<Eigen::Index>(values.size()));
  const Eigen::VectorXd root = w.cwiseSqrt();
  return root.colPivHouseholderQr().solve(root.cwiseProduct(v))[0];
}

TEST(Metric, RelativeFitsAreWeightedLeastSquares) {
  const ScatteredBrdf target = syntheticTarget("0.1*Lambertian + 0.5*GGX(alpha=0.3, ior=1.5)", 300);
  std::vector<double> values(300), weights(300);
  target.samples()->read(0, 300, nullptr, values.data(), nullptr);
  for (std::size_t i = 0; i < 300; ++i) weights[i] = 1 / std::pow(std::max(values[i], 1e-3), 2);
  FitOptions options;
  options.metric = "relative";
  const FitReport report = fit(target, {{findModel("Lambertian"), {}, {}, {}}}, options);
  EXPECT_NEAR(report.parameters[0].value, kPi * bestConstant(values, weights), 1e-10);
}

TEST(Metric, HuberFitsFindTheMinimumThatBruteForceFindsAndPassOutliersBy) {
  ScatteredSamples samples = synthesize(*parseMaterialExpression("0.5*Lambertian"), 400, 0.002);
  for (std::size_t i = 0; i < 400; i += 20) samples.values[i] = 5;
  const std::vector<double> values = samples.values;
  const ScatteredBrdf target(std::move(samples), "with outliers");
  const auto cost = [&](double constant) {
    double sum = 0;
    for (const double value : values) {
      const double d = std::abs(constant - value), delta = 0.01;
      sum += d <= delta ? d * d / 2 : delta * d - delta * delta / 2;
    }
    return sum;
  };
  double best = 0;
  for (double constant = 0.1; constant < 0.6; constant += 1e-5)
    if (cost(constant) < cost(best)) best = constant;
  FitOptions options;
  options.metric = "huber:0.01";
  options.tolerance = 1e-12;
  const FitReport report = fit(target, {{findModel("Lambertian"), {}, {}, {}}}, options);
  EXPECT_NEAR(report.parameters[0].value / kPi, best, 2e-5);
  EXPECT_NEAR(report.parameters[0].value, 0.5, 0.01);
  EXPECT_NEAR(report.error, std::sqrt(2 * cost(report.parameters[0].value / kPi) / 400), 1e-9);
  // Its default scale is the median of the data: here the diffuse level.
  options.metric = "huber";
  EXPECT_LT(std::abs(fit(target, {{findModel("Lambertian"), {}, {}, {}}}, options).parameters[0].value - 0.5), 0.05);
  options.metric = "rms";
  EXPECT_GT(fit(target, {{findModel("Lambertian"), {}, {}, {}}}, options).parameters[0].value, 1);
}

/// Node-centred grid of theta_i x theta_o: cells halfway between the nodes.
std::shared_ptr<const GridBrdf> thetaGrid() {
  GridLayout layout;
  layout.axes = {GridAxis::listedDegrees(AxisQuantity::ThetaI, {0, 20, 50, 70}),
                 GridAxis::listedDegrees(AxisQuantity::ThetaO, {10, 40, 80})};
  return GridBrdf::tabulate(*parseMaterialExpression("0.3*Lambertian + 0.5*GGX(alpha=0.3, ior=1.5)"), layout);
}

TEST(Metric, NgansFitsAreWeightedBySolidAngleAndTheCosine) {
  const auto grid = thetaGrid();
  const std::vector<double> edgesI = {0, 10, 35, 60, 70}, edgesO = {10, 25, 60, 80};
  const std::vector<double> nodesI = {0, 20, 50, 70};
  std::vector<double> values(12), weights(12);
  grid->samples()->read(0, 12, nullptr, values.data(), nullptr);
  double squared = 0, total = 0;
  const auto cosine = [](double angle) { return std::cos(radians(angle)); };
  for (std::size_t i = 0; i < 12; ++i) {
    const std::size_t k = i % 4, l = i / 4;
    const double solidAngle = (cosine(edgesI[k]) - cosine(edgesI[k + 1])) * (cosine(edgesO[l]) - cosine(edgesO[l + 1]));
    weights[i] = solidAngle * cosine(nodesI[k]) * cosine(nodesI[k]);
    squared += weights[i] * values[i] * values[i];
    total += solidAngle;
  }
  FitOptions options;
  options.metric = "ngan";
  const FitReport report = fit(*grid, {{findModel("Lambertian"), {}, {}, {}}}, options);
  EXPECT_EQ(report.strategy, "separable");
  EXPECT_NEAR(report.parameters[0].value, kPi * bestConstant(values, weights), 1e-12);
  EXPECT_NEAR(report.zeroModel.at("ngan"), std::sqrt(squared / total), 1e-13);
}

TEST(Metric, NganIsRefusedWhereSamplesHaveNoCells) {
  const ScatteredBrdf target = syntheticTarget("0.5*Lambertian", 50);
  FitOptions options;
  options.metric = "ngan";
  try {
    fit(target, {{findModel("Lambertian"), {}, {}, {}}}, options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no solid angles"), std::string::npos);
  }
  EXPECT_FALSE(compare(target, target).metrics.contains("ngan"));
}

}  // namespace
}  // namespace brdf
