#include "Arguments.h"
#include "Assumptions.h"
#include "Colours.h"
#include "Commands.h"
#include "Output.h"
#include "Pictures.h"
#include "ReferenceRender.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/material/LobeSum.h>

#include <chrono>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

Light lightOption(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string value = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (kind == "env" && !value.empty()) return {Light::Kind::Environment, value, {}};
  if (kind == "directional")
    return {Light::Kind::Directional, {}, numberListOption("--light", value, 2, "directional:45,0")};
  if (kind == "point") return {Light::Kind::Point, {}, numberListOption("--light", value, 3, "point:2,2,3")};
  throw Error(Error::Kind::Usage, {"unknown light", "--light", "'" + text + "'",
                                   "env:FILE, directional:theta,phi (degrees) or point:x,y,z"});
}

struct Values {
  ReferenceRequest request;
  std::vector<std::string> lights;
  std::string size = "512x512";
  bool reference = false;
  std::size_t samples = 0;  ///< 0: not given
};

/// What is there to draw: a material under light, or a scene that holds all that.
void checkSubject(const Values& values) {
  const std::string& scene = values.request.scene;
  const bool material = !values.request.picture.material.empty();
  if (scene.empty() != material)
    throw Error(Error::Kind::Usage, {"what to render", "", scene.empty() ? "nothing" : "a material and a scene",
                                     "MATERIAL or --scene FILE.json"});
  if (!scene.empty() && !values.lights.empty())
    throw Error(Error::Kind::Usage, {"a scene has its own lights", "--light", values.lights.front(), ""});
  if (scene.empty() && values.lights.empty())
    throw Error(Error::Kind::Usage,
                {"required option missing", "--light", "", "env:FILE, directional:theta,phi or point:x,y,z"});
  const ReferenceOptions& options = values.request.options;
  if (scene.empty() && !values.reference &&
      (options.tolerance > 0 || options.bounces > 1 || !values.request.standardError.empty()))
    throw Error(Error::Kind::Usage, {"--tolerance, --bounces and --standard-error need the reference renderer",
                                     "brdf render", "", "--reference or --scene"});
}

/// Whether the graphics device can draw it: sums of lobes, which alone have shaders.
bool hasShaders(const RenderPicture& picture) {
  return dynamic_cast<const LobeSum*>(loadMaterial(picture.material, picture.assumptions).brdf.get()) != nullptr;
}

void run(const Output& output, Values values) {
  checkSubject(values);
  RenderPicture& request = values.request.picture;
  request.assumptions = assumptions();
  request.size = sizeOption(values.size);
  colourSettings(request.colours);  // says what is wrong before anything is loaded
  for (const std::string& light : values.lights) request.lights.push_back(lightOption(light));
  checkPictureOutputs(request.out, {".png", ".exr"});
  if (values.reference || !values.request.scene.empty()) {
    if (!values.request.standardError.empty()) checkPictureOutputs({values.request.standardError}, {".exr"});
    if (values.samples > 0) values.request.options.samples = std::max<std::size_t>(2, values.samples);
    renderReference(output, values.request);
    return;
  }
  if (values.samples > 0) request.samples = values.samples;
  if (!hasShaders(request)) {
    output.line("Not a sum of lobes: drawn by the reference renderer.");
    values.request.options.samples = std::max<std::size_t>(2, request.samples);
    renderReference(output, values.request);
    return;
  }
  const auto start = std::chrono::steady_clock::now();
  const RenderResult result = pictures().render(request);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  output.line(joined(request.out) + ": " + std::to_string(request.samples) + " samples a pixel, mean radiance " +
              number(result.mean) + ", " + formatNumber(seconds, 3) + " s on " + result.device);
  output.report({{"material", request.material},
                 {"object", request.object},
                 {"colour", coloursJson(request.colours)},
                 {"lights", values.lights},
                 {"samples", request.samples},
                 {"size", {request.size.width, request.size.height}},
                 {"exposure", request.exposure},
                 {"mean_radiance", result.mean},
                 {"seconds", seconds},
                 {"device", result.device},
                 {"out", request.out}});
}

}  // namespace

Command renderCommand() {
  const auto values = std::make_shared<Values>();
  return {
      "render", "Render an object of a material under light, or a scene",
      "  brdf render \"(0.3,0.1,0.05)*Lambertian + 0.5*GGX(alpha=0.2)\" --light directional:45,0 --out sphere.png "
      "--out sphere.exr\n"
      "  brdf render spectral.xml --illuminant A --light directional:45,0 --out lamp.png\n"
      "  brdf render \"0.5*Lambertian\" --light point:2,2,3 --reference --samples 64 --size 64x64 --out true.exr",
      [values](Arguments& arguments) {
        RenderPicture& request = values->request.picture;
        ReferenceOptions& reference = values->request.options;
        arguments.positional("MATERIAL", request.material, "A file, an expression or preset:NAME");
        arguments.optional();
        arguments.option("--object", request.object, "FILE", "sphere, or a file: .ply, .obj, .stl, .vtp [sphere]");
        arguments.option(
            "--light", values->lights, "LIGHT",
            "env:FILE (equirectangular .exr or .hdr), directional:theta,phi (degrees from +y, and about it from +z) or "
            "point:x,y,z; the last two give a white diffuser that faces them radiance 1; several times");
        arguments.option("--scene", values->request.scene, "FILE.json",
                         "Objects, materials, lights and camera in a file (docs/scenes.md), drawn as --reference does");
        arguments.option("--samples", values->samples, {1, 1 << 24},
                         "A pixel: under an environment [64]; with --reference, paths at most [256]");
        arguments.flag("--reference", values->reference,
                       "Path tracing on the CPU, unbiased: the truth that other pictures are compared with");
        arguments.option("--tolerance", reference.tolerance, {0, 1}, "NUMBER",
                         "With --reference: stop when the relative standard error is below");
        arguments.option("--bounces", reference.bounces, {1, 1000},
                         "With --reference: surfaces that light may meet on its way; 1 is direct light");
        arguments.option("--standard-error", values->request.standardError, "FILE.exr",
                         "With --reference: the standard error of every pixel");
        arguments.option("--size", values->size, "WxH", "Pixels [512x512]; a scene has its own");
        arguments.option("--exposure", request.exposure, {-50, 50}, "STOPS", "Of the .png");
        arguments.choice("--tone", request.toneCurve, {"clamp", "reinhard", "aces"}, "Curve of the .png");
        declareColours(arguments, request.colours);
        arguments.option("--rotate", request.rotation, {-360, 360}, "DEGREES",
                         "Turn the environment about the vertical");
        arguments.option("--out", request.out, "FILE", "x.png (sRGB) or x.exr (linear radiance); both may be given");
        arguments.required();
      },
      [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
