#pragma once
#include "Output.h"
#include "SceneArguments.h"

#include <brdf/render/ReferenceRenderer.h>

#include <string>

namespace brdf::app {

/// A scene drawn on the CPU with a progress bar of that title; `stopped` after Ctrl-C, with the picture so far.
ReferencePicture drawReference(const Output& output, const std::string& title, Scene scene, const ColourNames& colours,
                               ReferenceOptions options);

/// One object under lights, drawn on the CPU in linear sRGB: of any material, tables among them.
Image referenceRadiance(const SceneRequest& request, const ReferenceOptions& options);

}  // namespace brdf::app
