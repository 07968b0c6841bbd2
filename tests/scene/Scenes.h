#pragma once
#include <brdf/material/LobeSum.h>
#include <brdf/render/ReferenceRenderer.h>

#include <cmath>
#include <string>

/// A sphere of radius 1 about the origin, seen from +z through `pixels` x `pixels`.
inline brdf::Scene sphereScene(brdf::BrdfPointer material, std::size_t pixels) {
  brdf::Scene scene;
  scene.materials = {std::move(material)};
  scene.objects.push_back({"sphere", nullptr, {}, 0});
  scene.camera = brdf::cameraAround({0, 0, 0}, 1, 0, 0, 30, 1);
  scene.width = scene.height = pixels;
  scene.background.kind = brdf::SceneBackground::Kind::Colour;  // black: the environment is not seen
  return scene;
}

inline brdf::SceneEnvironment constantLight(double radiance) {
  brdf::SceneEnvironment environment;
  environment.map =
      std::make_shared<const brdf::EnvironmentMap>(brdf::EnvironmentMap::constant({radiance, radiance, radiance}));
  return environment;
}

/// Where the ray through the centre of a pixel meets the unit sphere of sphereScene: written out here, apart from the
/// renderer. False when it passes by.
inline bool sphereAt(const brdf::Scene& scene, std::size_t x, std::size_t y, brdf::Direction& normal,
                     brdf::Direction& viewer) {
  const double distance = scene.camera.position[2], half = std::tan(brdf::radians(scene.camera.viewAngle / 2));
  const double side = double(scene.width);
  const brdf::Direction d =
      brdf::normalized({(2 * (double(x) + 0.5) / side - 1) * half, (1 - 2 * (double(y) + 0.5) / side) * half, -1});
  const double b = distance * d[2], under = b * b - (distance * distance - 1);
  if (under <= 0) return false;
  const double t = -b - std::sqrt(under);
  normal = {t * d[0], t * d[1], distance + t * d[2]};
  viewer = {-d[0], -d[1], -d[2]};
  return true;
}

/// Directions in the frame of the sphere at `normal`: tangents run around +y.
inline brdf::Direction inSphereFrame(const brdf::Direction& normal, const brdf::Direction& d) {
  const brdf::Direction t = brdf::normalized({normal[2], 0, -normal[0]});
  return {brdf::dot(d, t), brdf::dot(d, brdf::cross(normal, t)), brdf::dot(d, normal)};
}
