#include "Workshop.h"

#include <algorithm>
#include <cmath>

namespace workshop {

brdf::OptimizerResult compassSearch(brdf::CostFunction& cost, std::vector<double> start,
                                    const brdf::OptimizerOptions& options) {
  const brdf::SearchBox box = cost.searchBox(start);
  const double shortest = 0.01 * std::sqrt(options.tolerance);  // in parts of the box
  brdf::OptimizerResult best{std::move(start)};
  best.squaredError = cost.squaredError(best.x);
  best.evaluations = 1;
  double step = 0.25;
  while (step > shortest && best.evaluations < 20 * options.maximumIterations * best.x.size()) {
    bool better = false;
    for (std::size_t axis = 0; axis < best.x.size() && !better; ++axis)
      for (const double sign : {1.0, -1.0}) {
        auto x = best.x;
        const double length = std::min(box.upper[axis] - box.lower[axis], 1e3);
        x[axis] = std::clamp(x[axis] + sign * step * length, cost.lower()[axis], cost.upper()[axis]);
        const double error = cost.squaredError(x);
        ++best.evaluations;
        if (!(error < best.squaredError)) continue;
        best.x = std::move(x);
        best.squaredError = error;
        better = true;
        break;
      }
    if (!better) step /= 2;
    ++best.iterations;
    if (options.progress && !options.progress(best.squaredError)) {
      best.stopped = true;
      best.termination = "stopped";
      return best;
    }
  }
  best.converged = step <= shortest;
  best.termination = best.converged ? "the step is below the tolerance" : "the evaluations are used up";
  return best;
}

}  // namespace workshop
