#include <brdf/base/Parallel.h>
#include <brdf/fit/Cost.h>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include "SyntheticTarget.h"

namespace brdf {
namespace {

/// A small target that the fitted lobes cannot describe, in two channels' worth of residuals.
ScatteredBrdf target() {
  return syntheticTarget(
      "(0.3,0.1,0.2)*Lambertian + (0.02,0.05,0.03)*CookTorrance(m=0.3, ior=1.4) + "
      "(0.01,0.01,0.02)*BlinnPhong(n=300)",
      400);
}

std::vector<LobeRequest> lobes() {
  return {{findModel("Lambertian"), {}, {}, {}}, {findModel("GGX"), {}, {{"alpha", 0.25}, {"ior", 1.6}}, {}}};
}

/// Values of the lobes at all samples, weighted by the metric for this channel, one row a sample.
Eigen::MatrixXd denseColumns(const FitProblem& problem, const FitData& data, std::span<const double> x,
                             std::size_t channel) {
  Eigen::MatrixXd columns(data.samples, problem.lobeCount());
  const auto parameters = problem.parameters(x);
  Eigen::Index row = 0;
  for (const FitChunk& chunk : data.chunks) {
    const auto count = static_cast<Eigen::Index>(chunk.pairs.size());
    for (std::size_t l = 0; l < problem.lobeCount(); ++l) {
      Eigen::VectorXd values(count), weight(count);
      problem.model(l).evaluate(chunk.pairs.view(), parameters[l], values.data());
      data.block(chunk, channel).slope(values.data(), weight.data());
      columns.col(static_cast<Eigen::Index>(l)).segment(row, count) = values.cwiseProduct(weight);
    }
    row += count;
  }
  return columns;
}

/// The residuals of all channels at the best scale factors of x (all positive here), by QR.
Eigen::VectorXd projectedResidual(const FitProblem& problem, const FitData& data, std::span<const double> x,
                                  Eigen::MatrixXd* scales = nullptr) {
  const Eigen::Map<const Eigen::MatrixXd> values(data.chunks[0].target.data(), data.samples, data.channels);
  Eigen::MatrixXd solution(problem.lobeCount(), data.channels), residual(data.samples, data.channels);
  for (std::size_t c = 0; c < data.channels; ++c) {
    const Eigen::MatrixXd columns = denseColumns(problem, data, x, c);
    const auto k = static_cast<Eigen::Index>(c);
    solution.col(k) = columns.colPivHouseholderQr().solve(values.col(k));
    residual.col(k) = columns * solution.col(k) - values.col(k);
  }
  EXPECT_GT(solution.minCoeff(), 0);
  if (scales) *scales = solution;
  return Eigen::Map<const Eigen::VectorXd>(residual.data(), residual.size());
}

TEST(TiedLobes, TheCostsHaveTheirDerivatives) {
  const ScatteredBrdf measured = target();
  std::vector<LobeRequest> requests = lobes();
  requests.push_back({findModel("CookTorrance"), {}, {{"m", 0.4}}, {}, {{"ior", {1, "ior"}}, {"m", {1, "alpha"}}}});
  const FitProblem problem(requests, Symmetry::Isotropic);
  ASSERT_EQ(problem.coordinates().size(), 2u);  // alpha and ior of both
  ASSERT_EQ(problem.derivativeColumns().size(), 4u);
  const FitData data = FitData::read(*measured.samples(), findMetric("rms"), {});
  SeparableCost separable(problem, data, {0, 3});
  JointCost joint(problem, data, {0, 3});
  const auto check = [](CostFunction& cost, const std::vector<double>& x) {
    const NormalEquations equations = cost.normalEquations(x);
    for (std::size_t k = 0; k < x.size(); ++k) {
      std::vector<double> up = x, down = x;
      const double h = 1e-5 * std::max(1.0, std::abs(x[k]));
      up[k] += h, down[k] -= h;
      const double slope = (cost.squaredError(up) - cost.squaredError(down)) / (4 * h);  // J'r is half of it
      EXPECT_NEAR(equations.gradient[k], slope, 1e-5 * std::abs(slope) + 1e-9) << k;
    }
  };
  check(separable, problem.start());
  check(joint, joint.join(problem.start(), {0.2, 0.1, 0.3, 0.1, 0.2, 0.1, 0.3, 0.2, 0.2}));
}

TEST(SeparableCost, AgreesWithDenseLeastSquaresAndItsExactDerivative) {
  const ScatteredBrdf measured = target();
  for (const char* metric : {"rms", "rms_cos", "relative", "formula:f*cos_i*cos_o"}) {
    ASSERT_TRUE(findMetric(metric)->quadratic()) << metric;
    const FitData data = FitData::read(*measured.samples(), findMetric(metric), {});
    const FitProblem problem(lobes(), Symmetry::Isotropic);
    const std::vector<double> x = problem.start();
    ASSERT_EQ(x.size(), 2u);
    SeparableCost cost(problem, data, {0, 3});
    const NormalEquations equations = cost.normalEquations(x);

    Eigen::MatrixXd scales;
    const Eigen::VectorXd residual = projectedResidual(problem, data, x, &scales);
    EXPECT_NEAR(equations.squaredError, residual.squaredNorm(), 1e-12 * residual.squaredNorm());
    for (Eigen::Index c = 0; c < 3; ++c)
      for (Eigen::Index l = 0; l < 2; ++l)
        EXPECT_NEAR(cost.bestScales()[static_cast<std::size_t>(2 * c + l)], scales(l, c), 1e-11 * scales(l, c));

    Eigen::MatrixXd jacobian(residual.size(), 2);
    const double step = 1e-5;
    for (Eigen::Index k = 0; k < 2; ++k) {
      std::vector<double> up = x, down = x;
      up[static_cast<std::size_t>(k)] += step;
      down[static_cast<std::size_t>(k)] -= step;
      jacobian.col(k) = (projectedResidual(problem, data, up) - projectedResidual(problem, data, down)) / (2 * step);
    }
    const Eigen::VectorXd gradient = jacobian.transpose() * residual;
    const Eigen::MatrixXd matrix = jacobian.transpose() * jacobian;
    for (Eigen::Index i = 0; i < 2; ++i) {
      EXPECT_NEAR(equations.gradient[static_cast<std::size_t>(i)], gradient[i], 1e-7 * gradient.norm()) << metric;
      for (Eigen::Index j = 0; j < 2; ++j)
        EXPECT_NEAR(equations.matrix[static_cast<std::size_t>(2 * i + j)], matrix(i, j), 1e-7 * matrix.norm())
            << metric;
    }
  }
}

TEST(SeparableCost, KeepsTheDigitsOfANearlyPerfectFit) {
  // Truth moved by a relative 1e-7: the squared error is 1e-14 of the data's, where y'y - b'A^-1 b would keep two
  // digits.
  const ScatteredBrdf measured = syntheticTarget("0.3*Lambertian + 0.05*GGX(alpha=0.25, ior=1.6)", 400);
  const FitData data = FitData::read(*measured.samples(), findMetric("rms"), {});
  const FitProblem problem(lobes(), Symmetry::Isotropic);
  std::vector<double> x = problem.start();
  x[0] += 1e-7;
  SeparableCost cost(problem, data, {0, 1});
  const double error = cost.squaredError(x);
  const double dense = projectedResidual(problem, data, x).squaredNorm();
  EXPECT_NEAR(error, dense, 1e-5 * dense);
  EXPECT_LT(error, 1e-12 * cost.scale());
}

TEST(SeparableCost, ForgetsTheScalesOfATrialWithoutSense) {
  // Every half vector is at least 25 degrees from the normal: narrow lobes are below 1e-30 there, and their best scales
  // above 1e30. The trial after has ordinary values.
  ScatteredSamples samples;
  for (int k = 0; k < 60; ++k) {
    const double ti = radians(20 + k % 10), to = radians(30 + k);
    samples.pairs.push(fromSpherical(ti, 0), fromSpherical(to, 0));
    samples.values.push_back(0.1 + 0.02 * std::cos(k));
  }
  const ScatteredBrdf measured(std::move(samples), "far from the mirror direction");
  const FitData data = FitData::read(*measured.samples(), findMetric("rms"), {});
  const FitProblem problem({{findModel("Lambertian"), {}, {}, {}}, {findModel("Ward"), {}, {}, {}}},
                           Symmetry::Isotropic);
  for (double narrow = 0.025; narrow < 0.06; narrow += 0.0025)
    for (double width = 0.1; width < 1; width += 0.1) {
      const std::vector<double> senseless{std::log(narrow)}, ordinary{std::log(width)};
      SeparableCost fresh(problem, data, {0, 1}), used(problem, data, {0, 1});
      const double wanted = fresh.squaredError(ordinary);
      EXPECT_GT(wanted, 0.001);
      used.squaredError(senseless);
      EXPECT_NEAR(used.squaredError(ordinary), wanted, 1e-12 * wanted) << narrow << " " << width;
    }
}

TEST(SeparableCost, DoesNotDependOnTheNumberOfThreads) {
  const ScatteredBrdf measured = syntheticTarget("0.3*Lambertian + 0.05*CookTorrance(m=0.25, ior=1.6)", 40000, 1e-3);
  const FitData data = FitData::read(*measured.samples(), findMetric("rms"), {});
  const FitProblem problem(lobes(), Symmetry::Isotropic);
  const auto run = [&](std::size_t threads) {
    setThreadCount(threads);
    const NormalEquations equations = SeparableCost(problem, data, {0, 1}).normalEquations(problem.start());
    setThreadCount(0);
    return equations;
  };
  const NormalEquations one = run(1), three = run(3);
  EXPECT_EQ(one.squaredError, three.squaredError);
  EXPECT_EQ(one.gradient, three.gradient);
  EXPECT_EQ(one.matrix, three.matrix);
}

TEST(JointCost, DerivativesAgreeWithDifferencesForEveryMetric) {
  const ScatteredBrdf measured = target();
  for (const char* metric : {"rms", "rms_cos", "log", "cuberoot", "relative", "huber", "huber:0.01",
                             "formula:cbrt(f*cos_i)", "formula:(f - t)/sqrt(t + 0.1*cos_o)"}) {
    const FitData data = FitData::read(*measured.samples(), findMetric(metric), {});
    const FitProblem problem(lobes(), Symmetry::Isotropic);
    JointCost cost(problem, data, {0, 3});
    const std::vector<double> x = cost.join(problem.start(), {0.25, 0.1, 0.15, 0.2, 0.2, 0.15});
    ASSERT_EQ(x.size(), 8u);
    const NormalEquations equations = cost.normalEquations(x);
    EXPECT_NEAR(equations.squaredError, cost.squaredError(x), 1e-12 * equations.squaredError);
    for (std::size_t k = 0; k < x.size(); ++k) {
      std::vector<double> up = x, down = x;
      const double step = 1e-5 * std::max(0.1, std::abs(x[k]));
      up[k] += step;
      down[k] -= step;
      const double difference = (cost.squaredError(up) - cost.squaredError(down)) / (4 * step);
      EXPECT_NEAR(equations.gradient[k], difference, 1e-6 * std::abs(difference) + 1e-9 * equations.squaredError)
          << metric << " " << k;
    }
    EXPECT_EQ(cost.scalesOf(x), (Scales{0.25, 0.1, 0.15, 0.2, 0.2, 0.15}));
  }
}

TEST(JointCost, EliminatingTheScalesGivesTheSeparableMatrix) {
  // At the best scales the Schur complement of the joint matrix is the projected (Kaufman) part of the separable one.
  const ScatteredBrdf measured = target();
  const FitData data = FitData::read(*measured.samples(), findMetric("rms"), {});
  const FitProblem problem(lobes(), Symmetry::Isotropic);
  SeparableCost separable(problem, data, {0, 3});
  const NormalEquations projected = separable.normalEquations(problem.start());
  JointCost joint(problem, data, {0, 3});
  const NormalEquations full = joint.normalEquations(joint.join(problem.start(), separable.bestScales()));
  EXPECT_NEAR(full.squaredError, projected.squaredError, 1e-12 * full.squaredError);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR(full.gradient[k], projected.gradient[k], 1e-10 * std::abs(projected.gradient[k]));
  for (std::size_t k = 2; k < 8; ++k)  // the scales are at their minimum
    EXPECT_NEAR(full.gradient[k], 0, 1e-9 * std::sqrt(full.squaredError * full.matrix[k * 8 + k]));
}

}  // namespace
}  // namespace brdf
