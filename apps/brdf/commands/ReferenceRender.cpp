#include "ReferenceRender.h"

#include "Colours.h"
#include "Progress.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/ImageFile.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/material/ChannelView.h>
#include <brdf/render/SceneFile.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

TriangleMesh readMesh(const std::filesystem::path& path) { return pictures().readMesh(path.string()); }

/// Brightness as in the picture module: a white Lambertian at the origin that faces the light has radiance 1.
void addLight(Scene& scene, const Light& light, double rotation) {
  const auto& at = light.numbers;
  if (light.kind == Light::Kind::Directional) {
    const double theta = radians(at[0]), phi = radians(at[1]);
    scene.lights.push_back({SceneLight::Kind::Directional,
                            {std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)},
                            {kPi, kPi, kPi}});
  } else if (light.kind == Light::Kind::Point) {
    const double intensity = kPi * (at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
    scene.lights.push_back({SceneLight::Kind::Point, {at[0], at[1], at[2]}, {intensity, intensity, intensity}});
  } else {
    scene.environment =
        SceneEnvironment{std::make_shared<const EnvironmentMap>(EnvironmentMap::read(light.file)), rotation, 1, true};
  }
}

/// One object in the middle of the picture, as vtkBRDFRender places it.
Scene sceneOf(const RenderPicture& picture) {
  Scene scene;
  scene.materials = {loadMaterial(picture.material, picture.assumptions).brdf};
  scene.objects.push_back({picture.object, nullptr, {}, 0});
  Position low{-1, -1, -1}, high{1, 1, 1};
  double radius = 1;
  if (picture.object != "sphere") {
    const auto mesh = std::make_shared<const TriangleMesh>(readMesh(picture.object));
    low = high = mesh->points.front();
    for (const Position& p : mesh->points)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    radius = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2;
    scene.objects[0].mesh = mesh;
  }
  for (const Light& light : picture.lights) addLight(scene, light, picture.rotation);
  scene.width = picture.size.width;
  scene.height = picture.size.height;
  scene.camera = cameraAround({(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2}, radius, 0, 0,
                              30, static_cast<double>(scene.width) / static_cast<double>(scene.height));
  return scene;
}

double meanOf(const Image& image) {
  double sum = 0;
  for (const float value : image.values) sum += double(value);
  return sum / static_cast<double>(image.values.size());
}

}  // namespace

void renderReference(const Output& output, const ReferenceRequest& request) {
  Scene scene = request.scene.empty() ? sceneOf(request.picture) : readScene(request.scene, MeshReader(readMesh));
  const ColourSettings colours = colourSettings(request.picture.colours);
  for (BrdfPointer& material : scene.materials) material = asRgb(material, colours);

  const Interruptible untilSaved;
  ReferencePicture picture;
  {
    Progress progress(output, "render");
    ReferenceOptions options = request.options;
    options.progress = [&progress](std::size_t done, std::size_t most, double error) {
      progress.update(done, most, "relative error " + number(error));
      return !interrupted();
    };
    picture = brdf::renderReference(scene, options);
  }
  for (const std::string& path : request.picture.out)
    path.ends_with(".png") ? pictures().writePng(picture.radiance, request.picture, path)
                           : writeExr(picture.radiance, path);
  if (!request.standardError.empty()) writeExr(picture.standardError, request.standardError);

  std::string text = joined(request.picture.out) + ": " + std::to_string(picture.samples) +
                     " paths a pixel, mean radiance " + number(meanOf(picture.radiance)) +
                     ", relative standard error " + number(picture.relativeError) + ", " +
                     formatNumber(picture.seconds, 3) + " s on the CPU";
  if (request.options.tolerance > 0 && !picture.converged)
    text += "\n  note: the tolerance " + formatNumber(request.options.tolerance) + " was not reached";
  if (picture.invalidShare > 0)
    text += "\n  note: " + number(100 * picture.invalidShare) +
            " % of the directions asked for have no value in the material and were taken for black";
  output.line(text);
  output.report({{"material", request.picture.material},
                 {"object", request.picture.object},
                 {"scene", request.scene},
                 {"colour", coloursJson(request.picture.colours)},
                 {"samples", picture.samples},
                 {"bounces", request.options.bounces},
                 {"tolerance", request.options.tolerance},
                 {"relative_error", picture.relativeError},
                 {"converged", picture.converged},
                 {"invalid_share", picture.invalidShare},
                 {"size", {scene.width, scene.height}},
                 {"mean_radiance", meanOf(picture.radiance)},
                 {"seconds", picture.seconds},
                 {"device", "CPU"},
                 {"out", request.picture.out}});
  if (interrupted())
    throw Error(Error::Kind::Value, {"interrupted; the picture so far was kept", "brdf render", "", ""});
}

Image referenceRadiance(const RenderPicture& picture, const ReferenceOptions& options) {
  Scene scene = sceneOf(picture);
  const ColourSettings colours = colourSettings(picture.colours);
  for (BrdfPointer& material : scene.materials) material = asRgb(material, colours);
  return brdf::renderReference(scene, options).radiance;
}

}  // namespace brdf::app
