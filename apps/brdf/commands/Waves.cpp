#include "Arguments.h"
#include "Commands.h"
#include "Output.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/reference/ModelPage.h>
#include <brdf/simulate/wave/WaveModels.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

struct Values {
  std::string model;
  std::string at, orders, films;
  std::size_t channel = 0;
};

Json kindJson(const WaveKind& kind) {
  Json parameters = Json::array(), arguments = Json::array();
  for (const Parameter& p : kind.parameters)
    parameters.push_back({{"name", p.name},
                          {"default", p.defaultValue},
                          {"min", p.minimum},
                          {"max", p.maximum},
                          {"unit", p.unit},
                          {"description", p.description},
                          {"soft_min", p.softMinimum},
                          {"soft_max", p.softMaximum},
                          {"follows", p.follows},
                          {"scale", p.scale == Parameter::Scale::Logarithmic ? "logarithmic" : "linear"}});
  for (const WaveArgument& argument : kind.arguments)
    arguments.push_back({{"name", argument.name},
                         {"family", argument.family},
                         {"description", argument.description},
                         {"default", argument.standard},
                         {"choices", argument.choices}});
  std::vector<std::string> references;
  for (const Reference& reference : kind.references) references.push_back(citation(reference));
  return {{"name", kind.name},
          {"family", kind.family},
          {"title", kind.title},
          {"description", kind.description},
          {"parameters", parameters},
          {"arguments", arguments},
          {"reference", joined(references, "; ")}};
}

void print(const Output& output, const WaveKind& kind) {
  output.line((kind.family == "model" ? "wave:" : kind.family + " ") + kind.name + ": " + kind.title);
  if (!kind.description.empty()) output.line("    " + kind.description);
  if (!kind.parameters.empty() || !kind.arguments.empty()) {
    TextTable table({"    parameter", "default", "bounds", "unit", "meaning"});
    for (const Parameter& p : kind.parameters)
      table.row({"    " + p.name, p.follows.empty() ? number(p.defaultValue) : p.follows,
                 number(p.minimum) + " to " + number(p.maximum), p.unit, p.description});
    for (const WaveArgument& argument : kind.arguments)
      table.row({"    " + argument.name, argument.standard,
                 argument.choices.empty() ? argument.family : joined(argument.choices), "", argument.description});
    output.line(table.text());
  }
  for (const Reference& reference : kind.references) output.line("    source: " + citation(reference));
  output.line("");
}

void list(const Output& output, const std::string& name) {
  Json report = Json::array();
  const bool isFamily = std::ranges::any_of(waveKinds(), [&](const WaveKind& kind) { return kind.family == name; });
  if (!name.empty() && !isFamily) findWaveModel(name);
  for (const WaveKind& kind : waveKinds()) {
    const bool own = name.empty() || kind.family == name || (kind.family == "model" && kind.name == name);
    if (!own) continue;
    print(output, kind);
    report.push_back(kindJson(kind));
  }
  if (name.empty())
    output.line("write wave:MODEL(parameter=value, ...) wherever a material is; arguments are of the families listed");
  output.report(report);
}

/// The matrix at one pair of directions.
void mueller(const Output& output, const Values& values) {
  const auto a = numberListOption("--at", values.at, 4, "theta_i,phi_i,theta_o,phi_o (degrees), say 30,180,45,20");
  const auto model = makeWaveBrdf(values.model);
  if (values.channel >= model->models().size())
    throw Error(Error::Kind::Usage, {"no such channel", "--channel", std::to_string(values.channel),
                                     "0 to " + std::to_string(model->models().size() - 1)});
  const Direction wi = fromSpherical(radians(a[0]), radians(a[1])), wo = fromSpherical(radians(a[2]), radians(a[3]));
  wave::Mueller matrix;
  model->mueller({{&wi[0], &wi[1], &wi[2]}, {&wo[0], &wo[1], &wo[2]}, 1}, values.channel, &matrix);
  output.line("Mueller matrix in 1/sr; Stokes vector (Is + Ip, Is - Ip, I(s+p) - I(s-p), Ilcp - Ircp)");
  TextTable table;
  Json rows = Json::array();
  for (std::size_t r = 0; r < 4; ++r) {
    std::vector<std::string> texts;
    Json row = Json::array();
    for (std::size_t c = 0; c < 4; ++c) {
      texts.push_back(formatNumber(matrix(r, c) + 0.0, 8));  // no -0
      row.push_back(matrix(r, c) + 0.0);
    }
    table.row(texts);
    rows.push_back(row);
  }
  output.line(table.text());
  output.report({{"material", model->description()}, {"at", a}, {"mueller", rows}});
}

void orders(const Output& output, const Values& values) {
  const auto a = numberListOption("--orders", values.orders, 2, "theta_i,phi_i (degrees), say 30,180");
  TextTable table({"order", "theta (deg)", "phi (deg)", "share", "efficiency"});
  Json rows = Json::array();
  for (const wave::GratingOrder& order : gratingOrders(values.model, values.channel, radians(a[0]), radians(a[1]))) {
    table.row({std::to_string(order.order), number(degrees(order.theta)), number(degrees(order.phi)),
               number(order.share), number(order.efficiency)});
    rows.push_back({{"order", order.order},
                    {"theta", degrees(order.theta)},
                    {"phi", degrees(order.phi)},
                    {"share", order.share},
                    {"efficiency", order.efficiency}});
  }
  output.line(table.text());
  output.report({{"orders", rows}});
}

void films(const Output& output, const Values& values) {
  const auto a = numberListOption("--films", values.films, 1, "theta_i (degrees), say 45");
  const wave::FilmStack::Powers powers = filmPowers(values.model, values.channel, radians(a[0]));
  TextTable table({"", "reflected", "transmitted"});
  table.row({"s", number(powers.reflectedS), number(powers.transmittedS)});
  table.row({"p", number(powers.reflectedP), number(powers.transmittedP)});
  output.line(table.text());
  output.report({{"reflected_s", powers.reflectedS},
                 {"reflected_p", powers.reflectedP},
                 {"transmitted_s", powers.transmittedS},
                 {"transmitted_p", powers.transmittedP}});
}

void run(const Output& output, const Values& values) {
  const int asked = !values.at.empty() + !values.orders.empty() + !values.films.empty();
  if (asked > 1 || (asked == 1 && values.model.empty()))
    throw Error(Error::Kind::Usage, {asked > 1 ? "one question at a time" : "of which model?",
                                     "brdf waves",
                                     {},
                                     "MODEL with one of --at, --orders, --films"});
  if (!values.at.empty()) return mueller(output, values);
  if (!values.orders.empty()) return orders(output, values);
  if (!values.films.empty()) return films(output, values);
  list(output, values.model);
}

}  // namespace

Command wavesCommand() {
  const auto values = std::make_shared<Values>();
  return {"waves", "List the wave-optical models; of one its Mueller matrix, grating orders, reflectance of films",
          "  brdf waves\n  brdf waves RayleighRice\n"
          "  brdf waves \"wave:RayleighRice(wavelength=0.633, spectrum=abc(a=0.01, b=5, c=3))\" --at 30,180,45,20\n"
          "  brdf waves \"wave:Grating(period=5, depth=0.2)\" --orders 30,180",
          [values](Arguments& arguments) {
            arguments.positional("MODEL", values->model,
                                 "A model, a family of parts (spectrum, slopes, ...), or an expression wave:...");
            arguments.optional();
            arguments.option("--at", values->at, "ANGLES", "Mueller matrix at theta_i,phi_i,theta_o,phi_o in degrees");
            arguments.option("--orders", values->orders, "ANGLES",
                             "Orders of a Grating lit from theta_i,phi_i in degrees");
            arguments.option("--films", values->films, "ANGLE",
                             "Fractions of power that substrate and films reflect and transmit at theta_i in degrees");
            arguments.option("--channel", values->channel, {0, 1e6}, "Which of several wavelengths, from 0");
          },
          [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
