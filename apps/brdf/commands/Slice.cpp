#include "Arguments.h"
#include "Assumptions.h"
#include "Colours.h"
#include "Commands.h"
#include "Output.h"
#include "Pictures.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

struct Values {
  SlicePicture request;
  std::vector<std::string> at;
  std::string range;
  std::string size = "900x700";
};

void checkScale(const SlicePicture& request) {
  const std::vector<std::string> allowed = request.kind == "image"
                                               ? std::vector<std::string>{"linear", "log", "cuberoot"}
                                           : request.kind == "holes" || request.kind == "volume"
                                               ? std::vector<std::string>{}
                                               : std::vector<std::string>{"linear", "log", "cuberoot", "log1p"};
  if (!request.scale.empty() && std::find(allowed.begin(), allowed.end(), request.scale) == allowed.end())
    throw Error(Error::Kind::Usage, {"no such scale for --kind " + request.kind, "--scale", "'" + request.scale + "'",
                                     allowed.empty() ? "none" : joined(allowed)});
}

void checkOutputs(const SlicePicture& request) {
  const std::map<std::string, std::vector<std::string>> endings{
      {"image", {".png", ".svg", ".pdf", ".exr", ".vti", ".csv"}},
      {"holes", {".png", ".svg", ".pdf", ".vti", ".csv"}},
      {"volume", {".png", ".vti"}},
      {"", {".png", ".svg", ".pdf", ".csv"}}};
  const auto found = endings.find(request.kind);
  checkPictureOutputs(request.out, found != endings.end() ? found->second : endings.at(""));
  if (request.materials.size() == 1) return;
  if (request.kind == "holes" || request.kind == "volume")
    throw Error(Error::Kind::Usage, {"one material at a time for --kind " + request.kind, "MATERIAL",
                                     std::to_string(request.materials.size()) + " materials", "one"});
  const auto holdsOne = [&](const std::string& path) {
    return path.ends_with(".exr") || path.ends_with(".vti") || (request.kind == "image" && path.ends_with(".csv"));
  };
  const auto one = std::find_if(request.out.begin(), request.out.end(), holdsOne);
  if (one != request.out.end())
    throw Error(Error::Kind::Usage, {"the file holds one slice", "--out",
                                     std::to_string(request.materials.size()) + " materials for " + *one,
                                     "one material, or .png, .svg, .pdf"});
}

Json reportOf(const SlicePicture& request, const SliceResult& result) {
  Json json = {{"materials", request.materials}, {"kind", request.kind},  {"quantity", result.quantity},
               {"fixed", result.fixed},          {"axes", Json::array()}, {"series", Json::array()}};
  for (const SliceResult::Axis& axis : result.axes)
    json["axes"].push_back(
        {{"name", axis.name}, {"unit", axis.unit}, {"from", axis.from}, {"to", axis.to}, {"count", axis.count}});
  for (const SliceResult::Series& series : result.series) {
    Json one = {{"material", series.material}, {"channel", series.channel}, {"channels", series.channels}};
    if (!series.channels.empty()) {
      one["smallest"] = series.smallest;
      one["largest"] = series.largest;
    }
    for (const auto& [name, count] : series.counts) one["counts"][name] = count;
    if (!series.albedo.empty()) {
      one["bihemispherical"] = {{"value", series.albedo}, {"std_error", series.albedoError}};
      one["largest_std_error"] = series.largestError;
    }
    json["series"].push_back(one);
  }
  json["colour"] = coloursJson(request.colours);
  json["out"] = request.out;
  return json;
}

void run(const Output& output, Values values) {
  SlicePicture& request = values.request;
  request.assumptions = assumptions();
  request.size = sizeOption(values.size);
  colourSettings(request.colours);  // says what is wrong before anything is loaded
  checkScale(request);
  checkOutputs(request);
  for (const std::string& text : values.at) {
    const auto numbers = numberListOption("--at", text, 4, "theta_i,phi_i,theta_o,phi_o (degrees)");
    request.directions.push_back({numbers[0], numbers[1], numbers[2], numbers[3]});
  }
  if (!values.range.empty()) {
    request.range = numberListOption("--range", values.range, 2, "LOW,HIGH (1/sr)");
    const bool log = request.scale.empty() || request.scale == "log";
    if (!(request.range[0] < request.range[1]) || (log && !(request.range[0] > 0)))
      throw Error(Error::Kind::Usage,
                  {"no such range", "--range", "'" + values.range + "'",
                   log ? "LOW,HIGH with 0 < LOW < HIGH, as the scale is logarithmic" : "LOW,HIGH with LOW < HIGH"});
  }
  const SliceResult result = pictures().slice(request);
  std::string text = joined(request.out) + ": " + result.quantity;
  for (const SliceResult::Series& series : result.series) {
    text += "\n  " + series.material + ": ";
    if (!series.channels.empty()) text += number(series.smallest) + " to " + number(series.largest);
    for (std::size_t c = 0; c < series.albedo.size(); ++c)
      text += (c == 0 ? "; bihemispherical " : ", ") + number(series.albedo[c]) + " (standard error " +
              formatNumber(series.albedoError[c], 2) + ")";
    for (const auto& [name, count] : series.counts) {
      if (count == 0) continue;
      std::string words = name;
      std::replace(words.begin(), words.end(), '_', ' ');
      text += "; " + std::to_string(count) + " " + words;
    }
  }
  output.line(text);
  output.report(reportOf(request, result));
}

}  // namespace

Command sliceCommand() {
  const auto values = std::make_shared<Values>();
  return {
      "slice", "Draw slices, polar and cartesian plots, albedos, spectra, hole maps, volumes",
      "  brdf slice \"0.2*Lambertian + 0.5*GGX(alpha=0.2)\" --kind image --out slice.png --out slice.exr\n"
      "  brdf slice \"0.2*Lambertian + 0.5*GGX(alpha=0.2)\" \"0.2*Lambertian + BlinnPhong(n=50)\" --kind polar --out "
      "polar.svg\n"
      "  brdf slice \"0.5*GGX(alpha=0.2)\" --kind cartesian --over theta_h --scale log --out curve.png --out "
      "curve.csv\n"
      "  brdf slice \"(0.3,0.1,0.05)*Lambertian\" --kind albedo --channel all --out albedo.pdf\n"
      "  brdf slice spectral.csv --kind wavelength --at 30,0,30,180 --out wavelength.png\n"
      "  brdf slice \"GGX(alpha=0.3)\" --kind volume --resolution 32 --size 400x300 --out volume.png",
      [values](Arguments& arguments) {
        SlicePicture& request = values->request;
        arguments.positionals("MATERIAL", request.materials, "Files, expressions or preset:NAME");
        arguments.choice("--kind", request.kind,
                         {"image", "polar", "cartesian", "albedo", "wavelength", "holes", "volume"},
                         "What is drawn: an image slice; a plot over --over; the albedo over theta_i; f_r over the "
                         "wavelength at --at; which cells are measured; the table as a volume");
        arguments.option("--axes", request.axes, "X,Y",
                         "image: theta_h,theta_d (default), theta_i,theta_o, or an angle of --over and the wavelength, "
                         "say theta_o,wavelength; holes: two axes of the data's own layout");
        arguments.choice("--over", request.over, {"theta_o", "phi", "theta_h", "theta_d", "phi_d"},
                         "polar, cartesian: the angle along the curve (phi is phi_o - phi_i)");
        const Range below{0, 89.999}, turn{-360, 360};
        arguments.option("--theta-i", request.thetaI, below, "DEGREES", "Fixed incident polar angle");
        arguments.option("--phi-i", request.phiI, turn, "DEGREES", "Fixed incident azimuth");
        arguments.option("--theta-o", request.thetaO, below, "DEGREES", "Fixed outgoing polar angle");
        arguments.option("--phi", request.phi, turn, "DEGREES", "Fixed phi_o - phi_i; 180: the plane of incidence");
        arguments.option("--theta-h", request.thetaH, below, "DEGREES", "Fixed half angle");
        arguments.option("--phi-h", request.phiH, turn, "DEGREES", "Fixed azimuth of the half vector");
        arguments.option("--theta-d", request.thetaD, below, "DEGREES", "Fixed difference angle");
        arguments.option("--phi-d", request.phiD, turn, "DEGREES", "Fixed azimuth of the light about the half vector");
        arguments.option("--at", values->at, "TI,PI,TO,PO",
                         "wavelength: theta_i,phi_i,theta_o,phi_o in degrees; several times [45,0,45,180]");
        arguments.option("--channel", request.channel, "NAME",
                         "luminance, rgb, all, a number from 0, or a wavelength such as 550nm [luminance]");
        declareColours(arguments, request.colours, true);
        arguments.choice("--quantity", request.quantity, {"f", "f_cos"},
                         "polar, cartesian: f_r, or f_r cos(theta_o), as a goniometer sees it");
        arguments.option("--scale", request.scale, "NAME",
                         "Of the values: linear, log, cuberoot, log1p [image: log; plots: linear]");
        arguments.option("--decades", request.decades, {0, 600}, "NUMBER",
                         "That a log scale shows at most; 0 chooses: images 6, volumes 4, plots 6");
        arguments.option("--range", values->range, "LOW,HIGH",
                         "image: values of the ends of the colour bar [all but the largest and smallest hundredth]");
        arguments.option(
            "--warp", request.warp, {0.1, 10}, "NUMBER",
            "image, holes: along x, equal steps of angle^(1/warp); 2 widens the highlight as MERL's tables do");
        arguments.option("--exposure", request.exposure, {-100, 100}, "STOPS",
                         "image with --channel rgb; at 0 a white Lambertian is white");
        arguments.option("--within", request.within, {0, 90}, "DEGREES",
                         "polar, cartesian: samples so near to the curve are shown; 0: none");
        arguments.option("--resolution", request.resolution, {0, 1000},
                         "Cells or intervals along each axis; 0 chooses (volume: at most 512)");
        arguments.option("--points", request.points, {16, 10'000'000}, "albedo: points of each of 8 sums");
        arguments.option("--size", values->size, "WxH", "Pixels of the picture, points of .svg and .pdf [900x700]");
        arguments.option("--out", request.out, "FILE",
                         "x.png, x.svg, x.pdf; numbers: x.csv, image also x.exr, x.vti, holes and volume x.vti");
        arguments.required();
      },
      [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
