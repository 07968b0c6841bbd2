#pragma once
#include <brdf/geometry/Directions.h>

#include <string>
#include <string_view>

namespace brdf {

/// A parametrisation of direction pairs as the ALTA library names it (its class `params`, enumeration `input`).
struct AltaParameters {
  std::string_view name;
  std::size_t dimension;
  bool isotropic;
  /// The pair at `dimension` coordinates; not finite where they lie outside their domain.
  DirectionPair (*pair)(const double* x);
  /// What the missing coordinates are set to; empty where the coordinates determine an isotropic or full pair.
  std::string_view completed;
};

/// The parametrisation called `name`, or throws Error::Kind::Format: unknown, or known and refused with the reason.
const AltaParameters& altaParameters(std::string_view name, const std::string& where);

}  // namespace brdf
