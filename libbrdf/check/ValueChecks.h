#pragma once
// Internal to libbrdf/check.
#include <brdf/check/Tally.h>

namespace brdf {

/// Errors as shares of what is allowed, and the conditioning with respect to the directions.
struct AccuracyTallies {
  explicit AccuracyTallies(const Model& model);

  double allowedWide, allowedNarrow;  ///< relative errors
  bool crossesZero;                   ///< see models/Declaration.h
  Tally wide, narrow, conditioning, parameters;
};

/// `pairs` for double; `aboveHorizon` for float (at soft parameters) and conditioning.
void tallyAgainstExtended(const Model& model, const ParameterCase& parameters, const CheckPairs& pairs,
                          const CheckPairs& aboveHorizon, const std::string& label, AccuracyTallies& tallies);

/// Exact derivatives against differences, the parameters moved a little off the hard bounds.
void tallyDerivative(const Model& model, const ParameterCase& parameters, const CheckPairs& pairs, Tally& tally);

}  // namespace brdf
