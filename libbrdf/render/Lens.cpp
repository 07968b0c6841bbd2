#include <brdf/render/Lens.h>

#include <cmath>

namespace brdf {

Lens::Lens(const Scene& scene) : position_(scene.camera.position) {
  const SceneCamera& camera = scene.camera;
  Direction forward;
  for (std::size_t k = 0; k < 3; ++k) forward[k] = camera.target[k] - camera.position[k];
  forward = normalized(forward);
  const Direction right = normalized(cross(forward, camera.up));
  const Direction up = cross(right, forward);
  const double w = double(scene.width), h = double(scene.height);
  const double pixel = 2 * std::tan(radians(camera.viewAngle) / 2) / h;
  for (std::size_t k = 0; k < 3; ++k) {
    across_[k] = pixel * right[k];
    down_[k] = -pixel * up[k];
    corner_[k] = forward[k] - w / 2 * across_[k] - h / 2 * down_[k];
  }
}

Ray Lens::through(double x, double y) const {
  Direction d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = corner_[k] + x * across_[k] + y * down_[k];
  return {position_, normalized(d)};
}

}  // namespace brdf
