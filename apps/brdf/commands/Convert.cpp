#include "Arguments.h"
#include "Assumptions.h"
#include "Colours.h"
#include "Commands.h"
#include "FitReportJson.h"
#include "Output.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/Fit.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/io/SaveMaterial.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/FillHoles.h>
#include <brdf/material/RegionErrors.h>
#include <brdf/material/Resample.h>

#include <filesystem>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kPairsInARegion = 2048;

struct Values {
  std::string in, out, format, fill = "none", grid;
  ColourNames colours;
};

/// Fills holes as --fill says; what was done becomes an assumption of the material.
std::string fillAsAsked(LoadedMaterial& material, const std::string& option) {
  if (option == "none") return {};
  constexpr std::string_view prefix = "model:";
  const bool model = option.starts_with(prefix);
  const FillMethod method = fillMethod(model ? "model" : option);
  if (method == FillMethod::Model && !model)
    throw Error(Error::Kind::Usage, {"no model given", "--fill", option, "model:MATERIAL"});
  const BrdfPointer source = model ? loadMaterial(option.substr(prefix.size()), assumptions()).brdf : nullptr;
  FilledBrdf filled = fillHoles(material.brdf, method, source.get());
  material.brdf = filled.brdf;
  const std::string text = "holes: " + std::to_string(filled.filled) + " cells filled by " + option +
                           " and marked extrapolated, " + std::to_string(filled.remaining) + " left invalid";
  material.report.assumptions.push_back(text);
  return text;
}

/// The original in the channels of what was written, or null when they cannot be compared.
BrdfPointer inChannelsOf(const Brdf& written, const BrdfPointer& original, const ColourSettings& colour) {
  if (written.channels() == original->channels()) return original;
  if (written.channels().kind == Channels::Kind::Rgb) return asRgb(original, colour);
  if (written.channels().kind == Channels::Kind::Monochrome) return asLuminance(original);
  return nullptr;
}

std::string regionTable(const std::vector<RegionError>& errors, Json& json) {
  TextTable table({"directions", "mean error", "largest", "mean / mean value", "pairs lost"});
  json = Json::array();
  for (const RegionError& error : errors) {
    table.row({error.region, number(error.mean), number(error.largest), number(error.relativeMean),
               std::to_string(error.lost) + " of " + std::to_string(error.pairs + error.lost)});
    json.push_back({{"region", error.region},
                    {"mean", error.mean},
                    {"largest", error.largest},
                    {"relative_mean", error.relativeMean},
                    {"pairs", error.pairs},
                    {"lost", error.lost}});
  }
  return table.text();
}

void run(const Output& output, const Values& values) {
  if (std::filesystem::path(values.out).has_filename()) checkWritable(values.out);  // else a folder of files
  const ColourSettings colour = colourSettings(values.colours);
  LoadedMaterial loaded = loadMaterial(values.in, assumptions());
  const std::string filled = fillAsAsked(loaded, values.fill);
  const BrdfPointer original = loaded.brdf;
  std::vector<std::string> losses;
  if (!values.grid.empty()) {
    Resampled resampled = resample(*original, parseGridLayout(values.grid, *original));
    loaded.brdf = std::move(resampled.brdf);
    losses = std::move(resampled.losses);
  }
  const WriteReport written = saveMaterial(loaded, values.out, values.format, "convert", colour);
  losses.insert(losses.end(), written.losses.begin(), written.losses.end());

  const LoadedMaterial again = loadMaterial(values.out);
  Json report = {{"in", values.in}, {"out", values.out}};
  report["format"] = again.kind == "container" ? "vtkhdf" : again.report.format;
  report["samples"] = again.report.samples;
  report["losses"] = losses;
  report["filled"] = filled;
  std::string text = values.out + ": " + report["format"].get<std::string>();
  if (!filled.empty()) text += "\n  " + filled;
  for (const std::string& loss : losses) text += "\n  lost: " + loss;
  if (again.brdf->channels() == loaded.brdf->channels()) {
    const Comparison difference = compare(*again.brdf, *loaded.brdf);
    report["round_trip"] = {{"metrics", difference.metrics},
                            {"zero_model", difference.zeroModel},
                            {"samples", difference.samples},
                            {"sampling", difference.sampling}};
    text += "\n\nRead back, against what was to be written (" + difference.sampling + "):\n" +
            metricTable(difference.metrics, difference.zeroModel);
  } else {
    report["round_trip"] = Json();
    text += "\n  the channels differ, so the round trip is not compared sample by sample";
  }
  // Values in 1/sr at the same directions for every conversion, whatever the samples of either side are.
  if (const BrdfPointer seen = inChannelsOf(*again.brdf, original, colour)) {
    Json regions;
    const std::string table = regionTable(regionErrors(*again.brdf, *seen, kPairsInARegion), regions);
    text += "\n\nRead back, against the original by region of directions (1/sr):\n" + table;
    report["regions"] = regions;
  }
  output.line(text);
  output.report(report);
}

/// Everything that writers can be told, for help.
std::string settings() {
  std::vector<std::string> texts;
  for (const Format& format : allFormats())
    for (const WriteSetting& setting : format.settings)
      texts.push_back(format.name + " " + setting.key + "=" + setting.values + ", " + setting.meaning);
  return joined(texts, "; ");
}

}  // namespace

Command convertCommand() {
  const auto values = std::make_shared<Values>();
  return {"convert", "Write a material in another format",
          "  brdf convert \"(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)\" red.binary\n"
          "  brdf convert red.binary red.vtkhdf\n"
          "  brdf convert spectral.csv lamp.binary --illuminant A --observer 10",
          [values](Arguments& arguments) {
            arguments.positional("IN", values->in, "A file, an expression or preset:NAME");
            arguments.positional("OUT", values->out, "The file to write; it is replaced when complete");
            arguments.option("--format", values->format, "NAME",
                             "Format of OUT, else by its extension: " + joined(materialFormats()) +
                                 "; with settings as in " +
                                 "radiance_tree:depth=5,tolerance=0.02 where it has some: " + settings());
            arguments.option("--fill", values->fill, "METHOD",
                             "Fill invalid cells and mark them extrapolated: none, reciprocity, symmetry, nearest, or "
                             "model:MATERIAL [none]");
            arguments.option("--grid", values->grid, "LAYOUT",
                             "Resample first: merl, or spherical, half_difference or specular with a step in degrees "
                             "as in spherical:5");
            declareColours(arguments, values->colours);
          },
          [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
