#include "Arguments.h"
#include "Assumptions.h"
#include "Colours.h"
#include "Commands.h"
#include "FitReportJson.h"
#include "Output.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/exports/Exporter.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/LoadMaterial.h>

#include <filesystem>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

struct Values {
  std::string material, format, out;
  ExportOptions options;
  ColourNames colours;
};

std::vector<std::string> exporterNames() {
  std::vector<std::string> names;
  for (const Exporter& exporter : allExporters()) names.push_back(exporter.name);
  return names;
}

/// The exporter asked for, or the only one whose files have the extension of `out`.
const Exporter& chosen(const Values& values) {
  if (!values.format.empty()) return findExporter(values.format);
  const Exporter* found = nullptr;
  for (const Exporter& exporter : allExporters())
    if (exporter.extension == std::filesystem::path(values.out).extension()) {
      if (found)
        found = nullptr;
      else
        found = &exporter;
    }
  if (!found)
    throw Error(Error::Kind::Usage, {"the extension does not tell the format", "--out", values.out,
                                     "--format with one of " + joined(exporterNames())});
  return *found;
}

std::string angles(const std::array<double, 3>& direction) {
  const Spherical s = toSpherical(direction);
  return "(" + number(degrees(s.theta)) + ", " + number(degrees(s.phi)) + ")";
}

void run(const Output& output, const Values& values) {
  const Exporter& exporter = chosen(values);
  checkWritable(values.out);
  const LoadedMaterial loaded = loadMaterial(values.material, assumptions());
  ExportOptions options = values.options;
  options.colour = colourSettings(values.colours);
  const ExportResult result = exportMaterial(loaded.brdf, exporter, options);
  writeFile(values.out, result.text);

  const ExportError& error = result.error;
  std::string text = values.out + ": " + exporter.title + "\n";
  if (result.exact)
    text += "  exact: the target evaluates the material's own lobes";
  else
    text += "  approximation: " + result.reason + "\n  the target evaluates " + result.evaluated->description() +
            "\n\n" + metricTable(error.comparison.metrics, error.comparison.zeroModel) +
            "\n\n  worst: " + number(error.worstEvaluated) + " instead of " + number(error.worstMaterial) +
            " 1/sr, light (theta, phi) " + angles(error.wi) + ", viewer " + angles(error.wo) + " degrees\n  " +
            std::to_string(error.comparison.samples) + " samples; " + error.comparison.sampling;
  for (const std::string& note : result.notes) text += "\n  note: " + note;
  output.line(text);

  const Spherical wi = toSpherical(error.wi), wo = toSpherical(error.wo);
  output.report({{"material", values.material},
                 {"format", exporter.name},
                 {"out", values.out},
                 {"exact", result.exact},
                 {"reason", result.reason},
                 {"evaluated", result.evaluated->description()},
                 {"max_theta", values.options.maximumTheta},
                 {"colour", coloursJson(values.colours)},
                 {"metrics", error.comparison.metrics},
                 {"zero_model", error.comparison.zeroModel},
                 {"samples", error.comparison.samples},
                 {"sampling", error.comparison.sampling},
                 {"worst",
                  {{"difference", error.worstDifference},
                   {"evaluated", error.worstEvaluated},
                   {"material", error.worstMaterial},
                   {"theta_i", degrees(wi.theta)},
                   {"phi_i", degrees(wi.phi)},
                   {"theta_o", degrees(wo.theta)},
                   {"phi_o", degrees(wo.phi)}}},
                 {"notes", result.notes}});
}

}  // namespace

Command exportCommand() {
  const auto values = std::make_shared<Values>();
  return {"export", "Write a material for another program, with the error of doing so",
          "  brdf export \"(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)\" --format glsl --out red.glsl",
          [values](Arguments& arguments) {
            arguments.positional("MATERIAL", values->material, "A file, an expression or preset:NAME");
            arguments.choice("--format", values->format, exporterNames(),
                             "What to write; else by the extension of --out where that tells it");
            arguments.option("--out", values->out, "FILE", "The file to write; it is replaced when complete");
            arguments.required();
            arguments.option("--name", values->options.name, "NAME", "Of the material in the file [material]");
            arguments.flag("--uniforms", values->options.uniforms,
                           "glsl: parameters and scales are uniforms instead of constants");
            arguments.choice("--metric", values->options.metric, metricNames(), "What an approximation makes least");
            arguments.option("--max-theta", values->options.maximumTheta, {1, 90}, "DEGREES",
                             "Leave directions above out of approximations and errors");
            declareColours(arguments, values->colours);
          },
          [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
