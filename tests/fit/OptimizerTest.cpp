#include <brdf/base/Error.h>
#include <brdf/fit/Fit.h>
#include <brdf/fit/Metric.h>
#include <brdf/fit/Optimizer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <future>
#include <limits>

#include "SyntheticTarget.h"

namespace brdf {
namespace {

/// Residuals of a curve through points, with derivatives by hand.
class Curve : public CostFunction {
 public:
  /// Value at t, and its derivatives with respect to b.
  using Function = std::function<double(double t, std::span<const double> b, double* derivatives)>;
  Curve(std::vector<double> t, std::vector<double> y, std::size_t n, Function function)
      : t_(std::move(t)),
        y_(std::move(y)),
        function_(std::move(function)),
        lower_(n, -std::numeric_limits<double>::infinity()),
        upper_(n, std::numeric_limits<double>::infinity()) {}

  const std::vector<double>& lower() const override { return lower_; }
  const std::vector<double>& upper() const override { return upper_; }
  double squaredError(std::span<const double> b) override { return normalEquations(b).squaredError; }
  NormalEquations normalEquations(std::span<const double> b) override {
    const std::size_t n = b.size();
    NormalEquations equations{0, std::vector<double>(n), std::vector<double>(n * n)};
    std::vector<double> row(n);
    for (std::size_t k = 0; k < t_.size(); ++k) {
      const double residual = function_(t_[k], b, row.data()) - y_[k];
      equations.squaredError += residual * residual;
      for (std::size_t i = 0; i < n; ++i) {
        equations.gradient[i] += row[i] * residual;
        for (std::size_t j = 0; j < n; ++j) equations.matrix[i * n + j] += row[i] * row[j];
      }
    }
    return equations;
  }
  void setBounds(std::vector<double> lower, std::vector<double> upper) {
    lower_ = std::move(lower);
    upper_ = std::move(upper);
  }

 private:
  std::vector<double> t_, y_;
  Function function_;
  std::vector<double> lower_, upper_;
};

/// Problems of the NIST Statistical Reference Datasets, nonlinear regression (www.itl.nist.gov/div898/strd), with the
/// starts and the certified parameters and residual sum of squares. Of BoxBOD and MGH10 only the nearer start is here:
/// from the farther one the first accepted step leads to a plateau where every derivative vanishes.
struct Problem {
  std::string name;
  Curve curve;
  std::vector<std::vector<double>> starts;
  std::vector<double> certified;
  double residualSum;
};

std::vector<Problem> nistProblems() {
  std::vector<Problem> problems;
  const auto saturation = [](double t, std::span<const double> b, double* d) {
    const double e = std::exp(-b[1] * t);
    d[0] = 1 - e;
    d[1] = b[0] * t * e;
    return b[0] * (1 - e);
  };
  problems.push_back(
      {"Misra1a",
       Curve({77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0},
             {10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78}, 2,
             saturation),
       {{500, 0.0001}, {250, 0.0005}},
       {2.3894212918e2, 5.5015643181e-4},
       1.2455138894e-1});
  problems.push_back({"BoxBOD",
                      Curve({1, 2, 3, 5, 7, 10}, {109, 149, 149, 191, 213, 224}, 2, saturation),
                      {{100, 0.75}},
                      {2.1380940889e2, 5.4723748542e-1},
                      1.1680088766e3});
  problems.push_back({"DanWood",
                      Curve({1.309, 1.471, 1.490, 1.565, 1.611, 1.680}, {2.138, 3.421, 3.597, 4.340, 4.882, 5.660}, 2,
                            [](double t, std::span<const double> b, double* d) {
                              const double power = std::pow(t, b[1]);
                              d[0] = power;
                              d[1] = b[0] * power * std::log(t);
                              return b[0] * power;
                            }),
                      {{1, 5}, {0.7, 4}},
                      {7.6886226176e-1, 3.8604055871},
                      4.3173084083e-3});
  problems.push_back({"Rat42",
                      Curve({9, 14, 21, 28, 42, 57, 63, 70, 79},
                            {8.930, 10.800, 18.590, 22.330, 39.350, 56.110, 61.730, 64.620, 67.080}, 3,
                            [](double t, std::span<const double> b, double* d) {
                              const double e = std::exp(b[1] - b[2] * t), q = 1 / (1 + e);
                              d[0] = q;
                              d[1] = -b[0] * q * q * e;
                              d[2] = b[0] * q * q * e * t;
                              return b[0] * q;
                            }),
                      {{100, 1, 0.1}, {75, 2.5, 0.07}},
                      {7.2462237576e1, 2.6180768402, 6.7359200066e-2},
                      8.0565229338});
  problems.push_back({"MGH09",
                      Curve({4, 2, 1, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625},
                            {0.1957, 0.1947, 0.1735, 0.1600, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246}, 4,
                            [](double t, std::span<const double> b, double* d) {
                              const double top = t * t + t * b[1], bottom = t * t + t * b[2] + b[3];
                              d[0] = top / bottom;
                              d[1] = b[0] * t / bottom;
                              d[2] = -b[0] * top * t / (bottom * bottom);
                              d[3] = -b[0] * top / (bottom * bottom);
                              return b[0] * top / bottom;
                            }),
                      {{25, 39, 41.5, 39}, {0.25, 0.39, 0.415, 0.39}},
                      {1.9280693458e-1, 1.9128232873e-1, 1.2305650693e-1, 1.3606233068e-1},
                      3.0750560385e-4});
  problems.push_back(
      {"MGH10",
       Curve({50, 55, 60, 65, 70, 75, 80, 85, 90, 95, 100, 105, 110, 115, 120, 125},
             {34780, 28610, 23650, 19630, 16370, 13720, 11540, 9744, 8261, 7030, 6005, 5147, 4427, 3820, 3307, 2872}, 3,
             [](double t, std::span<const double> b, double* d) {
               const double e = std::exp(b[1] / (t + b[2]));
               d[0] = e;
               d[1] = b[0] * e / (t + b[2]);
               d[2] = -b[0] * e * b[1] / ((t + b[2]) * (t + b[2]));
               return b[0] * e;
             }),
       {{0.02, 4000, 250}},
       {5.6096364710e-3, 6.1813463463e3, 3.4522363462e2},
       8.7945855171e1});
  return problems;
}

TEST(LevenbergMarquardt, NistProblemsAreSolvedToSixDigits) {
  for (Problem& problem : nistProblems()) {
    // That the problem is typed correctly: the certified answer has the certified residual.
    ASSERT_NEAR(problem.curve.squaredError(problem.certified), problem.residualSum, 1e-8 * problem.residualSum)
        << problem.name;
    for (const auto& start : problem.starts) {
      OptimizerOptions options;
      options.tolerance = 1e-12;
      options.maximumIterations = 3000;
      const OptimizerResult result = levenbergMarquardt(problem.curve, start, options);
      EXPECT_TRUE(result.converged) << problem.name << ": " << result.termination;
      EXPECT_NEAR(result.squaredError, problem.residualSum, 1e-9 * problem.residualSum) << problem.name;
      for (std::size_t i = 0; i < result.x.size(); ++i)
        EXPECT_NEAR(result.x[i], problem.certified[i], 1e-6 * std::abs(problem.certified[i]))
            << problem.name << " from " << start[0] << ": " << result.termination << ", " << result.iterations;
    }
  }
}

TEST(LevenbergMarquardt, StopsOnTheBoundWhereTheGradientPushesOutward) {
  Problem problem = std::move(nistProblems()[0]);
  problem.curve.setBounds({0, 0}, {200, 1});  // the minimum has b0 = 239
  const OptimizerResult result = levenbergMarquardt(problem.curve, {100, 1e-3}, {});
  EXPECT_TRUE(result.converged) << result.termination;
  EXPECT_EQ(result.x[0], 200);
  const NormalEquations equations = problem.curve.normalEquations(result.x);
  EXPECT_LT(equations.gradient[0], 0);  // outward
  EXPECT_LT(std::abs(equations.gradient[1]) / std::sqrt(equations.matrix[3]), 1e-6 * std::sqrt(equations.squaredError));
}

TEST(LevenbergMarquardt, TheProgressFunctionStopsItWithTheBestSoFar) {
  Problem problem = std::move(nistProblems()[0]);
  OptimizerOptions options;
  int calls = 0;
  options.progress = [&](double) { return ++calls < 3; };
  const OptimizerResult result = levenbergMarquardt(problem.curve, {250, 5e-4}, options);
  EXPECT_TRUE(result.stopped);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(calls, 3);
  EXPECT_LT(result.squaredError, problem.curve.squaredError(std::vector<double>{250, 5e-4}));
}

TEST(Optimizers, EveryOneSolvesABoundedProblemFromNearby) {
  for (const Optimizer& optimizer : allOptimizers()) {
    Problem problem = std::move(nistProblems()[2]);
    problem.curve.setBounds({0.1, 1}, {2, 8});
    OptimizerOptions options;
    options.tolerance = 1e-10;
    const OptimizerResult result = optimizer.minimize(problem.curve, {0.7, 4}, options);
    // The global ones find the valley and do not polish: at the start the error is 36 times the least.
    const double allowed = optimizer.global ? 5 : 1e-3;
    EXPECT_NEAR(result.squaredError, problem.residualSum, allowed * problem.residualSum)
        << optimizer.name << ": " << result.termination;
    EXPECT_EQ(result.squaredError, problem.curve.squaredError(result.x)) << optimizer.name;
    EXPECT_TRUE(result.converged || optimizer.global) << optimizer.name << ": " << result.termination;
  }
}

TEST(Optimizers, EveryLocalOneFindsAMinimumOnTheBounds) {
  // (x - 3)^2 + (y + 1)^2 + (x + y - 2)^2 on the unit square: the least is at (1, 0).
  for (const Optimizer& optimizer : allOptimizers()) {
    if (optimizer.global) continue;
    Curve plane({0, 1, 2}, {3, -1, 2}, 2, [](double t, std::span<const double> b, double* d) {
      d[0] = t != 1;
      d[1] = t != 0;
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
  Curve curve({0}, {0}, 1, [](double, std::span<const double> b, double* d) {
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
    Problem problem = std::move(nistProblems()[2]);
    try {
      optimizer.minimize(problem.curve, {0.7, 4}, {});
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
      Problem problem = std::move(nistProblems()[3]);
      problem.curve.setBounds({10, 0, 0.01}, {200, 5, 0.2});
      OptimizerOptions options;
      options.seed = seed;
      return optimizer.minimize(problem.curve, {100, 1, 0.1}, options);
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
    Problem problem = std::move(nistProblems()[3]);
    problem.curve.setBounds({10, 0, 0.01}, {200, 5, 0.2});
    OptimizerOptions options;
    std::size_t calls = 0;
    double best = 0;
    options.progress = [&](double squaredError) {
      best = squaredError;
      return ++calls < 7;
    };
    const OptimizerResult result = optimizer.minimize(problem.curve, {100, 1, 0.1}, options);
    EXPECT_TRUE(result.stopped) << optimizer.name << ": " << result.termination;
    EXPECT_FALSE(result.converged) << optimizer.name;
    EXPECT_EQ(calls, 7u) << optimizer.name;
    EXPECT_EQ(result.squaredError, best) << optimizer.name;
    EXPECT_EQ(result.squaredError, problem.curve.squaredError(result.x)) << optimizer.name;
  }
}

TEST(Optimizers, AnExceptionOfTheCostFunctionReachesTheCaller) {
  for (const Optimizer& optimizer : allOptimizers()) {
    int calls = 0;
    Curve curve({1, 2, 3}, {2, 4, 7}, 2, [&](double t, std::span<const double> b, double* d) {
      if (++calls > 30) throw std::domain_error("not here");
      d[0] = t;
      d[1] = 1;
      return b[0] * t + std::exp(b[1] / 10);
    });
    curve.setBounds({-10, -10}, {10, 10});
    EXPECT_THROW(optimizer.minimize(curve, {-5, 5}, {}), std::domain_error) << optimizer.name;
  }
}

TEST(Optimizers, ValuesThatAreNotFiniteAreSteppedOver) {
  for (const Optimizer& optimizer : allOptimizers()) {
    Curve curve({1, 2}, {1, 2}, 1, [](double t, std::span<const double> b, double* d) {
      d[0] = t;
      return b[0] > 2 ? std::numeric_limits<double>::quiet_NaN() : b[0] * t;
    });
    curve.setBounds({-4}, {4});
    const OptimizerResult result = optimizer.minimize(curve, {-1}, {});
    EXPECT_NEAR(result.x[0], 1, 0.02) << optimizer.name << ": " << result.termination;
  }
}

TEST(Optimizers, ALoneParameterIsEnoughForEveryOne) {
  for (const Optimizer& optimizer : allOptimizers()) {
    Curve line({1, 2, 3}, {2, 4, 6}, 1, [](double t, std::span<const double> b, double* d) {
      d[0] = t;
      return b[0] * t;
    });
    line.setBounds({-10}, {10});
    EXPECT_NEAR(optimizer.minimize(line, {0.7}, {}).x[0], 2, 1e-2) << optimizer.name;
  }
}

TEST(Optimizers, EveryOneTakesEveryMetricAndBothStrategies) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*CookTorrance(m=0.2, ior=1.5)", 300);
  const LobeRequest diffuse{findModel("Lambertian"), {}, {}, {}};
  const LobeRequest specular{findModel("CookTorrance"), {{"ior", 1.5}}, {}, {}};
  for (const Optimizer& optimizer : allOptimizers())
    for (const Metric& metric : allMetrics())
      for (const Strategy strategy : {Strategy::Separable, Strategy::Joint}) {
        FitOptions options;
        options.optimizer = optimizer.name;
        options.metric = metric.name;
        options.strategy = strategy;
        if (strategy == Strategy::Separable && !metric.quadratic) {
          EXPECT_THROW(fit(target, {diffuse, specular}, options), Error) << metric.name;
          continue;
        }
        const FitReport report = fit(target, {diffuse, specular}, options);
        EXPECT_LT(report.error, 1e-3 * report.zeroModel.at(report.metric))
            << optimizer.name << " " << metric.name << " " << report.strategy << ": " << report.termination;
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
