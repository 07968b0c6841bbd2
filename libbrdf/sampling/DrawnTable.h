#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/GridBrdf.h>

#include <string>
#include <vector>

namespace brdf {

struct DrawnTableOptions {
  /// Relative error of resampling (DrawnTable::error) from which on no finer grid is tried; more than 0. A finer one
  /// takes longer to make: a scattered measurement of 1,500 samples 0.1 s at 5 degrees, 11 s at 1 degree.
  double tolerance = 0.02;
  /// What the device holds (gridShaderTexels): larger grids are resampled too.
  std::size_t maximumTexels = std::size_t{1} << 27;
  /// Of a grid that resampling makes.
  std::size_t maximumCells = std::size_t{3} << 20;
};

/// A BRDF as one grid in monochrome or RGB, which a shader can look up (material/GridShader.h).
struct DrawnTable {
  std::shared_ptr<const GridBrdf> grid;
  /// False: the grid is the BRDF itself, and what follows is 0 or empty.
  bool resampled = false;
  /// Of resampling: sum of |grid - BRDF| over sum of |BRDF|, both over 2048 pairs of directions, of the worst of the
  /// four regions of regionErrors(): near mirror, retro, grazing, rest.
  double error = 0;
  std::string region;  ///< that region
  /// By channel the value that a fiftieth of the pairs of directions stay below (uniform in projected solid angle),
  /// 1/sr: the diffuse part of a material that has one. Environment light on a constant needs no samples, so that only
  /// what differs from it has their noise.
  std::vector<double> base;
};

/// Tables and grids stay as they are; spectral ones are seen as `settings` says by the caller (reducedToRgb) before.
/// Anything else is tabulated: at 6 degrees in each parametrisation, and in the best of these in finer and finer steps.
/// Throws Error::Kind::Value for spectral channels.
BRDF_EXPORT DrawnTable drawnTable(const BrdfPointer& brdf, const DrawnTableOptions& options = {});

/// The grid less its base, drawn by importance tables of its own: what environment light needs samples for. Its values
/// may be negative.
BRDF_EXPORT BrdfPointer aboveBase(const DrawnTable& table);

}  // namespace brdf
