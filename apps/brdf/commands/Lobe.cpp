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
  checkPictureOutputs(request.out, {".png", ".vtp", ".ply", ".obj", ".stl"});
  const std::size_t count = request.materials.size();
  const bool mesh = std::ranges::any_of(request.out, [](const auto& path) { return !path.ends_with(".png"); });
  if (request.difference != "none" && count != 2)
    throw Error(Error::Kind::Usage, {"a difference is of two materials", "--difference", std::to_string(count), "2"});
  if (mesh && count > 1 && request.difference == "none")
    throw Error(Error::Kind::Usage, {"a mesh is of one lobe", "--out", std::to_string(count) + " materials",
                                     "one material, --difference, or .png"});
  const LobeResult result = pictures().lobe(request);
  output.line(joined(request.out));
  nlohmann::ordered_json lobes = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < result.largest.size(); ++k)
    lobes.push_back(
        {{"largest", result.largest[k]}, {"triangles", result.triangles[k]}, {"chord_error", result.chordError[k]}});
  output.report({{"materials", request.materials},
                 {"theta_i", request.thetaI},
                 {"phi_i", request.phiI},
                 {"transform", request.transform},
                 {"channel", request.channel},
                 {"difference", request.difference},
                 {"colour", coloursJson(request.colours)},
                 {"lobes", lobes},
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
      "  brdf lobe \"GGX(alpha=0.2)\" \"GGX(alpha=0.25)\" --difference displaced --transform cuberoot --out "
      "differs.png\n"
      "  brdf lobe spectral.csv spectral.xml --samples --within 5 --layout side --out points.png\n"
      "  brdf lobe spectral.csv --channel rgb --illuminant A --observer 10 --out lamp.png",
      [values](Arguments& arguments) {
        LobePicture& request = values->request;
        arguments.positionals("MATERIAL", request.materials, "Files, expressions or preset:NAME");
        arguments.option("--theta-i", request.thetaI, {0, 89.999}, "DEGREES", "Incident polar angle");
        arguments.option("--phi-i", request.phiI, {-360, 360}, "DEGREES", "Incident azimuth");
        arguments.choice("--transform", request.transform, {"none", "cuberoot", "log", "logfloor"},
                         "Of the value, for the radius: log is ln(1 + f), logfloor log10(f / floor)");
        arguments.option("--floor", request.floor, {1e-12, 1e12}, "VALUE", "Where logfloor begins, 1/sr");
        arguments.option("--channel", request.channel, "NAME",
                         "rgb, luminance, all, a number from 0, or a wavelength such as 550nm [luminance]");
        arguments.option("--colour", request.colour, "NAME",
                         "Of the surface: material, value, true (full brightness), or a channel as above [auto]");
        arguments.choice("--layout", request.layout, {"overlay", "side"}, "Several materials in one place or beside");
        arguments.choice("--difference", request.difference, {"none", "lobe", "displaced"},
                         "First less second: as a lobe, or raising and denting a hemisphere");
        arguments.flag("--samples", request.samples,
                       "Measured points; with another material coloured by what it differs from them");
        arguments.option("--within", request.within, {0, 180}, "DEGREES", "How far their light may be from the lobe's");
        arguments.option("--subdivision", request.subdivision, {0, 9}, "Of the mesh that is refined");
        arguments.option("--tolerance", request.tolerance, {0, 1}, "SHARE",
                         "Of the largest length: how far the mesh may leave the surface; 0 does not refine");
        declareColours(arguments, request.colours, true);
        arguments.option("--size", values->size, "WxH", "Pixels of the picture [900x700]");
        arguments.option("--out", request.out, "FILE",
                         "x.png, or x.vtp, x.ply, x.obj, x.stl for the mesh; several times");
        arguments.required();
      },
      [values](const Output& output) { run(output, values->request, values->size); }};
}

}  // namespace brdf::app
