#include "Arguments.h"
#include "Assumptions.h"
#include "Commands.h"
#include "FitReportJson.h"
#include "Output.h"
#include "SampleArguments.h"

#include <brdf/fit/Fit.h>
#include <brdf/io/LoadMaterial.h>

#include <nlohmann/json.hpp>

namespace brdf::app {

Command compareCommand() {
  struct Values {
    std::string a, b, channels = "spectral", metric;
    double maximumTheta = 90;
    SampleArguments samples;
    std::size_t seed = 1;
  };
  const auto values = std::make_shared<Values>();
  return {"compare", "Differences of two materials by every metric",
          "  brdf compare \"0.3*Lambertian + 0.05*GGX(alpha=0.25, ior=1.5)\" \"0.3*Lambertian + 0.05*GGX(alpha=0.2, "
          "ior=1.5)\"",
          [values](Arguments& arguments) {
            arguments.positional("A", values->a, "A material");
            arguments.positional("B", values->b, "Another; when measured, A is evaluated at B's own samples");
            arguments.option("--channels", values->channels, "LIST",
                             "luminance, rgb, spectral (the data's own) or numbers from 0 as in 0,3,5");
            arguments.option("--max-theta", values->maximumTheta, {0, 90}, "DEGREES",
                             "Leave out samples with theta_i or theta_o above");
            values->samples.declare(arguments);
            arguments.option("--seed", values->seed, {0, 9e15}, "Of --sampling importance");
            arguments.option("--metric", values->metric, "NAME",
                             metricHelp("One to judge by besides the plain ones", ""));
          },
          [values](const Output& output) {
            checkMetric(values->metric);
            const FitChannels channels = channelsOption(values->channels);
            const BrdfPointer a = selectChannels(loadMaterial(values->a, assumptions()).brdf, channels);
            const BrdfPointer b = selectChannels(loadMaterial(values->b, assumptions()).brdf, channels);
            const Comparison result =
                compare(*a, *b, values->maximumTheta, values->metric, values->samples.choice(values->seed));
            output.line("A  " + a->description() + "\nB  " + b->description() + "\n\n" +
                        metricTable(result.metrics, result.zeroModel) + "\n\n  " + std::to_string(result.samples) +
                        " samples, " + std::to_string(result.channels) + " channels; " + result.sampling);
            output.report({{"a", a->description()},
                           {"b", b->description()},
                           {"metrics", result.metrics},
                           {"zero_model", result.zeroModel},
                           {"formulas", result.formulas},
                           {"samples", result.samples},
                           {"channels", result.channels},
                           {"sampling", result.sampling}});
          }};
}

}  // namespace brdf::app
