#include "ReferenceRender.h"

#include "Progress.h"

#include <brdf/material/ChannelView.h>

namespace brdf::app {
namespace {

void seeAsRgb(Scene& scene, const ColourNames& names) {
  const ColourSettings colours = colourSettings(names);
  for (BrdfPointer& material : scene.materials) material = asRgb(material, colours);
}

}  // namespace

ReferencePicture drawReference(const Output& output, const std::string& title, Scene scene, const ColourNames& colours,
                               ReferenceOptions options) {
  seeAsRgb(scene, colours);
  Progress progress(output, title);
  options.progress = [&progress](std::size_t done, std::size_t most, double error) {
    progress.update(done, most, "relative error " + number(error));
    return !interrupted();
  };
  return brdf::renderReference(scene, options);
}

Image referenceRadiance(const SceneRequest& request, const ReferenceOptions& options) {
  Scene scene = arrangeScene(request);
  seeAsRgb(scene, {});
  return brdf::renderReference(scene, options).radiance;
}

}  // namespace brdf::app
