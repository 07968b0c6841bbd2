#include <brdf/base/Text.h>
#include <brdf/fit/BoxQuadratic.h>
#include <brdf/fit/Optimizer.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

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
/// changes of the exact gradient by symmetric rank-one updates, and used only while it predicts the error better (the
/// idea of Dennis, Gay, Welsch 1981, "An Adaptive Nonlinear Least-Squares Algorithm", NL2SOL). Where a model cannot
/// describe the data the residuals are large and Gauss-Newton alone crawls.
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

/// The least damping, in units of the diagonal, that makes hessian + damping * diagonal safely positive definite.
double dampingFor(const Matrix& hessian, const Vector& unit) {
  const Matrix scaled = unit.asDiagonal() * hessian * unit.asDiagonal();
  const double lowest = Eigen::SelfAdjointEigenSolver<Matrix>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[0];
  return lowest > 1e-10 ? 0 : 1e-3 - 1.5 * lowest;
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
  double damping = 1e-3, growth = 2;
  std::vector<double> lowest(n), highest(n), right(n), trial(n);
  while (result.iterations < options.maximumIterations) {
    if (current.squaredError <= roundingFloor) return finish(true, "exact to rounding");
    const Eigen::Map<const Matrix> gaussNewton = mapped(current.matrix, n);
    const Eigen::Map<const Vector> gradient = mapped(current.gradient);
    const Vector diagonal = gaussNewton.diagonal();
    const Vector unit = diagonal.unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.0; });
    Matrix model = gaussNewton;
    if (second.used) model += second.value;
    Matrix damped = model;
    damped.diagonal() += (damping + (second.used ? dampingFor(model, unit) : 0)) * diagonal;
    for (std::size_t i = 0; i < n; ++i) {
      right[i] = -current.gradient[i];
      lowest[i] = lower[i] - result.x[i];
      highest[i] = upper[i] - result.x[i];
    }
    const std::vector<double> stepNumbers = minimizeInBox({damped.data(), n * n}, right, lowest, highest);
    const Eigen::Map<const Vector> step = mapped(stepNumbers);
    const double predicted = predictedReduction(gradient, model, step);
    if (!(predicted > 4 * std::numeric_limits<double>::epsilon() * current.squaredError))
      return finish(true, "the error is at its minimum: the gradient inside the bounds is zero");

    double largestStep = 0;  // relative for what is large, absolute in units of 1/1000 of the box for what is near 0
    for (std::size_t i = 0; i < n; ++i) {
      trial[i] = std::clamp(result.x[i] + stepNumbers[i], lower[i], upper[i]);
      const double width = upper[i] - lower[i];
      const double magnitude = std::abs(result.x[i]) + 1e-3 * (std::isfinite(width) ? width : 1.0);
      largestStep =
          std::max(largestStep, std::abs(stepNumbers[i]) / std::max(magnitude, std::numeric_limits<double>::min()));
    }
    NormalEquations next = cost.normalEquations(trial);
    ++result.evaluations;
    ++result.iterations;
    const bool usable = allFinite(next);
    const double before = current.squaredError, reduction = before - next.squaredError;
    const bool accepted = usable && reduction > 0;
    if (usable && next.squaredError < 4 * before) {
      const double plain = predictedReduction(gradient, gaussNewton, step);
      const double full = predictedReduction(gradient, gaussNewton + second.value, step);
      second.compare(reduction, plain, full);
      second.learn(step, mapped(next.gradient) - gradient, accepted ? mapped(next.matrix, n) : gaussNewton, unit);
    }
    if (accepted) {
      damping = std::max(1e-15, damping * std::max(1.0 / 3, 1 - std::pow(2 * reduction / predicted - 1, 3)));
      growth = 2;
      result.x = trial;
      result.squaredError = next.squaredError;
      current = std::move(next);
    } else {
      damping *= growth;
      growth *= 2;
    }
    if (options.progress && !options.progress(result.squaredError)) {
      result.stopped = true;
      return finish(false, "stopped on request");
    }
    if (accepted && reduction <= options.tolerance * before &&
        (largestStep <= stepTolerance || reduction <= 1e-6 * options.tolerance * before))
      return finish(true, "the last step changed the squared error by less than " + formatNumber(options.tolerance, 2) +
                              " of it");
    if (!accepted && predicted <= 1e-6 * options.tolerance * before)
      return finish(true, "no step lowers the error beyond rounding");
    if (damping > 1e30) return finish(false, "no step lowers the error although the gradient is not zero");
  }
  return finish(false, "the limit of " + std::to_string(options.maximumIterations) + " iterations was reached");
}

}  // namespace brdf
