#pragma once
#include <brdf/fit/Optimizer.h>

#include <nlopt.h>

namespace brdf {

/// A method of NLopt (S. G. Johnson, "The NLopt nonlinear-optimization package") and how it is run here.
struct NloptMethod {
  enum class Kind {
    ByValues,       ///< local, asks for values of the squared error only
    ByDerivatives,  ///< local, asks for its gradient 2 J'r too
    Global          ///< searches the whole search box
  };
  nlopt_algorithm algorithm;
  Kind kind;
  nlopt_algorithm local = NLOPT_NUM_ALGORITHMS;  ///< the local method that a global one calls, if any
};

/// Runs the method on coordinates in which the search box (CostFunction::searchBox) is the unit cube and on the squared
/// error as a part of that at the start, so that units matter to no method. Every point is inside the bounds. A
/// roundoff-limited run is an outcome: converged where a Gauss-Newton step foresees no more than a ten thousandth less.
/// Global methods throw Error::Kind::Value where the search box is not finite.
OptimizerResult minimizeByNlopt(const NloptMethod& method, CostFunction& cost, std::vector<double> start,
                                const OptimizerOptions& options);

}  // namespace brdf
