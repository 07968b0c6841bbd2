#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// The regions of directions that errors are told apart by, as regionErrors() describes them.
inline constexpr std::array<std::string_view, 4> kDirectionRegions = {"near mirror", "retro", "grazing", "rest"};
/// Index into them of the region of a pair above the horizon.
BRDF_EXPORT std::size_t directionRegion(const Direction& wi, const Direction& wo);

/// How far one BRDF is from another in one region of directions.
struct RegionError {
  std::string region;       ///< "near mirror", "retro", "grazing" or "rest"
  double mean = 0;          ///< of |a - b| over pairs and channels, 1/sr
  double largest = 0;       ///< of |a - b|, 1/sr
  double relativeMean = 0;  ///< sum of |a - b| / sum of |b|; 0 where b is 0 everywhere
  std::uint64_t pairs = 0;  ///< compared: valid in both
  std::uint64_t lost = 0;   ///< valid in b, not in a
};

/// `a` against `b` at `count` pairs in each of the regions
/// - near mirror: the viewer within 15 degrees of the light's mirror direction;
/// - retro: the viewer within 15 degrees of the light;
/// - grazing: theta_i or theta_o above 75 degrees, in neither of these;
/// - rest: all others.
/// Pairs are a Halton sequence (bases 2, 3, 5, 7), the same every time: light and viewer uniform in projected solid
/// angle over the hemisphere, a viewer in a cone uniform in solid angle about its axis; those below the horizon are
/// left out. Throws Error::Kind::Value when the channels differ in number.
BRDF_EXPORT std::vector<RegionError> regionErrors(const Brdf& a, const Brdf& b, std::size_t count = 4096);

}  // namespace brdf
