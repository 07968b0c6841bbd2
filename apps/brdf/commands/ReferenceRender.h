#pragma once
#include "Output.h"
#include "Pictures.h"

#include <brdf/render/ReferenceRenderer.h>

#include <string>

namespace brdf::app {

/// What `brdf render --reference` and `--scene` ask for besides a picture.
struct ReferenceRequest {
  RenderPicture picture;
  std::string scene;          ///< a scene file; empty: the picture's own material, object and lights
  std::string standardError;  ///< .exr for the standard error of every number; empty: none
  ReferenceOptions options;
};

/// Draws on the CPU, writes the pictures and reports. With Ctrl-C what is drawn so far is written.
void renderReference(const Output& output, const ReferenceRequest& request);

/// One object under lights as `picture` describes it, drawn on the CPU in linear sRGB: of any material, tables among
/// them. `picture.out` is not used.
Image referenceRadiance(const RenderPicture& picture, const ReferenceOptions& options);

}  // namespace brdf::app
