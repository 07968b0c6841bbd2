#include <brdf/base/Error.h>
#include <brdf/fit/Cost.h>
#include <brdf/fit/Diagnostics.h>
#include <brdf/fit/FitProblem.h>
#include <brdf/material/RegionErrors.h>
#include <brdf/material/TableBrdf.h>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <set>

#include "SyntheticTarget.h"

namespace brdf {
namespace {

LobeRequest lobe(const std::string& name) { return {findModel(name), {}, {}, {}}; }

/// What a Lambertian alone leaves of a glossy target.
struct Glossy {
  ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.2*GGX(alpha=0.3, ior=1.5)", 400, 1e-3);
  std::vector<double> values;
  DirectionPairBuffer<double> pairs;
  FitReport report = fit(target, {lobe("Lambertian")}, {});
  Glossy() {
    values.resize(400);
    target.samples()->read(0, 400, &pairs, values.data(), nullptr);
  }
  double residual(std::size_t i) const { return report.parameters[0].value / kPi - values[i]; }
};

TEST(Diagnostics, CriteriaAreThoseOfAOneParameterModel) {
  const Glossy glossy;
  double squared = 0;
  for (std::size_t i = 0; i < 400; ++i) squared += glossy.residual(i) * glossy.residual(i);
  EXPECT_EQ(glossy.report.degrees, 2u);  // the albedo and the variance
  EXPECT_NEAR(glossy.report.aic, 400 * std::log(squared / 400) + 4, 1e-9);
  EXPECT_NEAR(glossy.report.bic, 400 * std::log(squared / 400) + 2 * std::log(400), 1e-9);
}

TEST(Diagnostics, CriteriaPreferTheLobesThatMadeTheData) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*GGX(alpha=0.3, ior=1.5)", 400, 1e-3);
  LobeRequest glossy = lobe("GGX");
  glossy.fixed["ior"] = 1.5;
  const FitReport one = fit(target, {lobe("Lambertian")}, {}), two = fit(target, {lobe("Lambertian"), glossy}, {}),
                  three = fit(target, {lobe("Lambertian"), glossy, glossy}, {});
  EXPECT_LT(two.bic, one.bic - 100);
  EXPECT_LT(two.bic, three.bic);
  EXPECT_LE(three.error, two.error * (1 + 1e-9));
}

TEST(Diagnostics, RegionsAndWorstSamplesAreThoseOfTheResiduals) {
  const Glossy glossy;
  std::array<double, 4> squared{}, difference{};
  std::array<std::size_t, 4> count{};
  double total = 0;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < 400; ++i) {
    const Direction wi{glossy.pairs.wi[0][i], glossy.pairs.wi[1][i], glossy.pairs.wi[2][i]};
    const Direction wo{glossy.pairs.wo[0][i], glossy.pairs.wo[1][i], glossy.pairs.wo[2][i]};
    const std::size_t region = directionRegion(wi, wo);
    const double r = glossy.residual(i);
    squared[region] += r * r;
    difference[region] += r;
    ++count[region];
    total += r * r;
    order.emplace_back(r * r, i);
  }
  std::ranges::sort(order, std::greater<>());
  ASSERT_EQ(glossy.report.regions.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    const RegionResidual& region = glossy.report.regions[k];
    EXPECT_EQ(region.region, kDirectionRegions[k]);
    EXPECT_EQ(region.samples, count[k]);
    ASSERT_GT(count[k], 0u);
    EXPECT_NEAR(region.error, std::sqrt(squared[k] / static_cast<double>(count[k])), 1e-12);
    EXPECT_NEAR(region.share, squared[k] / total, 1e-12);
    EXPECT_NEAR(region.meanDifference, difference[k] / static_cast<double>(count[k]), 1e-12);
  }
  ASSERT_EQ(glossy.report.worst.size(), 10u);
  for (std::size_t k = 0; k < 10; ++k) {
    const WorstSample& sample = glossy.report.worst[k];
    EXPECT_NEAR(sample.share, order[k].first / total, 1e-12);
    EXPECT_EQ(sample.target, glossy.values[order[k].second]);
    EXPECT_EQ(sample.wi[0], glossy.pairs.wi[0][order[k].second]);
    EXPECT_NEAR(sample.fitted, glossy.report.parameters[0].value / kPi, 1e-15);
  }
}

TEST(Diagnostics, CovarianceIsThatOfLinearLeastSquares) {
  // Scale factors alone: the covariance is sigma^2 (X'X)^-1 with the columns of the two lobes.
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*GGX(alpha=0.2, ior=1.5)", 300, 0.01);
  const FitReport report =
      fit(target, {lobe("Lambertian"), LobeRequest{findModel("GGX"), {{"alpha", 0.2}, {"ior", 1.5}}, {}, {}}}, {});
  DirectionPairBuffer<double> pairs;
  Eigen::VectorXd values(300), ggx(300);
  target.samples()->read(0, 300, &pairs, values.data(), nullptr);
  findModel("GGX")->evaluate(pairs.view(), report.material->lobes()[1].parametersOf(0), ggx.data());
  Eigen::MatrixXd columns(300, 2);
  columns.col(0).setConstant(1 / kPi);
  columns.col(1) = ggx;
  const Eigen::MatrixXd inverse = (columns.transpose() * columns).inverse();
  const Eigen::VectorXd residual = columns * (inverse * (columns.transpose() * values)) - values;
  const Eigen::MatrixXd expected = residual.squaredNorm() / 298 * inverse;
  ASSERT_EQ(report.covariance.parameters.size(), 2u);
  for (Eigen::Index i = 0; i < 2; ++i)
    for (Eigen::Index j = 0; j < 2; ++j)
      EXPECT_NEAR(report.covariance.matrix[static_cast<std::size_t>(2 * i + j)], expected(i, j),
                  1e-9 * expected.norm());
  EXPECT_EQ(report.parameters[report.covariance.parameters[1]].lobe, "GGX");
  EXPECT_NEAR(report.covariance.correlations()[1], expected(0, 1) / std::sqrt(expected(0, 0) * expected(1, 1)), 1e-9);
}

TEST(Diagnostics, TheCovarianceHoldsTheStandardErrors) {
  const ScatteredBrdf target = syntheticTarget("(0.3,0.2,0.1)*Lambertian + 0.5*GGX(alpha=0.2, ior=1.5)", 300, 1e-3);
  FitOptions options;
  for (const Combination combination : {Combination::Shared, Combination::PerChannel}) {
    options.combination = combination;
    const FitReport report = fit(target, {lobe("Lambertian"), lobe("GGX")}, options);
    const std::size_t n = report.covariance.parameters.size();
    ASSERT_EQ(report.covariance.matrix.size(), n * n);
    EXPECT_GE(n, 8u);
    for (std::size_t i = 0; i < n; ++i) {
      const FittedParameter& p = report.parameters[report.covariance.parameters[i]];
      EXPECT_NEAR(std::sqrt(report.covariance.matrix[i * n + i]), p.standardError.value(), 1e-12) << p.name;
    }
  }
}

TEST(Diagnostics, HistoryFallsWithinEveryRun) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*CookTorrance(m=0.2, ior=1.5)", 500);
  const FitReport report = fit(target, {lobe("Lambertian"), lobe("GGX")}, {});
  ASSERT_FALSE(report.history.empty());
  double least = 1e9;
  for (std::size_t k = 0; k < report.history.size(); ++k) {
    const FitStep& step = report.history[k];
    if (k > 0 && step.run == report.history[k - 1].run) {
      EXPECT_LT(step.error, report.history[k - 1].error);
    }
    EXPECT_LE(step.iteration, report.iterations);
    least = std::min(least, step.error);
  }
  EXPECT_NEAR(least, report.error, 1e-9 * report.error);
}

TEST(Diagnostics, PartsAreWholeBlocksOfLikeSize) {
  const auto table =
      TableBrdf::tabulate(*parseMaterialExpression("0.5*Lambertian"), {.phiD = 24, .thetaD = 18, .thetaH = 18});
  const FitData data = FitData::read(*table->samples(), findMetric("rms"), {});
  const std::vector<std::uint8_t> parts = directionParts(data, Symmetry::Isotropic, 5);
  ASSERT_EQ(parts.size(), data.samples);
  std::array<std::size_t, 5> sizes{};
  for (const std::uint8_t part : parts) ++sizes.at(part);
  for (const std::size_t size : sizes) EXPECT_NEAR(double(size), double(data.samples) / 5, 0.02 * double(data.samples));
  const FitData part = data.select(parts, 2, true), rest = data.select(parts, 2, false);
  EXPECT_EQ(part.samples, sizes[2]);
  EXPECT_EQ(part.samples + rest.samples, data.samples);
  // Neighbours in phi_d, 7.5 degrees apart, mostly share a block.
  std::size_t same = 0;
  for (std::size_t i = 1; i < parts.size(); ++i) same += parts[i] == parts[i - 1];
  EXPECT_GT(same, parts.size() * 6 / 10);
  EXPECT_THROW(directionParts(FitData::read(*syntheticTarget("0.5*Lambertian", 5).samples(), findMetric("rms"), {}),
                              Symmetry::Isotropic, 50),
               Error);
}

TEST(Diagnostics, CrossValidationIsTheErrorOnWhatWasLeftOut) {
  // A constant: without a part its best value is the mean of the rest.
  const Glossy glossy;
  FitOptions options;
  options.crossValidation = 4;
  const FitReport report = fit(glossy.target, {lobe("Lambertian")}, options);
  const FitData data = FitData::read(*glossy.target.samples(), findMetric("rms"), {});
  const std::vector<std::uint8_t> parts = directionParts(data, glossy.target.symmetry(), 4);
  double total = 0;
  for (std::uint8_t part = 0; part < 4; ++part) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < 400; ++i)
      if (parts[i] != part) {
        sum += glossy.values[i];
        ++count;
      }
    for (std::size_t i = 0; i < 400; ++i)
      if (parts[i] == part) total += std::pow(glossy.values[i] - sum / count, 2);
  }
  ASSERT_TRUE(report.crossValidation.has_value());
  EXPECT_NEAR(report.crossValidation->error, std::sqrt(total / 400), 1e-12);
  EXPECT_EQ(report.crossValidation->partErrors.size(), 4u);
  EXPECT_GT(report.crossValidation->standardError, 0);
  EXPECT_EQ(report.evaluations, glossy.report.evaluations) << "of the fit alone";
  options.crossValidation = 1;
  EXPECT_THROW(fit(glossy.target, {lobe("Lambertian")}, options), Error);
}

TEST(Diagnostics, CrossValidationSeesThatAWrongLobeDoesNotCarryOver) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*GGX(alpha=0.3, ior=1.5)", 600, 1e-3);
  FitOptions options;
  options.crossValidation = 5;
  const FitReport right = fit(target, {lobe("Lambertian"), lobe("GGX")}, options);
  const FitReport wrong = fit(target, {lobe("Lambertian"), lobe("BlinnPhong")}, options);
  EXPECT_NEAR(right.crossValidation->error, 1e-3, 1e-4);  // the noise
  EXPECT_GT(wrong.crossValidation->error, 2 * right.crossValidation->error);
}

}  // namespace
}  // namespace brdf
