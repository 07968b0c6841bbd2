#include <brdf/base/Text.h>
#include <brdf/fit/BoxQuadratic.h>
#include <brdf/fit/Optimizer.h>

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

/// By how much the quadratic model lowers the squared error over a step.
double predictedReduction(const NormalEquations& equations, const std::vector<double>& step) {
  const std::size_t n = step.size();
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double row = 2 * equations.gradient[i];
    for (std::size_t j = 0; j < n; ++j) row += equations.matrix[i * n + j] * step[j];
    sum -= row * step[i];
  }
  return sum;
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
  double damping = 1e-3, growth = 2;
  std::vector<double> lowest(n), highest(n), right(n), matrix, trial(n);
  while (result.iterations < options.maximumIterations) {
    if (current.squaredError <= roundingFloor) return finish(true, "exact to rounding");
    matrix = current.matrix;
    for (std::size_t i = 0; i < n; ++i) {
      matrix[i * n + i] *= 1 + damping;
      right[i] = -current.gradient[i];
      lowest[i] = lower[i] - result.x[i];
      highest[i] = upper[i] - result.x[i];
    }
    const std::vector<double> step = minimizeInBox(matrix, right, lowest, highest);
    const double predicted = predictedReduction(current, step);
    if (!(predicted > 4 * std::numeric_limits<double>::epsilon() * current.squaredError))
      return finish(true, "no step lowers the error: the gradient inside the bounds is zero");

    double largestStep = 0;  // relative for what is large, absolute in units of 1/1000 of the box for what is near 0
    for (std::size_t i = 0; i < n; ++i) {
      trial[i] = std::clamp(result.x[i] + step[i], lower[i], upper[i]);
      const double width = upper[i] - lower[i];
      const double unit = std::abs(result.x[i]) + 1e-3 * (std::isfinite(width) ? width : 1.0);
      largestStep = std::max(largestStep, std::abs(step[i]) / std::max(unit, std::numeric_limits<double>::min()));
    }
    NormalEquations next = cost.normalEquations(trial);
    ++result.evaluations;
    ++result.iterations;
    const double reduction = current.squaredError - next.squaredError;
    if (allFinite(next) && reduction > 0) {
      const double gain = reduction / predicted;
      const double before = current.squaredError;
      damping = std::max(1e-15, damping * std::max(1.0 / 3, 1 - std::pow(2 * gain - 1, 3)));
      growth = 2;
      result.x = trial;
      current = std::move(next);
      result.squaredError = current.squaredError;
      if (options.progress && !options.progress(result.squaredError)) {
        result.stopped = true;
        return finish(false, "stopped on request");
      }
      if (reduction <= options.tolerance * before &&
          (largestStep <= stepTolerance || reduction <= 1e-6 * options.tolerance * before))
        return finish(true, "the last step changed the squared error by less than " +
                                formatNumber(options.tolerance, 2) + " of it");
    } else {
      if (predicted <= 1e-6 * options.tolerance * current.squaredError)
        return finish(true, "no step lowers the error beyond rounding");
      damping *= growth;
      growth *= 2;
      if (options.progress && !options.progress(result.squaredError)) {
        result.stopped = true;
        return finish(false, "stopped on request");
      }
      if (damping > 1e30) return finish(false, "no step lowers the error although the gradient is not zero");
    }
  }
  return finish(false, "the limit of " + std::to_string(options.maximumIterations) + " iterations was reached");
}

}  // namespace brdf
