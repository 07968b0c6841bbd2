#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace brdf {

/// Families of parallel lines, each repeating after a spacing, on one rectangular tile.
struct PlaneWaves {
  double periodX = 0, periodY = 0;  ///< micrometres; 0 along an axis that no family varies along
  /// Spacings of each family along x and y within the tile: its phase, in spacings, is
  /// turns[k][0] x / periodX + turns[k][1] y / periodY.
  std::vector<std::array<long, 2>> turns;

  double spacing(std::size_t k) const;  ///< as it became, micrometres
  double azimuth(std::size_t k) const;  ///< of the direction across the lines, degrees in (-180, 180]
  /// The number of distinct lines of a family: the tile's edges join the others to them.
  std::size_t lines(std::size_t k) const;
};

/// The tile on which families of the spacing `spacing`, across which the azimuths are `azimuths` (degrees), repeat with
/// at least `leastLines` lines each. One family, and any whose azimuths allow it, is kept exactly; else spacings and
/// azimuths give way a little: of the tiles of up to 64 spacings along each axis the one that changes them least.
PlaneWaves commensurateTile(double spacing, std::span<const double> azimuths, std::size_t leastLines);

}  // namespace brdf
