#include <brdf/render/SceneLighting.h>

#include <cmath>

namespace brdf {

SceneLighting::SceneLighting(const SceneEnvironment& environment)
    : environment_(environment),
      cosine_(std::cos(radians(environment.rotation))),
      sine_(std::sin(radians(environment.rotation))),
      sampler_(*environment.map) {}

Direction SceneLighting::inMap(const Direction& d) const {
  return {cosine_ * d[0] - sine_ * d[2], d[1], sine_ * d[0] + cosine_ * d[2]};
}

Rgb SceneLighting::radiance(const Direction& direction) const {
  Rgb rgb = environment_.map->radiance(inMap(direction));
  for (double& value : rgb) value *= environment_.scale;
  return rgb;
}

Direction SceneLighting::sample(double u, double v) const {
  const Direction d = sampler_.sample(u, v);
  return {cosine_ * d[0] + sine_ * d[2], d[1], -sine_ * d[0] + cosine_ * d[2]};
}

double SceneLighting::pdf(const Direction& direction) const { return sampler_.pdf(inMap(direction)); }

}  // namespace brdf
