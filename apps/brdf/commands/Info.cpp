#include "Arguments.h"
#include "Assumptions.h"
#include "Colours.h"
#include "Commands.h"
#include "Output.h"
#include "Quadrature.h"

#include <brdf/base/Text.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/material/CellCounts.h>
#include <brdf/material/SampleSet.h>
#include <brdf/sampling/DirectionalAlbedo.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kReciprocityTolerance = 1e-6;  // relative; formulas agree to 1e-12, float tables to 1e-7

std::string channelsText(const Channels& channels) {
  switch (channels.kind) {
    case Channels::Kind::Monochrome:
      return "1, monochrome";
    case Channels::Kind::Rgb:
      return "3, linear RGB";
    default:
      return std::to_string(channels.count()) + " wavelengths, " + formatNumber(channels.wavelengths.front()) + " to " +
             formatNumber(channels.wavelengths.back()) + " nm";
  }
}

std::string symmetryText(Symmetry symmetry) {
  switch (symmetry) {
    case Symmetry::Isotropic:
      return "isotropic";
    case Symmetry::Bilateral:
      return "bilateral";
    default:
      return "anisotropic";
  }
}

std::string listText(const std::vector<double>& values) {
  if (values.size() <= 3) {
    std::vector<std::string> texts;
    for (const double value : values) texts.push_back(formatNumber(value, 5));
    return joined(texts);
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return formatNumber(*low, 5) + " to " + formatNumber(*high, 5) + " over the channels";
}

Json violationsJson(const Violations& violations) {
  return {{"tested", violations.tested}, {"violations", violations.count}, {"worst", violations.worst}};
}

void addReadReport(const ReadReport& report, bool data, TextTable& table, Json& json) {
  for (const auto& [key, value] : report.metadata) table.row({key, value});
  json["format"] = report.format;
  json["source"] = report.source;
  json["metadata"] = report.metadata;
  if (!data) return;
  table.row({"format", report.format});
  table.row({"samples", std::to_string(report.samples)});
  table.row({"invalid", std::to_string(report.invalid) + " (below the horizon " + std::to_string(report.belowHorizon) +
                            "); negative " + std::to_string(report.negative) + ", not finite " +
                            std::to_string(report.notFinite)});
  for (const std::string& assumption : report.assumptions) table.row({"assumed", assumption});
  for (const std::string& warning : report.warnings) table.row({"warning", warning});
  json["samples"] = report.samples;
  json["invalid"] = report.invalid;
  json["below_horizon"] = report.belowHorizon;
  json["negative"] = report.negative;
  json["not_finite"] = report.notFinite;
  json["assumptions"] = report.assumptions;
  json["warnings"] = report.warnings;
}

/// Whether cells and samples are measured, extrapolated or invalid, and the axes that they lie on.
void addCells(const Brdf& brdf, TextTable& table, Json& json) {
  const auto counts = countCells(brdf);
  if (!counts) return;
  if (!counts->layout.empty()) {
    table.row({"axes", counts->layout});
    json["axes"] = counts->layout;
  }
  table.row({counts->layout.empty() ? "data" : "cells",
             std::to_string(counts->measured) + " measured, " + std::to_string(counts->extrapolated) +
                 " extrapolated, " + std::to_string(counts->invalid) + " invalid; " +
                 std::to_string(counts->belowHorizon) + " of all below the horizon"});
  json["cells"] = {{"measured", counts->measured},
                   {"extrapolated", counts->extrapolated},
                   {"invalid", counts->invalid},
                   {"below_horizon", counts->belowHorizon}};
}

std::string angleRange(const std::vector<double>& thetaI) {
  return std::to_string(thetaI.size()) + " angles, " + formatNumber(degrees(thetaI.front()), 4) + " to " +
         formatNumber(degrees(thetaI.back()), 4) + " deg";
}

/// What the material has besides its front reflection; nothing of it is drawn or rendered yet.
void addComponents(const Components& components, TextTable& table, Json& json) {
  if (components.empty()) return;
  Json list = Json::array();
  const auto add = [&](const std::string& name, const std::string& text) {
    table.row({"component", name + ": " + text});
    list.push_back({{"component", name}, {"content", text}});
  };
  for (const ScatterComponent& part : components.scatter) {
    const auto counts = countCells(*part.brdf);
    add(std::string(componentName(part.kind)),
        counts && !counts->layout.empty() ? counts->layout : part.brdf->description());
  }
  for (const SpecularComponent& part : components.specular)
    add("specular " + std::string(componentName(part.kind)),
        angleRange(part.thetaI) + ", " + listText(part.values) + " of the incident power");
  for (const TotalScatter& part : components.totals)
    add("total " + std::string(componentName(part.kind)),
        "as the file states it, " + angleRange(part.thetaI) + ", " + listText(part.values));
  table.row({"note", "components are kept and converted to containers; they are not drawn or rendered yet"});
  json["components"] = list;
}

/// What an eye sees of the spectral albedo at normal incidence, under the light asked for.
void addColour(const Brdf& brdf, const std::vector<double>& albedo, const ColourNames& names,
               const ColourSettings& settings, TextTable& table, Json& json) {
  const auto& wavelengths = brdf.channels().wavelengths;
  if (std::ranges::none_of(wavelengths, [](double w) { return w >= 380 && w <= 780; }))
    return;  // no spectrum, or unseen
  const auto seen = [&](const std::vector<double>& weights) {
    std::array<double, 3> values{};
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t c = 0; c < albedo.size(); ++c) values[row] += weights[row * albedo.size() + c] * albedo[c];
    return values;
  };
  const auto xyz = seen(xyzWeights(wavelengths, settings));
  const auto rgb = seen(rgbWeights(wavelengths, settings));
  const auto list = [](const std::array<double, 3>& v) {
    return formatNumber(v[0], 5) + ", " + formatNumber(v[1], 5) + ", " + formatNumber(v[2], 5);
  };
  std::string text = "linear sRGB " + list(rgb) + "; XYZ " + list(xyz);
  json["colour"] = coloursJson(names);
  json["colour"]["linear_srgb"] = rgb;
  json["colour"]["xyz"] = xyz;
  if (const double sum = xyz[0] + xyz[1] + xyz[2]; sum > 0) {
    json["colour"]["xy"] = {xyz[0] / sum, xyz[1] / sum};
    text += "; x, y " + formatNumber(xyz[0] / sum, 4) + ", " + formatNumber(xyz[1] / sum, 4);
  }
  table.row({"colour at 0 deg", text + "; under " + describe(settings)});
}

struct Values {
  std::string material;
  ColourNames colours;
};

void run(const Output& output, const Values& values) {
  const ColourSettings colour = colourSettings(values.colours);
  const LoadedMaterial loaded = loadMaterial(values.material, assumptions());
  const Brdf& brdf = *loaded.brdf;
  // Interpolated data cost thousands of times more than a formula, and are not known to four digits.
  const std::size_t points = brdf.samples() ? 1024 : 8192;

  TextTable table;
  Json json = {{"material", brdf.description()}, {"kind", loaded.kind}};
  table.row({"material", brdf.description()});
  table.row({"kind", loaded.kind});
  table.row({"channels", channelsText(brdf.channels())});
  json["channels"] = brdf.channels().count();
  json["wavelengths_nm"] = brdf.channels().wavelengths;
  addReadReport(loaded.report, brdf.samples() != nullptr, table, json);
  addCells(brdf, table, json);
  addComponents(loaded.components, table, json);
  table.row({"symmetry", symmetryText(brdf.symmetry())});
  table.row({"values", "1/sr without the cosine; 0 below the horizon"});
  json["symmetry"] = symmetryText(brdf.symmetry());
  json["reciprocal_by_construction"] = brdf.reciprocal();

  json["albedo"] = Json::array();
  for (const double degreesI : {0.0, 60.0}) {
    const Albedo albedo = directionalAlbedo(brdf, radians(degreesI), points);
    const double error = *std::max_element(albedo.error.begin(), albedo.error.end());
    table.row({"albedo at " + formatNumber(degreesI) + " deg",
               listText(albedo.value) + "  (standard error " + formatNumber(error, 2) + ")"});
    json["albedo"].push_back({{"theta_i", degreesI}, {"value", albedo.value}, {"std_error", albedo.error}});
    if (degreesI == 0) addColour(brdf, albedo.value, values.colours, colour, table, json);
  }
  const Violations energy = energyViolations(brdf, points / 8);
  table.row({"energy", std::to_string(energy.count) + " of " + std::to_string(energy.tested) +
                           " albedos (0 to 85 deg, each channel) above 1; largest " + formatNumber(energy.worst, 4)});
  const Violations reciprocity = reciprocityViolations(brdf, 20000, kReciprocityTolerance);
  table.row({"reciprocity", std::to_string(reciprocity.count) + " of " + std::to_string(reciprocity.tested) +
                                " pairs differ by more than 1e-6 when light and viewer change places; median " +
                                formatNumber(reciprocity.median, 3) + ", largest " +
                                formatNumber(reciprocity.worst, 3) + " (relative)"});
  json["energy"] = violationsJson(energy);
  json["reciprocity"] = violationsJson(reciprocity);
  json["reciprocity"]["median"] = reciprocity.median;
  output.line(table.text());
  output.report(json);
}

}  // namespace

Command infoCommand() {
  const auto values = std::make_shared<Values>();
  return {"info", "What a material is: format, channels, samples, assumptions, albedo, violations",
          "  brdf info \"0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)\"\n"
          "  brdf info spectral.csv --illuminant A",
          [values](Arguments& arguments) {
            arguments.positional("MATERIAL", values->material, "A file, an expression or preset:NAME");
            declareColours(arguments, values->colours);
          },
          [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
