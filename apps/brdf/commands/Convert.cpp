#include "Arguments.h"
#include "Assumptions.h"
#include "Commands.h"
#include "FitReportJson.h"
#include "Output.h"

#include <brdf/base/Text.h>
#include <brdf/fit/Fit.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/io/SaveMaterial.h>

#include <filesystem>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

struct Values {
  std::string in, out, format;
};

void run(const Output& output, const Values& values) {
  if (std::filesystem::path(values.out).has_filename()) checkWritable(values.out);  // else a folder of files
  const LoadedMaterial loaded = loadMaterial(values.in, assumptions());
  const WriteReport written = saveMaterial(loaded, values.out, values.format, "convert");

  const LoadedMaterial again = loadMaterial(values.out);
  Json report = {{"in", values.in}, {"out", values.out}};
  report["format"] = again.kind == "container" ? "vtkhdf" : again.report.format;
  report["samples"] = again.report.samples;
  report["losses"] = written.losses;
  std::string text = values.out + ": " + report["format"].get<std::string>();
  for (const std::string& loss : written.losses) text += "\n  lost: " + loss;
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
    text += "\n  the channels differ, so the round trip is not compared";
  }
  output.line(text);
  output.report(report);
}

}  // namespace

Command convertCommand() {
  const auto values = std::make_shared<Values>();
  return {"convert", "Write a material in another format",
          "  brdf convert \"(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)\" red.binary\n"
          "  brdf convert red.binary red.vtkhdf",
          [values](Arguments& arguments) {
            arguments.positional("IN", values->in, "A file, an expression or preset:NAME");
            arguments.positional("OUT", values->out, "The file to write; it is replaced when complete");
            arguments.option("--format", values->format, "NAME",
                             "Format of OUT, else by its extension: " + joined(materialFormats()));
          },
          [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
