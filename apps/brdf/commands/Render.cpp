#include "Arguments.h"
#include "Assumptions.h"
#include "Colours.h"
#include "Commands.h"
#include "Output.h"
#include "Pictures.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>

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

void run(const Output& output, RenderPicture request, const std::vector<std::string>& lights, const std::string& size) {
  request.assumptions = assumptions();
  request.size = sizeOption(size);
  colourSettings(request.colours);  // says what is wrong before anything is loaded
  for (const std::string& light : lights) request.lights.push_back(lightOption(light));
  checkPictureOutputs(request.out, {".png", ".exr"});
  const auto start = std::chrono::steady_clock::now();
  const RenderResult result = pictures().render(request);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  output.line(joined(request.out) + ": " + std::to_string(request.samples) + " samples a pixel, mean radiance " +
              number(result.mean) + ", " + formatNumber(seconds, 3) + " s on " + result.device);
  output.report({{"material", request.material},
                 {"object", request.object},
                 {"colour", coloursJson(request.colours)},
                 {"lights", lights},
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
  struct Values {
    RenderPicture request;
    std::vector<std::string> lights;
    std::string size = "512x512";
  };
  const auto values = std::make_shared<Values>();
  return {
      "render", "Render an object of a material under light",
      "  brdf render \"(0.3,0.1,0.05)*Lambertian + 0.5*GGX(alpha=0.2)\" --light directional:45,0 --out sphere.png "
      "--out sphere.exr\n"
      "  brdf render spectral.xml --illuminant A --light directional:45,0 --out lamp.png",
      [values](Arguments& arguments) {
        RenderPicture& request = values->request;
        arguments.positional("MATERIAL", request.material, "A file, an expression or preset:NAME");
        arguments.option("--object", request.object, "FILE", "sphere, or a file: .ply, .obj, .stl, .vtp [sphere]");
        arguments.option(
            "--light", values->lights, "LIGHT",
            "env:FILE (equirectangular .exr or .hdr), directional:theta,phi (degrees from +y, and about it from +z) or "
            "point:x,y,z; the last two give a white diffuser that faces them radiance 1; several times");
        arguments.required();
        arguments.option("--samples", request.samples, {1, 65536}, "A pixel, under an environment");
        arguments.option("--size", values->size, "WxH", "Pixels [512x512]");
        arguments.option("--exposure", request.exposure, {-50, 50}, "STOPS", "Of the .png");
        arguments.choice("--tone", request.toneCurve, {"clamp", "reinhard", "aces"}, "Curve of the .png");
        declareColours(arguments, request.colours);
        arguments.option("--rotate", request.rotation, {-360, 360}, "DEGREES",
                         "Turn the environment about the vertical");
        arguments.option("--out", request.out, "FILE", "x.png (sRGB) or x.exr (linear radiance); both may be given");
        arguments.required();
      },
      [values](const Output& output) { run(output, values->request, values->lights, values->size); }};
}

}  // namespace brdf::app
