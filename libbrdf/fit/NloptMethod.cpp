#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/BoxQuadratic.h>
#include <brdf/fit/NloptMethod.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>

namespace brdf {
namespace {

// Evaluations for each iteration that Levenberg-Marquardt would get, by kind: it sees a whole model of the function at
// each of its points, a gradient is less, a value less still.
constexpr std::size_t kEvaluationsPerIteration[] = {20, 5, 20};
// What the methods are told where the function has no value, in units of the value at the start: large, and its square
// is still finite.
constexpr double kNoValue = 1e100;
// The first step of the methods without derivatives, as a part of the search box.
constexpr double kFirstStep = 0.1;
// A run that rounding stopped has converged where a Gauss-Newton step foresees no more than this part less.
constexpr double kForeseenAtMinimum = 1e-4;

/// One coordinate as the method sees it: u = (x - origin) / unit, 0 to 1 over the search box.
struct Scaled {
  std::size_t index;  ///< in the cost's x
  double origin, unit, lower, upper;

  double toX(double u) const { return std::clamp(origin + unit * u, lower, upper); }
  double toU(double x) const { return (x - origin) / unit; }
};

/// PRAXIS knows no bounds: its variables run over all numbers and are folded smoothly into [a, b], as MINUIT does (F.
/// James, "MINUIT Reference Manual", CERN Program Library D506, parameters with limits).
double foldedInto(double t, double a, double b) {
  if (std::isfinite(a) && std::isfinite(b)) return a + 0.5 * (b - a) * (std::sin(t) + 1);
  if (std::isfinite(a)) return a - 1 + std::sqrt(t * t + 1);
  if (std::isfinite(b)) return b + 1 - std::sqrt(t * t + 1);
  return t;
}
double unfolded(double u, double a, double b) {
  if (std::isfinite(a) && std::isfinite(b)) return std::asin(std::clamp(2 * (u - a) / (b - a) - 1, -1.0, 1.0));
  const double distance = 1 + (std::isfinite(a) ? u - a : b - u);
  if (std::isfinite(a) || std::isfinite(b)) return std::sqrt(std::max(0.0, distance * distance - 1));
  return u;
}

/// What NLopt's callback needs, and the best point seen: NLopt's own answer is not always the best that it evaluated.
struct Objective {
  CostFunction& cost;
  const OptimizerOptions& options;
  const std::vector<Scaled>& variables;
  bool folded;
  nlopt_opt optimizer;
  OptimizerResult result;
  std::vector<double> x;
  double unit = 1;               ///< of the squared error
  std::exception_ptr exception;  ///< thrown in the callback: it must not pass through C

  double valueAt(const double* u, double* gradient) {
    // Some methods finish a round of evaluations before they look whether they are to stop.
    if (result.stopped) return kNoValue;
    for (std::size_t k = 0; k < variables.size(); ++k) {
      const Scaled& v = variables[k];
      x[v.index] = v.toX(folded ? foldedInto(u[k], v.toU(v.lower), v.toU(v.upper)) : u[k]);
    }
    NormalEquations equations;
    if (gradient)
      equations = cost.normalEquations(x);
    else
      equations.squaredError = cost.squaredError(x);
    ++result.evaluations;
    ++result.iterations;
    if (equations.squaredError < result.squaredError) {
      result.squaredError = equations.squaredError;
      result.x = x;
    }
    if (options.progress && !options.progress(result.squaredError)) {
      result.stopped = true;
      nlopt_force_stop(optimizer);
    }
    const bool usable = std::isfinite(equations.squaredError);
    for (std::size_t k = 0; gradient && k < variables.size(); ++k) {
      const double slope = usable ? 2 * equations.gradient[variables[k].index] * variables[k].unit / unit : 0;
      gradient[k] = std::isfinite(slope) ? slope : 0;
    }
    return usable ? std::min(kNoValue, equations.squaredError / unit) : kNoValue;
  }

  static double call(unsigned count, const double* u, double* gradient, void* data) {
    auto& self = *static_cast<Objective*>(data);
    if (gradient) std::fill_n(gradient, count, 0.0);
    if (self.exception) return kNoValue;
    try {
      return self.valueAt(u, gradient);
    } catch (...) {
      self.exception = std::current_exception();
      nlopt_force_stop(self.optimizer);
      return kNoValue;
    }
  }
};

std::string outcome(nlopt_result code) {
  switch (code) {
    case NLOPT_STOPVAL_REACHED:
      return "exact to rounding";
    case NLOPT_FTOL_REACHED:
      return "the squared error changes by less than the tolerance";
    case NLOPT_XTOL_REACHED:
      return "the parameters change by less than the tolerance";
    case NLOPT_MAXEVAL_REACHED:
      return "the limit of evaluations was reached";
    case NLOPT_ROUNDOFF_LIMITED:
      return "rounding limits further progress";
    case NLOPT_FORCED_STOP:
      return "stopped on request";
    case NLOPT_FAILURE:
      return "the method finds no better point along its direction";
    case NLOPT_SUCCESS:
      return "the gradient inside the bounds is zero";
    default:
      return "NLopt: " + std::string(nlopt_result_to_string(code));
  }
}

/// The part of the squared error that an undamped Gauss-Newton step inside the bounds foresees to remove.
double foreseenReduction(CostFunction& cost, const std::vector<double>& x) {
  const NormalEquations equations = cost.normalEquations(x);
  const std::size_t n = x.size();
  std::vector<double> right(n), lower(n), upper(n);
  for (std::size_t i = 0; i < n; ++i) {
    right[i] = -equations.gradient[i];
    lower[i] = cost.lower()[i] - x[i];
    upper[i] = cost.upper()[i] - x[i];
  }
  const std::vector<double> step = minimizeInBox(equations.matrix, right, lower, upper);
  double reduction = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double row = 2 * equations.gradient[i];
    for (std::size_t j = 0; j < n; ++j) row += equations.matrix[i * n + j] * step[j];
    reduction -= row * step[i];
  }
  return reduction / equations.squaredError;
}

std::vector<Scaled> scaledVariables(const NloptMethod& method, const CostFunction& cost,
                                    const std::vector<double>& start) {
  const SearchBox box = cost.searchBox(start);
  const bool global = method.kind == NloptMethod::Kind::Global;
  std::vector<Scaled> variables;
  for (std::size_t i = 0; i < start.size(); ++i) {
    double lower = cost.lower()[i], upper = cost.upper()[i];
    if (!(lower < upper)) continue;  // a variable without room is left where it is
    const double width = box.upper[i] - box.lower[i];
    if (global && !std::isfinite(width))
      throw Error(Error::Kind::Value,
                  {"a global search needs a finite box", nlopt_algorithm_to_string(method.algorithm),
                   "variable " + std::to_string(i) + " from " + formatNumber(box.lower[i]) + " to " +
                       formatNumber(box.upper[i]),
                   "finite bounds"});
    Scaled variable{i, box.lower[i], width, lower, upper};
    if (global) {
      variable.lower = box.lower[i];
      variable.upper = box.upper[i];
    }
    if (!std::isfinite(width)) {
      variable.origin = 0;
      variable.unit = std::max(std::abs(start[i]), 1e-3);
    }
    if (!(variable.unit > 0)) variable.unit = std::isfinite(upper - lower) ? upper - lower : 1;
    if (!(variable.lower < variable.upper)) continue;
    variables.push_back(variable);
  }
  return variables;
}

struct Destroy {
  void operator()(nlopt_opt optimizer) const { nlopt_destroy(optimizer); }
};
using NloptPointer = std::unique_ptr<nlopt_opt_s, Destroy>;

}  // namespace

OptimizerResult minimizeByNlopt(const NloptMethod& method, CostFunction& cost, std::vector<double> start,
                                const OptimizerOptions& options) {
  for (std::size_t i = 0; i < start.size(); ++i) start[i] = std::clamp(start[i], cost.lower()[i], cost.upper()[i]);
  const std::vector<Scaled> variables = scaledVariables(method, cost, start);
  OptimizerResult atStart;
  atStart.x = start;
  atStart.squaredError = cost.squaredError(start);
  atStart.evaluations = 1;
  if (!std::isfinite(atStart.squaredError)) atStart.squaredError = std::numeric_limits<double>::infinity();
  const double roundingFloor = 1e-28 * cost.scale();
  if (variables.empty() || atStart.squaredError <= roundingFloor) {
    atStart.converged = std::isfinite(atStart.squaredError);
    atStart.termination = variables.empty() ? "nothing to optimise but scale factors" : "exact to rounding";
    return atStart;
  }

  // The quadratic models of BOBYQA and NEWUOA need two variables: a lone one gets a companion without influence.
  const bool needsTwo = method.algorithm == NLOPT_LN_BOBYQA || method.algorithm == NLOPT_LN_NEWUOA_BOUND;
  const std::size_t dimension = std::max<std::size_t>(variables.size(), needsTwo ? 2 : 1);
  const bool folded = method.algorithm == NLOPT_LN_PRAXIS;
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> lower(dimension, folded ? -infinity : 0), upper(dimension, folded ? infinity : 1);
  std::vector<double> step(dimension, kFirstStep), u(dimension, 0.5);
  for (std::size_t k = 0; k < variables.size(); ++k) {
    const Scaled& v = variables[k];
    const double a = v.toU(v.lower), b = v.toU(v.upper);
    u[k] = std::clamp(v.toU(start[v.index]), a, b);
    if (folded) {
      u[k] = unfolded(u[k], a, b);
    } else {
      lower[k] = a;
      upper[k] = b;
      step[k] = std::min(kFirstStep, 0.5 * (b - a));
    }
  }

  const NloptPointer optimizer(nlopt_create(method.algorithm, static_cast<unsigned>(dimension)));
  const auto limit = static_cast<int>(std::min<std::size_t>(
      1 + kEvaluationsPerIteration[static_cast<int>(method.kind)] * options.maximumIterations, 1'000'000'000));
  Objective objective{cost, options, variables, folded, optimizer.get(), atStart, start, 1, {}};
  if (atStart.squaredError > 0 && std::isfinite(atStart.squaredError)) objective.unit = atStart.squaredError;
  nlopt_set_min_objective(optimizer.get(), Objective::call, &objective);
  nlopt_set_lower_bounds(optimizer.get(), lower.data());
  nlopt_set_upper_bounds(optimizer.get(), upper.data());
  nlopt_set_initial_step(optimizer.get(), step.data());
  nlopt_set_maxeval(optimizer.get(), limit);
  nlopt_set_stopval(optimizer.get(), roundingFloor / objective.unit);
  const auto setTolerances = [&](nlopt_opt which) {
    // Two corners of a simplex of equal height say nothing: methods that see values only stop by their step.
    if (method.kind != NloptMethod::Kind::ByValues) nlopt_set_ftol_rel(which, options.tolerance);
    nlopt_set_xtol_abs1(which, 0.01 * std::sqrt(options.tolerance));
  };
  setTolerances(optimizer.get());
  NloptPointer local;
  if (method.local != NLOPT_NUM_ALGORITHMS) {
    local.reset(nlopt_create(method.local, static_cast<unsigned>(dimension)));
    setTolerances(local.get());
    nlopt_set_local_optimizer(optimizer.get(), local.get());
  }
  nlopt_srand(static_cast<unsigned long>(options.seed));

  double value = 0;
  const nlopt_result code = nlopt_optimize(optimizer.get(), u.data(), &value);
  if (objective.exception) std::rethrow_exception(objective.exception);
  OptimizerResult result = std::move(objective.result);
  result.termination = outcome(code);
  result.converged = code > 0 && code != NLOPT_MAXEVAL_REACHED;
  if (code == NLOPT_ROUNDOFF_LIMITED || code == NLOPT_FAILURE)
    result.converged = foreseenReduction(cost, result.x) <= kForeseenAtMinimum;
  result.converged = result.converged && std::isfinite(result.squaredError);
  return result;
}

}  // namespace brdf
