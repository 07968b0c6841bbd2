#pragma once
#include <brdf/brdf_export.h>
#include <brdf/io/EnvironmentMap.h>

#include <vector>

namespace brdf {

/// Draws directions in proportion to the luminance of an environment map (Rec. 709 weights), texel by texel: the
/// density is constant inside a texel and in proportion to the mean over it of EnvironmentMap::radiance, which
/// interpolates between texels, so that it is above 0 wherever there is light. A map without light is drawn from
/// uniformly over the sphere.
class BRDF_EXPORT EnvironmentSampler {
 public:
  explicit EnvironmentSampler(const EnvironmentMap& map);

  /// A direction from two random numbers in [0, 1).
  Direction sample(double u, double v) const;
  /// Density of `sample` drawing a unit direction, per solid angle (1/sr).
  double pdf(const Direction& direction) const;

  /// The tables, for other programs (shaders): the share of light in the rows 0 to i, height numbers up to 1, and for
  /// each row one after the other the share in its columns 0 to i, width numbers up to 1.
  std::vector<float> rowShares() const;
  std::vector<float> columnShares() const;

 private:
  std::size_t width_, height_;
  std::vector<double> rows_;     ///< cumulative share of each row, height + 1 numbers from 0 to 1
  std::vector<double> columns_;  ///< for each row the cumulative shares inside it, width + 1 numbers from 0 to 1
};

}  // namespace brdf
