#include "Arguments.h"
#include "Assumptions.h"
#include "Commands.h"
#include "FitReportJson.h"
#include "Output.h"
#include "Progress.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/fit/LobeRequests.h>
#include <brdf/fit/StoredFit.h>
#include <brdf/io/Container.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/material/LobeSum.h>

#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

struct Values {
  std::string target, lobes = "Lambertian + GGX", channels = "spectral", out, report;
  std::string strategy = "automatic", combination = "shared";
  std::vector<std::string> fixed;
  bool progressive = false, noScan = false;
  std::size_t seed = 1;
  FitOptions options;
};

/// Runs `read`; an error names the option first.
template <class Read>
auto fromOption(const char* option, Read read) {
  try {
    return read();
  } catch (const Error& error) {
    Error::Details details = error.details();
    details.where = details.where.empty() ? option : std::string(option) + ", " + details.where;
    throw Error(error.kind(), std::move(details));
  }
}

/// One lobe more at a time, each fit starting from the one before.
FitReport fitProgressively(const Brdf& target, std::vector<LobeRequest> requests, const FitOptions& options) {
  FitReport report;
  for (std::size_t count = 1; count <= requests.size(); ++count) {
    report = fit(target, {requests.begin(), requests.begin() + static_cast<std::ptrdiff_t>(count)}, options);
    if (interrupted()) break;
    for (const FittedParameter& p : report.parameters)
      if (!p.channel && !p.fixed && p.name != "scale") requests[p.lobeIndex].start[p.name] = p.value;
  }
  return report;
}

void save(const std::string& path, const FitReport& report, const LoadedMaterial& target, const Values& values) {
  ContainerWriter writer(path);
  const std::string options = "fit --lobes \"" + values.lobes + "\" --metric " + values.options.metric +
                              " --optimizer " + values.options.optimizer + " --channels " + values.channels +
                              " --combination " + values.combination + " --max-theta " +
                              formatNumber(values.options.maximumTheta);
  const h5::Group group = writer.add("fit", *report.material, makeProvenance(target.report, options));
  storeFit(group, report);
  writer.commit();
}

void run(const Output& output, Values values) {
  FitOptions& options = values.options;
  options.seed = values.seed;
  options.scan = !values.noScan;
  options.channels = channelsOption(values.channels);
  options.strategy = values.strategy == "separable" ? Strategy::Separable
                     : values.strategy == "joint"   ? Strategy::Joint
                                                    : Strategy::Automatic;
  options.combination = values.combination == "shared" ? Combination::Shared : Combination::PerChannel;
  auto requests = fromOption("--lobes", [&] { return parseLobeRequests(values.lobes); });
  for (const std::string& text : values.fixed) fromOption("--fix", [&] { holdParameter(requests, text); });
  for (const std::string* path : {&values.out, &values.report}) checkWritable(*path);

  const LoadedMaterial target = loadMaterial(values.target, assumptions());
  if (!target.brdf->samples())
    throw Error(Error::Kind::Value, {"nothing to fit: a formula has no samples", values.target, target.kind,
                                     "measured data, or a table that `brdf convert` makes"});
  const Interruptible untilSaved;
  FitReport report;
  {
    Progress progress(output, "fit: iteration");
    options.progress = [&progress](std::size_t iteration, double error) {
      progress.update(iteration, 0, "error " + number(error));
      return !interrupted();
    };
    report =
        values.progressive ? fitProgressively(*target.brdf, requests, options) : fit(*target.brdf, requests, options);
  }
  const std::string text = fitReportText(report);
  output.line(text);
  if (!values.out.empty()) save(values.out, report, target, values);
  if (!values.report.empty()) writeFile(values.report, values.target + "\n" + text + "\n");
  output.report(fitReportJson(report));
  if (interrupted())
    throw Error(Error::Kind::Value, {"interrupted; the best so far was kept", "brdf fit", report.termination, ""});
}

void declare(Arguments& arguments, Values& values) {
  FitOptions& options = values.options;
  arguments.positional("TARGET", values.target, "Measured data or a table: a file, or file#name");
  arguments.option("--lobes", values.lobes, "SUM",
                   "Lobes to fit; parameters written there are starting values [" + values.lobes + "]");
  arguments.choice("--optimizer", options.optimizer, optimizerNames(), "How the shape parameters are searched");
  arguments.choice("--metric", options.metric, metricNames(), "What is minimised");
  arguments.option("--channels", values.channels, "LIST",
                   "luminance, rgb, spectral (the data's own) or numbers from 0 as in 0,3,5 [spectral]");
  arguments.choice("--strategy", values.strategy, {"automatic", "separable", "joint"},
                   "Scale factors by linear least squares inside, or searched with the rest");
  arguments.choice("--combination", values.combination, {"shared", "per-channel"},
                   "One shape for all channels, or one each");
  arguments.flag("--progressive", values.progressive, "Fit one lobe more at a time, in the order given");
  arguments.option("--starts", options.starts, {0, 100000}, "Random starts besides the scan");
  arguments.option("--seed", values.seed, {0, 9e15}, "Of the random starts");
  arguments.flag("--no-scan", values.noScan, "Start from the defaults instead of scanning the shapes");
  arguments.option("--tolerance", options.tolerance, {0, 1}, "NUMBER", "Relative: stop when steps gain less");
  arguments.option("--max-iterations", options.maximumIterations, {1, 1000000}, "Of each start");
  arguments.option("--max-theta", options.maximumTheta, {0, 90}, "DEGREES",
                   "Leave out samples with theta_i or theta_o above");
  arguments.option("--fix", values.fixed, "NAME=VALUE",
                   "Hold a parameter, in every lobe or as in GGX.ior=1.5; several times");
  arguments.option("--out", values.out, "FILE.vtkhdf", "Keep the fit, with its provenance, in a container");
  arguments.option("--report", values.report, "FILE.txt", "Keep the report as text");
}

}  // namespace

Command fitCommand() {
  const auto values = std::make_shared<Values>();
  return {"fit", "Fit a sum of lobes to measured data",
          "  brdf convert \"0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)\" sample.binary\n"
          "  brdf fit sample.binary --lobes \"Lambertian + GGX\" --fix ior=1.5 --max-theta 80 --out fit.vtkhdf",
          [values](Arguments& arguments) { declare(arguments, *values); },
          [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
