#pragma once
// Internal to libbrdf/check.
#include <brdf/check/Declarations.h>
#include <brdf/check/Tally.h>

namespace brdf {

/// Errors as shares of what is allowed, and the conditioning with respect to the directions.
struct AccuracyTallies {
  Tally wide{"double_accuracy", 1}, narrow{"float_accuracy", 1},
      conditioning{"conditioning", kAnything,
                   "a property of the formula: what rounding the directions to float changes"};
};

/// `pairs` for double; `aboveHorizon` for float (at soft parameters) and conditioning.
void tallyAgainstExtended(const Model& model, const ParameterCase& parameters, const CheckPairs& pairs,
                          const CheckPairs& aboveHorizon, const std::string& label, AccuracyTallies& tallies);

/// Exact derivatives against differences, the parameters moved a little off the hard bounds.
void tallyDerivative(const Model& model, const ParameterCase& parameters, const CheckPairs& pairs, Tally& tally);

}  // namespace brdf
