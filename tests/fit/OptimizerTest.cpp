#include <brdf/base/Error.h>
#include <brdf/fit/Fit.h>
#include <brdf/fit/Metric.h>
#include <brdf/fit/Optimizer.h>
#include <brdf/material/TableBrdf.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <future>
#include <limits>

#include "NistProblems.h"
#include "SyntheticTarget.h"

namespace brdf {
namespace {

NistProblem problem(const char* name) {
  return nistProblem(std::filesystem::path(BRDF_SOURCE_DIR) / "tests/data/nist", name);
}

TEST(LevenbergMarquardt, StopsOnTheBoundWhereTheGradientPushesOutward) {
  NistProblem nist = problem("Misra1a");
  nist.curve.setBounds({0, 0}, {200, 1});  // the minimum has b0 = 239
  const OptimizerResult result = levenbergMarquardt(nist.curve, {100, 1e-3}, {});
  EXPECT_TRUE(result.converged) << result.termination;
  EXPECT_EQ(result.x[0], 200);
  const NormalEquations equations = nist.curve.normalEquations(result.x);
  EXPECT_LT(equations.gradient[0], 0);  // outward
  EXPECT_LT(std::abs(equations.gradient[1]) / std::sqrt(equations.matrix[3]), 1e-6 * std::sqrt(equations.squaredError));
}

TEST(LevenbergMarquardt, TheProgressFunctionStopsItWithTheBestSoFar) {
  NistProblem nist = problem("Misra1a");
  OptimizerOptions options;
  int calls = 0;
  options.progress = [&](double) { return ++calls < 3; };
  const OptimizerResult result = levenbergMarquardt(nist.curve, {250, 5e-4}, options);
  EXPECT_TRUE(result.stopped);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(calls, 3);
  EXPECT_LT(result.squaredError, nist.curve.squaredError(std::vector<double>{250, 5e-4}));
}

TEST(Optimizers, EveryOneSolvesABoundedProblemFromNearby) {
  for (const Optimizer& optimizer : allOptimizers()) {
    NistProblem nist = problem("DanWood");
    nist.curve.setBounds({0.1, 1}, {2, 8});
    OptimizerOptions options;
    options.tolerance = 1e-10;
    const OptimizerResult result = optimizer.minimize(nist.curve, {0.7, 4}, options);
    // The global ones find the valley and do not polish: at the start the error is 36 times the least.
    const double allowed = optimizer.global ? 5 : 1e-3;
    EXPECT_NEAR(result.squaredError, nist.residualSum, allowed * nist.residualSum)
        << optimizer.name << ": " << result.termination;
    EXPECT_EQ(result.squaredError, nist.curve.squaredError(result.x)) << optimizer.name;
    EXPECT_TRUE(result.converged || optimizer.global) << optimizer.name << ": " << result.termination;
  }
}

TEST(Optimizers, EveryLocalOneFindsAMinimumOnTheBounds) {
  // (x - 3)^2 + (y + 1)^2 + (x + y - 2)^2 on the unit square: the least is at (1, 0).
  for (const Optimizer& optimizer : allOptimizers()) {
    if (optimizer.global) continue;
    Curve plane({0, 1, 2}, {3, -1, 2}, 2, [](const double* t, std::span<const double> b, double* d) {
      d[0] = *t != 1;
      d[1] = *t != 0;
      return d[0] * b[0] + d[1] * b[1];
    });
    plane.setBounds({0, 0}, {1, 1});
    for (const std::vector<double>& start : {std::vector{0.4, 0.7}, std::vector{0.0, 1.0}, std::vector{1.0, 0.0}}) {
      const OptimizerResult result = optimizer.minimize(plane, start, {});
      EXPECT_NEAR(result.x[0], 1, 1e-6) << optimizer.name << ": " << result.termination;
      EXPECT_NEAR(result.x[1], 0, 1e-6) << optimizer.name << ": " << result.termination;
      EXPECT_TRUE(result.converged) << optimizer.name << ": " << result.termination;
      EXPECT_LE(result.x[0], 1) << optimizer.name;
      EXPECT_GE(result.x[1], 0) << optimizer.name;
    }
  }
}

/// One residual 2 + cos(x) + 0.1 (x - 9): minima every 2 pi, the lower the further left.
Curve waves() {
  Curve curve({0}, {0}, 1, [](const double*, std::span<const double> b, double* d) {
    d[0] = -std::sin(b[0]) + 0.1;
    return 3 + std::cos(b[0]) + 0.1 * (b[0] - 9);
  });
  curve.setBounds({0}, {20});
  return curve;
}

TEST(Optimizers, GlobalOnesLeaveTheValleyOfTheStartAndLocalOnesNeedNot) {
  // Minima where sin x = 0.1, cos x < 0: x = pi - asin 0.1 + 2 pi k. The start lies in the valley of k = 2.
  const double left = std::acos(-1.0) - std::asin(0.1);
  for (const Optimizer& optimizer : allOptimizers()) {
    Curve curve = waves();
    const OptimizerResult result = optimizer.minimize(curve, {15.5}, {});
    if (optimizer.global)
      EXPECT_NEAR(result.x[0], left, 0.05) << optimizer.name << ": " << result.termination;
    else
      EXPECT_LE(result.squaredError, curve.squaredError(std::vector<double>{15.5})) << optimizer.name;
  }
}

TEST(Optimizers, AGlobalSearchOfAnInfiniteBoxIsRefusedWithTheReason) {
  for (const Optimizer& optimizer : allOptimizers()) {
    if (!optimizer.global) continue;
    NistProblem nist = problem("DanWood");
    try {
      optimizer.minimize(nist.curve, {0.7, 4}, {});
      FAIL() << optimizer.name;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Value);
      EXPECT_NE(error.details().what.find("finite"), std::string::npos) << error.details().what;
    }
  }
}

TEST(Optimizers, AreTheSameToTheLastBitForTheSameSeedAlsoInSeveralThreads) {
  for (const Optimizer& optimizer : allOptimizers()) {
    const auto run = [&](std::uint64_t seed) {
      NistProblem nist = problem("Rat42");
      nist.curve.setBounds({10, 0, 0.01}, {200, 5, 0.2});
      OptimizerOptions options;
      options.seed = seed;
      return optimizer.minimize(nist.curve, {100, 1, 0.1}, options);
    };
    const OptimizerResult first = run(7), second = run(7);
    EXPECT_EQ(first.x, second.x) << optimizer.name;
    EXPECT_EQ(first.evaluations, second.evaluations) << optimizer.name;
    auto one = std::async(std::launch::async, run, 7), other = std::async(std::launch::async, run, 8);
    EXPECT_EQ(one.get().x, first.x) << optimizer.name;
    other.get();
  }
}

TEST(Optimizers, TheProgressFunctionStopsEveryOneWithTheBestSoFar) {
  for (const Optimizer& optimizer : allOptimizers()) {
    NistProblem nist = problem("Rat42");
    nist.curve.setBounds({10, 0, 0.01}, {200, 5, 0.2});
    OptimizerOptions options;
    std::size_t calls = 0;
    double best = 0;
    options.progress = [&](double squaredError) {
      best = squaredError;
      return ++calls < 7;
    };
    const OptimizerResult result = optimizer.minimize(nist.curve, {100, 1, 0.1}, options);
    EXPECT_TRUE(result.stopped) << optimizer.name << ": " << result.termination;
    EXPECT_FALSE(result.converged) << optimizer.name;
    EXPECT_EQ(calls, 7u) << optimizer.name;
    EXPECT_EQ(result.squaredError, best) << optimizer.name;
    EXPECT_EQ(result.squaredError, nist.curve.squaredError(result.x)) << optimizer.name;
  }
}

TEST(Optimizers, AnExceptionOfTheCostFunctionReachesTheCaller) {
  for (const Optimizer& optimizer : allOptimizers()) {
    int calls = 0;
    Curve curve({1, 2, 3}, {2, 4, 7}, 2, [&](const double* t, std::span<const double> b, double* d) {
      if (++calls > 30) throw std::domain_error("not here");
      d[0] = *t;
      d[1] = 1;
      return b[0] * *t + std::exp(b[1] / 10);
    });
    curve.setBounds({-10, -10}, {10, 10});
    EXPECT_THROW(optimizer.minimize(curve, {-5, 5}, {}), std::domain_error) << optimizer.name;
  }
}

TEST(Optimizers, ValuesThatAreNotFiniteAreSteppedOver) {
  for (const Optimizer& optimizer : allOptimizers()) {
    Curve curve({1, 2}, {1, 2}, 1, [](const double* t, std::span<const double> b, double* d) {
      d[0] = *t;
      return b[0] > 2 ? std::numeric_limits<double>::quiet_NaN() : b[0] * *t;
    });
    curve.setBounds({-4}, {4});
    const OptimizerResult result = optimizer.minimize(curve, {-1}, {});
    EXPECT_NEAR(result.x[0], 1, 0.02) << optimizer.name << ": " << result.termination;
  }
}

TEST(Optimizers, ALoneParameterIsEnoughForEveryOne) {
  for (const Optimizer& optimizer : allOptimizers()) {
    Curve line({1, 2, 3}, {2, 4, 6}, 1, [](const double* t, std::span<const double> b, double* d) {
      d[0] = *t;
      return b[0] * *t;
    });
    line.setBounds({-10}, {10});
    EXPECT_NEAR(optimizer.minimize(line, {0.7}, {}).x[0], 2, 1e-2) << optimizer.name;
  }
}

TEST(Optimizers, EveryOneTakesEveryMetricAndBothStrategies) {
  // A table: its cells have the solid angles that some metrics weigh by.
  const auto table = TableBrdf::tabulate(*parseMaterialExpression("0.3*Lambertian + 0.5*CookTorrance(m=0.2, ior=1.5)"),
                                         {.phiD = 6, .thetaD = 6, .thetaH = 12});
  const LobeRequest diffuse{findModel("Lambertian"), {}, {}, {}};
  const LobeRequest specular{findModel("CookTorrance"), {{"ior", 1.5}}, {}, {}};
  for (const Optimizer& optimizer : allOptimizers())
    for (const MetricPointer& metric : allMetrics())
      for (const Strategy strategy : {Strategy::Separable, Strategy::Joint}) {
        FitOptions options;
        options.optimizer = optimizer.name;
        options.metric = metric->name();
        options.strategy = strategy;
        if (strategy == Strategy::Separable && !metric->quadratic()) {
          EXPECT_THROW(fit(*table, {diffuse, specular}, options), Error) << metric->name();
          continue;
        }
        const FitReport report = fit(*table, {diffuse, specular}, options);
        EXPECT_LT(report.error, 1e-3 * report.zeroModel.at(report.metric))
            << optimizer.name << " " << metric->name() << " " << report.strategy << ": " << report.termination;
      }
}

TEST(Optimizers, ThePageOfOptimizersNamesEveryOneAndItsCounts) {
  std::ifstream file(std::filesystem::path(BRDF_SOURCE_DIR) / "docs/fitting-optimizers.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  for (const Optimizer& optimizer : allOptimizers()) {
    const std::string name(optimizer.name), row = "\n| " + name + " | ";
    EXPECT_NE(page.find("\n| `" + name + "` | "), page.npos) << name;
    const std::size_t reference = page.find(row);
    ASSERT_NE(reference, page.npos) << name << " has no counts: run optimizer_study";
    EXPECT_NE(page.find(row, reference + 1), page.npos) << name << " has counts on one list only";
  }
}

TEST(Optimizers, AnUnknownNameIsAnErrorThatListsTheKnownOnes) {
  EXPECT_EQ(optimizerNames().front(), "lm");
  try {
    findOptimizer("magic");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Value);
    EXPECT_NE(error.details().allowed.find("bobyqa"), std::string::npos);
  }
}

}  // namespace
}  // namespace brdf
