#pragma once
#include <brdf/io/EnvironmentSampler.h>
#include <brdf/render/Scene.h>

#include <optional>

namespace brdf {

/// The environment of a scene in world directions, with its own density to draw from.
class SceneLighting {
 public:
  explicit SceneLighting(const SceneEnvironment& environment);

  Rgb radiance(const Direction& direction) const;
  /// A direction towards the light from two random numbers in [0, 1).
  Direction sample(double u, double v) const;
  /// Density of `sample` (1/sr).
  double pdf(const Direction& direction) const;

 private:
  Direction inMap(const Direction& world) const;

  SceneEnvironment environment_;
  double cosine_, sine_;
  EnvironmentSampler sampler_;
};

}  // namespace brdf
