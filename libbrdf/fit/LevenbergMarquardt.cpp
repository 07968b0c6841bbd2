#include <brdf/base/Text.h>
#include <brdf/fit/BoxQuadratic.h>
#include <brdf/fit/Optimizer.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

// Normal equations carry nothing finer than this part of their diagonal: what lies below is damped away, evenly.
constexpr double kRounding = 1e-12;
// A step is taken where it gains this part of what the model foresees; below a quarter the next is shorter, above three
// quarters it may be longer (Moré 1978, "The Levenberg-Marquardt algorithm: implementation and theory", section 4).
constexpr double kAcceptedGain = 1e-4, kPoorGain = 0.25, kGoodGain = 0.75;

bool allFinite(const NormalEquations& equations) {
  const auto finite = [](double value) { return std::isfinite(value); };
  return finite(equations.squaredError) && std::ranges::all_of(equations.gradient, finite) &&
         std::ranges::all_of(equations.matrix, finite);
}

using Vector = Eigen::VectorXd;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<const Vector> mapped(const std::vector<double>& v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}
Eigen::Map<const Matrix> mapped(const std::vector<double>& m, std::size_t n) {
  return {m.data(), static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n)};
}

/// By how much a quadratic model lowers the squared error over a step.
double predictedReduction(const Vector& gradient, const Matrix& hessian, const Vector& step) {
  return -step.dot(2 * gradient + hessian * step);
}

/// What the Gauss-Newton matrix leaves out: the sum of residuals times their second derivatives, learnt from the
/// changes of the exact gradient by symmetric rank-one updates (the idea of Dennis, Gay, Welsch 1981, "An Adaptive
/// Nonlinear Least-Squares Algorithm", NL2SOL, doi:10.1145/355958.355965). It is used while it predicts the error better
/// and the model with it is positive definite. Where a model cannot describe the data the residuals are large and
/// Gauss-Newton alone crawls.
struct SecondOrderPart {
  Matrix value;
  bool used = false;

  void learn(const Vector& step, const Vector& gradientChange, const Matrix& gaussNewton, const Vector& unit) {
    const Vector wanted = gradientChange - gaussNewton * step;
    // Sized down first: a large old value would outlive the residuals that it came from.
    const double along = std::abs(step.dot(value * step));
    if (along > 0) value *= std::min(1.0, std::abs(step.dot(wanted)) / along);
    const Vector error = wanted - value * step;
    const double product = error.dot(step);
    // In units of the diagonal, so that the test does not depend on the parameters' own.
    if (std::abs(product) > 1e-8 * error.cwiseProduct(unit).norm() * step.cwiseQuotient(unit).norm())
      value += error * error.transpose() / product;
  }
  void compare(double actual, double predictedPlain, double predictedFull) {
    used = std::abs(actual - predictedFull) < std::abs(actual - predictedPlain);
  }
};

/// Safely so, in units of the diagonal.
bool isPositiveDefinite(const Matrix& matrix, const Vector& unit) {
  const Matrix scaled = unit.asDiagonal() * matrix * unit.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Matrix>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[0] > 1e-10;
}

/// The quadratic model of the error around a point, and the box that a step may use.
struct StepProblem {
  Matrix model;
  Vector diagonal;  ///< the squared units in which steps are measured
  std::vector<double> right, lowest, highest;

  Vector step(double damping) const {
    Matrix damped = model;
    damped.diagonal() += damping * diagonal;
    const auto n = static_cast<std::size_t>(damped.rows());
    const std::vector<double> numbers = minimizeInBox({damped.data(), n * n}, right, lowest, highest);
    return mapped(numbers);
  }
  double length(const Vector& step) const { return std::sqrt(step.cwiseAbs2().dot(diagonal)); }

  /// The step of about the length `radius` (a tenth more or less), by the damping that gives it; `damping` enters as a
  /// guess. `undamped` is longer.
  Vector stepOfLength(double radius, const Vector& undamped, double& damping) const {
    // Along the way the reciprocal of the length is nearly linear in the damping (Hebden 1973; Moré 1978, section 5).
    double low = 0, lowReciprocal = 1 / length(undamped), high = std::numeric_limits<double>::infinity();
    damping = std::max(damping, 1e-10);
    Vector result = undamped;
    for (int round = 0; round < 40; ++round) {
      result = step(damping);
      const double reciprocal = 1 / length(result);
      if (std::abs(reciprocal * radius - 1) <= 0.1) break;
      double next = low + (damping - low) * (1 / radius - lowReciprocal) / (reciprocal - lowReciprocal);
      if (reciprocal * radius > 1) {
        high = damping;
      } else {
        low = damping;
        lowReciprocal = reciprocal;
      }
      if (!(next > low && next < high))
        next = std::isfinite(high) ? std::sqrt(std::max(low, 1e-3 * high) * high) : 10 * damping;
      damping = next;
    }
    return result;
  }
};

/// How far the first step may go in each variable: across half of the search box, or as far as its value is from 0.
Vector firstReach(const CostFunction& cost, const std::vector<double>& start) {
  const SearchBox box = cost.searchBox(start);
  Vector reach(static_cast<Eigen::Index>(start.size()));
  for (std::size_t i = 0; i < start.size(); ++i) {
    const double width = box.upper[i] - box.lower[i];
    reach[static_cast<Eigen::Index>(i)] = std::isfinite(width) ? 0.5 * width : std::max(std::abs(start[i]), 1e-3);
  }
  return reach;
}

}  // namespace

OptimizerResult levenbergMarquardt(CostFunction& cost, std::vector<double> start, const OptimizerOptions& options) {
  const std::vector<double>&lower = cost.lower(), &upper = cost.upper();
  const std::size_t n = start.size();
  OptimizerResult result;
  result.x = std::move(start);
  for (std::size_t i = 0; i < n; ++i) result.x[i] = std::clamp(result.x[i], lower[i], upper[i]);
  const auto finish = [&](bool converged, std::string reason) {
    result.converged = converged;
    result.termination = std::move(reason);
    return result;
  };

  NormalEquations current = cost.normalEquations(result.x);
  result.evaluations = 1;
  result.squaredError = current.squaredError;
  if (!allFinite(current)) {
    result.squaredError = std::numeric_limits<double>::infinity();
    return finish(false, "the error is not finite at the start");
  }
  if (n == 0) return finish(true, "nothing to optimise but scale factors");

  const double roundingFloor = 1e-28 * cost.scale();
  const double stepTolerance = 0.01 * std::sqrt(options.tolerance);
  const auto size = static_cast<Eigen::Index>(n);
  SecondOrderPart second{Matrix::Zero(size, size)};
  // Units of the variables: the largest slopes seen, so that one that loses its influence does not run away.
  StepProblem problem{{}, Vector::Zero(size), std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  const Vector reach = firstReach(cost, result.x);
  double radius = 0, damping = 0;
  std::vector<double> trial(n);
  while (result.iterations < options.maximumIterations) {
    if (current.squaredError <= roundingFloor) return finish(true, "exact to rounding");
    const Eigen::Map<const Matrix> gaussNewton = mapped(current.matrix, n);
    const Eigen::Map<const Vector> gradient = mapped(current.gradient);
    problem.diagonal = problem.diagonal.cwiseMax(gaussNewton.diagonal());
    if (result.iterations == 0) radius = problem.length(reach);
    const Vector unit = problem.diagonal.unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.0; });
    problem.model = gaussNewton;
    if (second.used && isPositiveDefinite(gaussNewton + second.value, unit)) problem.model += second.value;
    problem.model.diagonal() += kRounding * gaussNewton.diagonal();
    for (std::size_t i = 0; i < n; ++i) {
      problem.right[i] = -current.gradient[i];
      problem.lowest[i] = lower[i] - result.x[i];
      problem.highest[i] = upper[i] - result.x[i];
    }
    Vector step = problem.step(0);
    if (!(predictedReduction(gradient, problem.model, step) >
          4 * std::numeric_limits<double>::epsilon() * current.squaredError))
      return finish(true, "the error is at its minimum: the gradient inside the bounds is zero");
    if (problem.length(step) > 1.1 * radius) step = problem.stepOfLength(radius, step, damping);
    const double length = problem.length(step), predicted = predictedReduction(gradient, problem.model, step);

    double largestStep = 0;  // relative for what is large, absolute in units of 1/1000 of the box for what is near 0
    for (std::size_t i = 0; i < n; ++i) {
      const double change = step[static_cast<Eigen::Index>(i)];
      trial[i] = std::clamp(result.x[i] + change, lower[i], upper[i]);
      const double width = upper[i] - lower[i];
      const double magnitude = std::abs(result.x[i]) + 1e-3 * (std::isfinite(width) ? width : 1.0);
      largestStep = std::max(largestStep, std::abs(change) / std::max(magnitude, std::numeric_limits<double>::min()));
    }
    NormalEquations next = cost.normalEquations(trial);
    ++result.evaluations;
    ++result.iterations;
    const bool usable = allFinite(next);
    const double before = current.squaredError, reduction = before - next.squaredError;
    const double gain = usable ? reduction / predicted : -1;
    const bool accepted = gain > kAcceptedGain;
    if (usable && next.squaredError < 4 * before) {
      const double plain = predictedReduction(gradient, gaussNewton, step);
      const double full = predictedReduction(gradient, gaussNewton + second.value, step);
      second.compare(reduction, plain, full);
      second.learn(step, mapped(next.gradient) - gradient, accepted ? mapped(next.matrix, n) : gaussNewton, unit);
    }
    if (gain < kPoorGain) {
      // The length at which a parabola through what was found has its minimum, a tenth to a half of the last.
      const double slope = gradient.dot(step);
      const double lowest = usable ? slope / (2 * slope + reduction) : 0;
      radius = length * std::clamp(std::isfinite(lowest) ? lowest : 0.1, 0.1, 0.5);
    } else if (gain > kGoodGain) {
      radius = std::max(radius, 2 * length);
    }
    if (accepted) {
      result.x = trial;
      result.squaredError = next.squaredError;
      current = std::move(next);
    }
    if (options.progress && !options.progress(result.squaredError)) {
      result.stopped = true;
      return finish(false, "stopped on request");
    }
    if (accepted && reduction <= options.tolerance * before &&
        (largestStep <= stepTolerance || reduction <= 1e-6 * options.tolerance * before))
      return finish(true, "the last step changed the squared error by less than " + formatNumber(options.tolerance, 2) +
                              " of it");
    // Residuals carry the rounding of the values they are differences of.
    const double rounding = std::numeric_limits<double>::epsilon() * std::sqrt(before * cost.scale());
    if (!accepted && predicted <= std::max(rounding, 1e-6 * options.tolerance * before))
      return finish(true, "no step lowers the error beyond rounding");
    if (!(largestStep > 1e-30)) return finish(false, "no step lowers the error although the gradient is not zero");
  }
  return finish(false, "the limit of " + std::to_string(options.maximumIterations) + " iterations was reached");
}

}  // namespace brdf
