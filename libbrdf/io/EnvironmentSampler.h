#pragma once
#include <brdf/brdf_export.h>
#include <brdf/io/EnvironmentMap.h>

#include <vector>

namespace brdf {

/// Draws directions in proportion to the luminance of an environment map (Rec. 709 weights), texel by texel: the
/// density is constant inside a texel. A map without light is drawn from uniformly over the sphere.
class BRDF_EXPORT EnvironmentSampler {
 public:
  explicit EnvironmentSampler(const EnvironmentMap& map);

  /// A direction from two random numbers in [0, 1).
  Direction sample(double u, double v) const;
  /// Density of `sample` drawing a unit direction, per solid angle (1/sr).
  double pdf(const Direction& direction) const;

 private:
  std::size_t width_, height_;
  std::vector<double> rows_;     ///< cumulative share of each row, height + 1 numbers from 0 to 1
  std::vector<double> columns_;  ///< for each row the cumulative shares inside it, width + 1 numbers from 0 to 1
};

}  // namespace brdf
