#include "Arguments.h"
#include "Assumptions.h"
#include "Colours.h"
#include "Commands.h"
#include "Output.h"
#include "Pictures.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

void run(const Output& output, LobePicture request, const std::string& size) {
  request.assumptions = assumptions();
  request.size = sizeOption(size);
  colourSettings(request.colours);  // says what is wrong before anything is loaded
  checkPictureOutputs(request.out, {".png", ".vtp"});
  const bool mesh =
      std::any_of(request.out.begin(), request.out.end(), [](const auto& path) { return path.ends_with(".vtp"); });
  if (mesh && request.materials.size() > 1)
    throw Error(Error::Kind::Usage, {"a .vtp file holds one lobe", "--out",
                                     std::to_string(request.materials.size()) + " materials", "one material, or .png"});
  pictures().lobe(request);
  output.line(joined(request.out));
  output.report({{"materials", request.materials},
                 {"theta_i", request.thetaI},
                 {"phi_i", request.phiI},
                 {"transform", request.transform},
                 {"channel", request.channel},
                 {"colour", coloursJson(request.colours)},
                 {"out", request.out}});
}

}  // namespace

Command lobeCommand() {
  struct Values {
    LobePicture request;
    std::string size = "900x700";
  };
  const auto values = std::make_shared<Values>();
  return {
      "lobe", "Draw the lobe of one or several materials for one incident direction",
      "  brdf lobe \"0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)\" \"0.5*Lambertian\" --theta-i 45 --out lobe.png\n"
      "  brdf lobe spectral.csv --channel rgb --illuminant A --observer 10 --out lamp.png",
      [values](Arguments& arguments) {
        LobePicture& request = values->request;
        arguments.positionals("MATERIAL", request.materials, "Files, expressions or preset:NAME; several are overlaid");
        arguments.option("--theta-i", request.thetaI, {0, 89.999}, "DEGREES", "Incident polar angle");
        arguments.option("--phi-i", request.phiI, {-360, 360}, "DEGREES", "Incident azimuth");
        arguments.choice("--transform", request.transform, {"none", "cuberoot", "log"}, "Of the value, for the radius");
        arguments.option("--channel", request.channel, "NAME",
                         "rgb, luminance, a number from 0, or a wavelength such as 550nm [luminance]");
        declareColours(arguments, request.colours, true);
        arguments.option("--size", values->size, "WxH", "Pixels of the picture [900x700]");
        arguments.option("--out", request.out, "FILE", "x.png, or x.vtp for the mesh; both may be given");
        arguments.required();
      },
      [values](const Output& output) { run(output, values->request, values->size); }};
}

}  // namespace brdf::app
