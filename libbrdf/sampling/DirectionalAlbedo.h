#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>

#include <vector>

namespace brdf {

/// A directional albedo with the statistical error of its estimate, one entry a channel.
struct Albedo {
  double theta = 0;           ///< of the light, radians
  std::vector<double> value;  ///< share of the light from theta that is reflected, 0 to 1 when energy is kept
  std::vector<double> error;  ///< estimated standard error of `value`
};

/// Directional-hemispherical reflectance for light from polar angle `theta` (azimuth 0), the integral of f cos(theta_o)
/// over the hemisphere of wo: quasi-Monte Carlo (R2 sequence) with half the points from the BRDF's own sampler and half
/// cosine-weighted, combined by the balance heuristic. The error is the scatter of 8 shifted copies, `points` each. The
/// same call gives the same figures. Cells without a value count as 0.
BRDF_EXPORT Albedo directionalAlbedo(const Brdf& brdf, double theta, std::size_t points);

}  // namespace brdf
