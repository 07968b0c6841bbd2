#include "Arguments.h"
#include "Assumptions.h"
#include "Commands.h"
#include "DirectionTable.h"
#include "Output.h"
#include "Progress.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/material/LobeSum.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

struct Values {
  std::string material;
  std::vector<std::string> at;
  std::string directions, out;
  std::string precision = "double";
  bool pdf = false;
};

void evaluateFloat(const Brdf& brdf, const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) {
  DirectionPairBuffer<float> rounded(pairs.count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::copy_n(pairs.wi[axis], pairs.count, rounded.wi[axis].begin());
    std::copy_n(pairs.wo[axis], pairs.count, rounded.wo[axis].begin());
  }
  std::vector<float> result(brdf.channels().count() * pairs.count);
  brdf.evaluate(rounded.view(), result.data(), valid);
  std::copy(result.begin(), result.end(), values);
}

void evaluateExtended(const LobeSum& sum, const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) {
  const std::size_t channels = sum.channels().count();
  for (std::size_t i = 0; i < pairs.count; ++i) {
    const Direction wi = {pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
    const Direction wo = {pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
    for (std::size_t c = 0; c < channels; ++c) values[c * pairs.count + i] = 0;
    for (const Lobe& lobe : sum.lobes()) {
      double shared = 0;
      for (std::size_t c = 0; c < channels; ++c) {
        if (c == 0 || !lobe.channelIndependent())
          shared = lobe.model->evaluateExtended(wi, wo, lobe.parametersOf(c)).front();
        values[c * pairs.count + i] += lobe.scaleOf(c) * shared;
      }
    }
    valid[i] = 1;
  }
}

BlockEvaluator evaluatorFor(BrdfPointer brdf, const std::string& material, const std::string& precision) {
  const auto sum = std::dynamic_pointer_cast<const LobeSum>(brdf);
  if (precision == "extended" && !sum)
    throw Error(Error::Kind::Value, {"extended precision needs a formula, and this material is data", material,
                                     "--precision extended", "float, double"});
  return [brdf, sum, precision](const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid,
                                double* density) {
    if (precision == "float")
      evaluateFloat(*brdf, pairs, values, valid);
    else if (precision == "extended")
      evaluateExtended(*sum, pairs, values, valid);
    else
      brdf->evaluate(pairs, values, valid);
    if (density) brdf->pdf(pairs, density);
  };
}

/// Evaluates the directions given by --at: a table for people, `values` of the report.
Json evaluateAngles(const Output& output, const Values& values, const Brdf& brdf, const BlockEvaluator& evaluate) {
  DirectionPairBuffer<double> pairs;
  std::vector<std::vector<double>> angles;
  for (const std::string& text : values.at) {
    angles.push_back(numberListOption("--at", text, 4, "theta_i,phi_i,theta_o,phi_o (degrees), say 30,0,30,180"));
    const auto& a = angles.back();
    pairs.push(fromSpherical(radians(a[0]), radians(a[1])), fromSpherical(radians(a[2]), radians(a[3])));
  }
  const std::size_t count = pairs.size(), channels = brdf.channels().count();
  std::vector<double> results(channels * count), density(count);
  std::vector<std::uint8_t> valid(count);
  evaluate(pairs.view(), results.data(), valid.data(), values.pdf ? density.data() : nullptr);

  std::vector<std::string> header = {"theta_i", "phi_i", "theta_o", "phi_o"};
  for (std::size_t c = 0; c < channels; ++c) header.push_back("value_" + std::to_string(c));
  if (values.pdf) header.push_back("pdf");
  TextTable table(header);
  Json list = Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    const auto& a = angles[i];
    std::vector<std::string> cells;
    for (const double angle : a) cells.push_back(formatNumber(angle));
    Json value = Json::array();
    for (std::size_t c = 0; c < channels; ++c) {
      cells.push_back(valid[i] ? formatNumber(results[c * count + i], 17) : "no value");
      value.push_back(valid[i] ? Json(results[c * count + i]) : Json());
    }
    Json entry = {{"theta_i", a[0]}, {"phi_i", a[1]}, {"theta_o", a[2]}, {"phi_o", a[3]}};
    entry["value"] = value;
    entry["valid"] = valid[i] != 0;
    if (values.pdf) {
      cells.push_back(formatNumber(density[i], 17));
      entry["pdf"] = density[i];
    }
    table.row(cells);
    list.push_back(entry);
  }
  output.line("Angles in degrees, values in 1/sr without the cosine.\n" + table.text());
  return list;
}

void run(const Output& output, const Values& values) {
  if (values.at.empty() == values.directions.empty())
    throw Error(Error::Kind::Usage, {"where to evaluate is not clear", "brdf eval",
                                     values.at.empty() ? "neither" : "both", "either --at or --directions"});
  if (values.directions.empty() != values.out.empty())
    throw Error(Error::Kind::Usage, {"--directions and --out go together", "brdf eval", "one of them", "both"});
  checkWritable(values.out);
  const BrdfPointer brdf = loadMaterial(values.material, assumptions()).brdf;
  const auto evaluate = evaluatorFor(brdf, values.material, values.precision);

  Json report = {{"material", brdf->description()}, {"unit", "1/sr"}, {"precision", values.precision}};
  report["wavelengths"] = brdf->channels().wavelengths;
  if (!values.at.empty()) {
    report["values"] = evaluateAngles(output, values, *brdf, evaluate);
  } else {
    Progress progress(output, "eval");
    const auto result = evaluateTable(values.directions, values.out, brdf->channels().count(), values.pdf, evaluate,
                                      [&progress](std::size_t done, std::size_t total) {
                                        progress.update(done, total);
                                        return !interrupted();
                                      });
    report["rows"] = result.rows;
    report["invalid"] = result.invalid;
    report["out"] = values.out;
    output.line(values.out + ": " + std::to_string(result.rows) + " rows" +
                (result.invalid ? ", of these without a value (nan): " + std::to_string(result.invalid) : ""));
  }
  output.report(report);
}

}  // namespace

Command evalCommand() {
  const auto values = std::make_shared<Values>();
  return {"eval", "Values of a material at given directions",
          "  brdf eval \"0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)\" --at 30,0,30,180 --at 45,0,20,90 --pdf",
          [values](Arguments& arguments) {
            arguments.positional("MATERIAL", values->material, "A file, an expression or preset:NAME");
            arguments.option("--at", values->at, "ANGLES",
                             "theta_i,phi_i,theta_o,phi_o in degrees; may be given several times");
            arguments.option("--directions", values->directions, "CSV",
                             "File with the columns wi_x,wi_y,wi_z,wo_x,wo_y,wo_z (unit vectors)");
            arguments.option("--out", values->out, "CSV",
                             "With --directions: its rows with value_0.. added, one a channel; nan where no value");
            arguments.flag("--pdf", values->pdf, "Add the density (1/sr) of sampling wi given wo");
            arguments.choice("--precision", values->precision, {"float", "double", "extended"},
                             "Arithmetic; extended is 50 digits, for formulas only");
          },
          [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
