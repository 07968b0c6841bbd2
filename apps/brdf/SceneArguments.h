#pragma once
#include "Arguments.h"
#include "Pictures.h"

#include <brdf/measured/ReadOptions.h>
#include <brdf/render/SceneArrangement.h>

#include <optional>
#include <string>
#include <vector>

namespace brdf::app {

/// What `brdf render` is asked to draw, as written: one object of one material under lights, or a scene file.
struct SceneRequest {
  std::string scene;  ///< a file; empty: the rest
  std::string material;
  ReadOptions assumptions;
  std::string object = "sphere";
  std::vector<std::string> lights;
  double rotation = 0;  ///< of the environment, degrees
  std::string size;     ///< empty: a scene's own, or 512x512

  // Also for a scene, where given.
  std::string camera;
  std::optional<double> azimuth, elevation, viewAngle;  ///< degrees
  std::string lookAt;
  bool ground = false;
  std::string groundMaterial;
  std::string background;
};

void declareScene(Arguments& arguments, SceneRequest& request);

/// Loads everything that the request names. Throws Error::Kind::Usage for what does not go together, and what loading
/// throws.
Scene arrangeScene(const SceneRequest& request);

}  // namespace brdf::app
