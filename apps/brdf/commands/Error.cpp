#include "Arguments.h"
#include "Assumptions.h"
#include "Colours.h"
#include "Commands.h"
#include "Output.h"
#include "Pictures.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/view/ErrorMap.h>

#include <algorithm>

#include <nlohmann/json.hpp>

namespace brdf::app {

namespace {

struct Values {
  ErrorPicture request;
  std::string size = "900x700";
};

nlohmann::ordered_json worstJson(const ErrorResult::Worst& one) {
  return {{"error", one.error}, {"theta_i", one.thetaI},
          {"phi_i", one.phiI},  {"theta_o", one.thetaO},
          {"phi_o", one.phiO},  {"a", one.a},
          {"b", one.b}};
}

/// The first channels' values, as the table has room.
std::string shown(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (std::size_t c = 0; c < std::min<std::size_t>(values.size(), 3); ++c) texts.push_back(number(values[c]));
  return joined(texts) + (values.size() > 3 ? ", ..." : "");
}

std::string worstTable(const std::vector<ErrorResult::Worst>& worst) {
  TextTable table({"", "error", "theta_i", "phi_i", "theta_o", "phi_o", "A (1/sr)", "B (1/sr)"});
  std::size_t place = 0;
  for (const ErrorResult::Worst& one : worst)
    table.row({std::to_string(++place), number(one.error), number(one.thetaI), number(one.phiI), number(one.thetaO),
               number(one.phiO), shown(one.a), shown(one.b)});
  return table.text();
}

std::string metricList() {
  std::vector<std::string> names;
  for (const MetricPointer& metric : allMetrics()) names.push_back(metric->name());
  return joined(names);
}

/// Before anything is loaded.
void checkMeasure(const ErrorPicture& request) {
  try {
    parseErrorMeasure(request.measure, request.average);
  } catch (const Error& error) {
    Error::Details details = error.details();
    details.where = "--measure";
    throw Error(error.kind() == Error::Kind::Value ? Error::Kind::Usage : error.kind(), details);
  }
}

void run(const Output& output, Values& values) {
  ErrorPicture& request = values.request;
  request.assumptions = assumptions();
  request.size = sizeOption(values.size);
  colourSettings(request.colours);  // says what is wrong before anything is loaded
  checkMeasure(request);
  checkPictureOutputs(request.out, {".png", ".svg", ".pdf", ".vti", ".exr", ".csv"});
  checkPictureOutputs(request.histogram, {".png", ".svg", ".pdf", ".csv"});
  if (!request.worstOut.empty()) checkPictureOutputs({request.worstOut}, {".csv"});
  if (request.out.empty() && request.histogram.empty() && request.worstOut.empty() && output.jsonTarget.empty())
    throw Error(Error::Kind::Usage, {"nothing to write", "error", "", "--out, --histogram, --worst-out or --json"});
  const ErrorResult result = pictures().error(request);
  std::vector<std::string> files = request.out;
  files.insert(files.end(), request.histogram.begin(), request.histogram.end());
  if (!request.worstOut.empty()) files.push_back(request.worstOut);
  std::string quantiles;
  nlohmann::ordered_json quantilesJson = nlohmann::ordered_json::array();
  for (const auto& [share, error] : result.quantiles) {
    quantilesJson.push_back({{"share", share}, {"error", error}});
    if (share == 0.5 || share == 0.9 || share == 0.99) quantiles += number(100 * share) + " % " + number(error) + ", ";
  }
  if (!quantiles.empty()) {
    const double smallest = result.quantiles.front().second, largest = result.quantiles.back().second;
    quantiles = "\nof single pairs: " + (smallest < 0 ? "smallest " + number(smallest) + ", " : "") + quantiles +
                "largest " + number(largest);
  }
  output.line((files.empty() ? "" : joined(files) + ": ") + result.label + "\nover all " + number(result.mean) +
              ", largest point of the map " + number(result.largest) + "; " + std::to_string(result.pairs) +
              " pairs, " + result.sampling + quantiles);
  if (!result.worst.empty()) output.line("\n" + worstTable(result.worst));
  nlohmann::ordered_json worst = nlohmann::ordered_json::array();
  for (const ErrorResult::Worst& one : result.worst) worst.push_back(worstJson(one));
  output.report({{"a", request.a},
                 {"b", request.b},
                 {"measure", request.measure},
                 {"average", request.average},
                 {"label", result.label},
                 {"axes", request.axes},
                 {"channel", request.channel},
                 {"colour", coloursJson(request.colours)},
                 {"mean", result.mean},
                 {"channels", result.channels},
                 {"largest", result.largest},
                 {"count", result.count},
                 {"pairs", result.pairs},
                 {"left_out", result.leftOut},
                 {"sampling", result.sampling},
                 {"quantiles", quantilesJson},
                 {"worst", worst},
                 {"out", files}});
}

}  // namespace

Command errorCommand() {
  const auto values = std::make_shared<Values>();
  return {"error", "Map where two materials differ over the directions",
          "  brdf error \"0.3*Lambertian + 0.05*GGX(alpha=0.25)\" \"0.3*Lambertian + 0.05*GGX(alpha=0.2)\" --out "
          "error.png\n"
          "  brdf error \"GGX(alpha=0.25)\" \"GGX(alpha=0.2)\" --axes hemisphere --theta-i 60 --measure log --worst 5 "
          "--out "
          "disk.png --histogram log.png\n"
          "  brdf error spectral.xml spectral.csv --channel rgb --illuminant F11 --out lamp.png",
          [values](Arguments& arguments) {
            ErrorPicture& request = values->request;
            arguments.positional("A", request.a, "A material");
            arguments.positional("B", request.b, "Another; when measured, its own samples are compared");
            arguments.option("--measure", request.measure, "NAME",
                             "difference or absolute (means of f_A - f_B), or a metric: " + metricList() +
                                 ", relative:FLOOR, huber:DELTA, formula:TEXT [absolute]");
            arguments.choice("--average", request.average, errorAverageNames(),
                             "Over the pairs at a point; automatic is rms for a metric");
            arguments.choice("--axes", request.axes, errorAxesNames(),
                             "The two angles of the map, or all view directions");
            arguments.option("--theta-i", request.thetaI, {0, 89.999}, "DEGREES",
                             "Incident polar angle, of the hemisphere");
            arguments.option("--phi-i", request.phiI, {-360, 360}, "DEGREES", "Incident azimuth, of the hemisphere");
            arguments.choice("--projection", request.projection, diskProjectionNames(), "Of the hemisphere");
            arguments.choice("--directions", request.directions, errorDirectionsNames(),
                             "Where to compare; automatic is samples where there are any, but not on the hemisphere");
            arguments.option("--within", request.within, {0, 180}, "DEGREES",
                             "How far the light of samples may be from that of the hemisphere");
            arguments.option("--channel", request.channel, "NAME",
                             "rgb, luminance, all, a number from 0, or a wavelength such as 550nm [luminance]");
            declareColours(arguments, request.colours, true);
            arguments.option("--resolution", request.resolution, {0, 1000}, "Intervals along each axis; 0 chooses");
            arguments.option("--worst", request.worst, {0, 10000}, "How many of the worst directions to list and mark");
            arguments.option("--worst-out", request.worstOut, "FILE", "x.csv for that list");
            arguments.option("--histogram", request.histogram, "FILE",
                             "x.png, x.svg, x.pdf, or x.csv, of the errors of single pairs; several times");
            arguments.option("--bins", request.bins, {1, 10000}, "Of the histogram");
            arguments.option("--size", values->size, "WxH", "Pixels of the picture [900x700]");
            arguments.option("--out", request.out, "FILE",
                             "x.png, x.svg or x.pdf, or x.vti, x.exr or x.csv for the numbers; several times");
          },
          [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
