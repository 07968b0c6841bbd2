#pragma once
#include <brdf/material/Brdf.h>

#include <cstdint>
#include <vector>

namespace brdf::app {

/// A directional albedo with the statistical error of its estimate, one entry a channel.
struct Albedo {
  double theta = 0;           ///< of the light, radians
  std::vector<double> value;  ///< share of the light from theta that is reflected, 0 to 1 when energy is kept
  std::vector<double> error;  ///< estimated standard error of `value`
};

/// Directional-hemispherical reflectance for light from polar angle `theta` (azimuth 0), the integral of f cos(theta_o)
/// over the hemisphere of wo: quasi-Monte Carlo (R2 sequence) with half the points from the BRDF's own sampler and half
/// cosine-weighted, combined by the balance heuristic. The error is the scatter of 8 randomly shifted copies, `points`
/// each. Cells without a value count as 0.
Albedo directionalAlbedo(const Brdf& brdf, double theta, std::size_t points);

struct Violations {
  std::size_t tested = 0;
  std::size_t count = 0;
  double median = 0;  ///< reciprocity: the usual relative difference
  double worst = 0;   ///< reciprocity: largest relative difference; energy: largest albedo
};

/// Random direction pairs (cosine-distributed, fixed seed) whose value changes by more than `tolerance`, relative to
/// the larger one, when light and viewer are exchanged. Pairs without a value are left out.
Violations reciprocityViolations(const Brdf& brdf, std::size_t pairs, double tolerance);

/// Light directions 0, 5, ..., 85 degrees and channels at which the albedo exceeds 1 by more than three of its errors.
Violations energyViolations(const Brdf& brdf, std::size_t points);

}  // namespace brdf::app
