#pragma once
#include <string_view>

namespace brdf {

/// What a model does not keep, by its authors' choice or its formula's nature. Models that are not listed are held to
/// everything.
struct Declaration {
  std::string_view model;
  const char* unboundedEnergy = nullptr;  ///< why its albedo may exceed 1; null: it may not
  double relative = 1e-12;                ///< error allowed in double against the exact value
  double relativeNarrow = 1e-5;           ///< in float, on the processor and in GLSL
  /// A term passes through zero, where it is clamped: beside it, errors are measured in units of the last place of the
  /// lobe's peak.
  bool passesThroughZero = false;
  double variance = 10;  ///< bound of the sampler's relative variance; cosine sampling of a sharp lobe has thousands
};

/// What `model` declares; the defaults for one that is not listed.
const Declaration& declarationOf(std::string_view model);

}  // namespace brdf
