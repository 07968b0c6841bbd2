#pragma once
#include <brdf/fit/FitData.h>
#include <brdf/io/EnvironmentMap.h>
#include <brdf/material/Brdf.h>

#include <memory>
#include <string>

namespace brdf {

/// How much a picture of a sphere differs: the residual is the difference of lightness L* (CIE 1976, 0 black to 100
/// white; CIE 15:2004, section 8.2.1.1) of each pixel and channel, white being a white diffuser where the sphere is
/// brightest (of 6 x 6 places). Its values f and t are radiances over that white, not BRDFs.
class BRDF_EXPORT SphereMetric : public Metric {
 public:
  /// `map` null: the standard light, sphereLight().
  SphereMetric(std::string name, std::shared_ptr<const EnvironmentMap> map);
  const EnvironmentMap& map() const { return *map_; }

  void prepare(const double* values, const DirectionPairs<double>& pairs, double* target) const override;
  void restore(const double* target, const DirectionPairs<double>& pairs, double* values) const override;
  void residual(const double* f, const double* target, const DirectionPairs<double>& pairs, double* r) const override;
  void slope(const double* f, const double* target, const DirectionPairs<double>& pairs, double* slope) const override;

 private:
  std::shared_ptr<const EnvironmentMap> map_;
};

/// The light of the metric "sphere" unless a map is named: a lamp of 10 degrees radius, 45 degrees up and 45 degrees to
/// the viewer's right, that alone gives a surface facing it the irradiance pi; a sky of radiance 0.3; a ground of 0.1.
BRDF_EXPORT const std::shared_ptr<const EnvironmentMap>& sphereLight();

/// A sphere of the target's material under the metric's map as data to fit: pixels of a parallel view from +z with +y
/// up, 24 across, tangents around +y (as vtkBRDFRender has them). Each pixel is the sum over 256 directions, half drawn
/// from the map and half from the target's own sampler, combined by the balance heuristic; they stay fixed, so that the
/// difference of two materials is free of noise of its own. RGB targets see the map's colours, others its luminance.
/// Directions where the target has no value are left out, of the target and of what is compared with it.
BRDF_EXPORT FitData spherePicture(const Brdf& target, const std::shared_ptr<const SphereMetric>& metric);

/// Root mean square over pixels and channels of the difference in lightness, of a BRDF with the target's channels and
/// of black.
struct SphereErrors {
  double error = 0, zeroModel = 0;
};
BRDF_EXPORT SphereErrors sphereErrors(const FitData& picture, const Brdf& brdf);

}  // namespace brdf
