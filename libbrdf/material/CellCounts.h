#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>

#include <cstdint>
#include <optional>
#include <string>

namespace brdf {

/// How many cells of a table or grid, or samples of scattered data, hold what (material/CellState.h).
struct CellCounts {
  std::uint64_t measured = 0, extrapolated = 0, invalid = 0;
  std::uint64_t belowHorizon = 0;  ///< of all: directions not above the horizon
  std::string layout;              ///< "phi_d 180 x theta_d 90 x theta_h 90, half_difference"; empty when scattered
};

/// Empty for a BRDF without cells or samples of its own.
BRDF_EXPORT std::optional<CellCounts> countCells(const Brdf& brdf);

}  // namespace brdf
