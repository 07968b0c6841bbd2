#pragma once
#include <brdf/brdf_export.h>
#include <brdf/render/Scene.h>

#include <span>
#include <string>
#include <string_view>

namespace brdf {

/// Where a scene's objects are.
struct SceneBounds {
  Position low{-1, -1, -1}, high{1, 1, 1};  ///< of the box around them
  Position center{0, 0, 0};                 ///< of the box
  double radius = 1;  ///< of a sphere about the center: half the box's diagonal, or a lone sphere's own
};
/// Of all objects but the ground; the defaults for a scene without any.
BRDF_EXPORT SceneBounds sceneBounds(const Scene& scene);

/// Adds a square of a material under the objects, at their lowest point: its side is 40 times their radius, its middle
/// below theirs. Throws Error::Kind::Value where the scene has a ground.
BRDF_EXPORT void addGround(Scene& scene, BrdfPointer material);
/// By what cameras stand further off where there is a ground, so that some of it is seen around the objects.
constexpr double kGroundMargin = 1.15;
/// The ground's material unless another is asked for: a Lambertian of albedo 0.4.
BRDF_EXPORT BrdfPointer groundMaterial();

/// A named place for a camera. See cameraAround.
struct CameraPreset {
  std::string_view name;
  double azimuth, elevation;  ///< degrees
  std::string_view meaning;
};
BRDF_EXPORT std::span<const CameraPreset> cameraPresets();
/// Throws Error::Kind::Value naming the presets that there are.
BRDF_EXPORT const CameraPreset& cameraPreset(std::string_view name);

/// Turns all objects but the ground about the vertical through `center`, counter-clockwise seen from above.
BRDF_EXPORT void turnObjects(Scene& scene, const Position& center, double degrees);

}  // namespace brdf
