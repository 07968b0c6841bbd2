#pragma once
#include <brdf/render/ReferenceRenderer.h>

#include <memory>

namespace rendertest {

/// The sphere under a map turned by 200 degrees, as the reference renderer sees it: `size` pixels a side, through their
/// centres.
inline brdf::ReferencePicture referenceSphere(const brdf::BrdfPointer& material, const brdf::EnvironmentMap& map,
                                              int size) {
  brdf::Scene scene;
  scene.materials = {material};
  scene.objects.push_back({"sphere", nullptr, {}, 0});
  scene.environment = brdf::SceneEnvironment{std::make_shared<const brdf::EnvironmentMap>(map), 200, 1};
  scene.camera = brdf::cameraAround({0, 0, 0}, 1, 0, 0, 30, 1);
  scene.width = scene.height = size;
  brdf::ReferenceOptions options;
  options.samples = 1024;
  options.pixelCentres = true;
  return brdf::renderReference(scene, options);
}

}  // namespace rendertest
