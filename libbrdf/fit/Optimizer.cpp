#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/Fit.h>
#include <brdf/fit/Optimizer.h>

#include <nlopt.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

// The methods without derivatives see a function value where Levenberg-Marquardt sees a whole model of the function:
// they get this many times the evaluations.
constexpr std::size_t kEvaluationsPerIteration = 20;

/// What NLopt's callback needs, and the best point seen (NLopt's own answer is not always the best it evaluated).
struct Objective {
  CostFunction* cost;
  const OptimizerOptions* options;
  nlopt::opt* optimizer;
  OptimizerResult result;
  std::size_t dimension;

  double operator()(const std::vector<double>& x) {
    const double value = cost->squaredError({x.data(), dimension});
    ++result.evaluations;
    ++result.iterations;
    if (value < result.squaredError) {
      result.squaredError = value;
      result.x.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(dimension));
    }
    if (options->progress && !options->progress(result.squaredError)) {
      result.stopped = true;
      optimizer->force_stop();
    }
    // NLopt's methods compare values: one that is finite and large is safer than infinity.
    return std::isfinite(value) ? value : std::numeric_limits<double>::max() / 1e10;
  }
};

std::string outcome(nlopt::result code) {
  switch (code) {
    case nlopt::FTOL_REACHED:
      return "the squared error changes by less than the tolerance";
    case nlopt::XTOL_REACHED:
      return "the parameters change by less than the tolerance";
    case nlopt::MAXEVAL_REACHED:
      return "the limit of evaluations was reached";
    case nlopt::ROUNDOFF_LIMITED:
      return "rounding limits further progress";
    case nlopt::FORCED_STOP:
      return "stopped on request";
    default:
      return "the optimizer is content";
  }
}

OptimizerResult runNlopt(nlopt::algorithm algorithm, CostFunction& cost, std::vector<double> start,
                         const OptimizerOptions& options) {
  const std::size_t n = start.size();
  // The quadratic models of BOBYQA and NEWUOA need two variables: a lone one gets a companion without influence.
  const bool needsTwo = algorithm == nlopt::LN_BOBYQA || algorithm == nlopt::LN_NEWUOA_BOUND;
  const std::size_t dimension = std::max<std::size_t>(n, needsTwo ? 2 : 1);
  std::vector<double> lower = cost.lower(), upper = cost.upper(), step(dimension);
  lower.resize(dimension, 0.0);
  upper.resize(dimension, 1.0);
  start.resize(dimension, 0.5);
  for (std::size_t i = 0; i < dimension; ++i) {
    start[i] = std::clamp(start[i], lower[i], upper[i]);
    const double width = upper[i] - lower[i];
    step[i] = std::isfinite(width) ? 0.1 * width : 0.1 * std::max(std::abs(start[i]), 1e-3);
    if (!(step[i] > 0)) step[i] = 1e-3;  // a variable without room; NLopt asks for a step nevertheless
  }
  nlopt::opt optimizer(algorithm, static_cast<unsigned>(dimension));
  optimizer.set_lower_bounds(lower);
  optimizer.set_upper_bounds(upper);
  optimizer.set_initial_step(step);
  optimizer.set_ftol_rel(options.tolerance);
  optimizer.set_xtol_rel(0.01 * std::sqrt(options.tolerance));
  optimizer.set_maxeval(static_cast<int>(kEvaluationsPerIteration * options.maximumIterations));
  nlopt::srand(1);

  Objective objective{&cost, &options, &optimizer, {}, n};
  objective.result.x.assign(start.begin(), start.begin() + static_cast<std::ptrdiff_t>(n));
  objective.result.squaredError = std::numeric_limits<double>::infinity();
  optimizer.set_min_objective([](const std::vector<double>& x, std::vector<double>&,
                                 void* self) { return (*static_cast<Objective*>(self))(x); },
                              &objective);
  nlopt::result code = nlopt::ROUNDOFF_LIMITED;
  double value = 0;
  try {
    code = optimizer.optimize(start, value);
  } catch (const nlopt::roundoff_limited&) {
  } catch (const nlopt::forced_stop&) {
    code = nlopt::FORCED_STOP;
  }
  OptimizerResult result = std::move(objective.result);
  result.converged = code > 0 && code != nlopt::MAXEVAL_REACHED && std::isfinite(result.squaredError);
  if (code == nlopt::ROUNDOFF_LIMITED) result.converged = std::isfinite(result.squaredError);
  result.termination = outcome(code);
  return result;
}

template <nlopt::algorithm Algorithm>
OptimizerResult minimizeWith(CostFunction& cost, std::vector<double> start, const OptimizerOptions& options) {
  return runNlopt(Algorithm, cost, std::move(start), options);
}

constexpr Optimizer kOptimizers[] = {
    {"lm", "Levenberg-Marquardt in a box, streaming normal equations (ours)", true, levenbergMarquardt},
    {"cobyla", "COBYLA, Powell 1994 (NLopt)", false, minimizeWith<nlopt::LN_COBYLA>},
    {"bobyqa", "BOBYQA, Powell 2009 (NLopt)", false, minimizeWith<nlopt::LN_BOBYQA>},
    {"newuoa", "NEWUOA, Powell 2004, with bounds (NLopt)", false, minimizeWith<nlopt::LN_NEWUOA_BOUND>},
    {"praxis", "PRAXIS, Brent 1972 (NLopt)", false, minimizeWith<nlopt::LN_PRAXIS>},
    {"neldermead", "Nelder-Mead simplex 1965, with bounds (NLopt)", false, minimizeWith<nlopt::LN_NELDERMEAD>},
    {"sbplx", "Subplex, Rowan 1990, with bounds (NLopt)", false, minimizeWith<nlopt::LN_SBPLX>},
};

}  // namespace

CostFunction::~CostFunction() = default;

std::span<const Optimizer> allOptimizers() { return kOptimizers; }

std::vector<std::string> optimizerNames() {
  std::vector<std::string> names;
  for (const Optimizer& optimizer : kOptimizers) names.emplace_back(optimizer.name);
  return names;
}

const Optimizer& findOptimizer(std::string_view name) {
  const auto found = std::ranges::find(kOptimizers, name, &Optimizer::name);
  if (found == std::end(kOptimizers))
    throw Error(Error::Kind::Value, {"unknown optimizer", "optimizer", std::string(name), joined(optimizerNames())});
  return *found;
}

}  // namespace brdf
