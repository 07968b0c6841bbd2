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

/// Directional-hemispherical reflectance for light from polar angle `theta` and azimuth `phi`, the integral of f
/// cos(theta_o) over the hemisphere of wo: quasi-Monte Carlo (R2 sequence) with half the points from the BRDF's own
/// sampler and half cosine-weighted, combined by the balance heuristic. The error is the scatter of 8 shifted copies,
/// `points` each. The same call gives the same figures. Cells without a value count as 0.
BRDF_EXPORT Albedo directionalAlbedo(const Brdf& brdf, double theta, std::size_t points, double phi = 0);

/// Bihemispherical reflectance, the share of uniform light from the whole hemisphere that is reflected: the mean of the
/// directional albedo over all azimuths with the weight cos(theta) (`theta` of the result is 0 and means nothing). In
/// one quasi-Monte Carlo sum over light and viewer (R sequence in four dimensions); otherwise as directionalAlbedo().
BRDF_EXPORT Albedo bihemisphericalAlbedo(const Brdf& brdf, std::size_t points);

}  // namespace brdf
