#pragma once
#include <brdf/brdf_export.h>
#include <brdf/simulate/HeightField.h>

namespace brdf {

/// What a tile of a height field is on average.
struct HeightStatistics {
  double mean = 0, rms = 0;  ///< of the nodes, micrometres; rms about the mean
  double lowest = 0, highest = 0;
  /// Root mean square slopes of the triangles, each counted by its area in projection (all alike). The Beckmann
  /// roughness of Gaussian slopes is sqrt(2) times this.
  double rmsSlopeX = 0, rmsSlopeY = 0;
};
BRDF_EXPORT HeightStatistics statisticsOf(const HeightField& field);

}  // namespace brdf
