#include "Arguments.h"
#include "Commands.h"
#include "FitArguments.h"
#include "FitReportJson.h"
#include "Output.h"
#include "Progress.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/fit/StoredFit.h>
#include <brdf/io/Container.h>

#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

struct Values {
  std::string target, out, report;
  FitArguments fit;
};

void save(const std::string& path, const FitReport& report, const LoadedMaterial& target, const FitArguments& fit) {
  ContainerWriter writer(path);
  const h5::Group group = writer.add("fit", *report.material, makeProvenance(target.report, fit.words()));
  storeFit(group, report);
  writer.commit();
}

void run(const Output& output, Values& values) {
  values.fit.resolve();
  for (const std::string* path : {&values.out, &values.report}) checkWritable(*path);
  const LoadedMaterial target = loadTarget(values.target);
  const Interruptible untilSaved;
  FitReport report;
  {
    Progress progress(output, "fit: iteration");
    report = values.fit.run(*target.brdf, [&progress](std::size_t iteration, double error) {
      progress.update(iteration, 0, "error " + number(error));
      return !interrupted();
    });
  }
  const std::string text = fitReportText(report);
  output.line(text);
  if (!values.out.empty()) save(values.out, report, target, values.fit);
  if (!values.report.empty()) writeFile(values.report, values.target + "\n" + text + "\n");
  output.report(fitReportJson(report));
  if (interrupted())
    throw Error(Error::Kind::Value, {"interrupted; the best so far was kept", "brdf fit", report.termination, ""});
}

void declare(Arguments& arguments, Values& values) {
  arguments.positional("TARGET", values.target, "Measured data or a table: a file, or file#name");
  values.fit.declare(arguments);
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
