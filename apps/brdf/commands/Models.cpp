#include "Arguments.h"
#include "Commands.h"
#include "Output.h"

#include <brdf/base/Text.h>
#include <brdf/models/Model.h>

#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

std::string citation(const Reference& reference) {
  std::string text = reference.authors;
  if (reference.year != 0) text += (text.empty() ? "" : " ") + std::to_string(reference.year);
  for (const std::string* part : {&reference.title, &reference.venue})
    if (!part->empty()) text += ", " + *part;
  if (!reference.equations.empty()) text += ", eq. " + reference.equations;
  if (!reference.doi.empty()) text += ", doi:" + reference.doi;
  return text;
}

Json modelJson(const Model& model, bool page) {
  Json parameters = Json::array();
  for (const Parameter& p : model.parameters()) {
    Json parameter = {{"name", p.name},
                      {"default", p.defaultValue},
                      {"min", p.minimum},
                      {"max", p.maximum},
                      {"unit", p.unit},
                      {"description", p.description},
                      {"label", p.label},
                      {"symbol", p.symbol},
                      {"soft_min", p.softMinimum},
                      {"soft_max", p.softMaximum}};
    parameter["scale"] = p.scale == Parameter::Scale::Logarithmic ? "logarithmic" : "linear";
    parameters.push_back(std::move(parameter));
  }
  std::vector<std::string> references;
  for (const Reference& reference : model.references()) references.push_back(citation(reference));
  Json json = {{"name", model.name()},           {"title", model.title()},
               {"parameters", parameters},       {"reference", joined(references, "; ")},
               {"isotropic", model.isotropic()}, {"reciprocal", model.reciprocal()}};
  if (page) {
    json["description"] = model.description();
    json["equation"] = model.equation();
  }
  return json;
}

std::string parameterTable(const Model& model, const std::string& indent) {
  if (model.parameters().empty()) return indent + "no parameters but its scale factor";
  TextTable table({indent + "parameter", "default", "bounds", "usual", "unit", "meaning"});
  for (const Parameter& p : model.parameters())
    table.row({indent + p.name, number(p.defaultValue), number(p.minimum) + " to " + number(p.maximum),
               number(p.softMinimum) + " to " + number(p.softMaximum), p.unit, p.description});
  return table.text();
}

void printList(const Output& output, const std::vector<ModelPointer>& models) {
  for (const auto& model : models) {
    output.line(model->name() + ": " + model->title());
    output.line(parameterTable(*model, "    "));
    for (const Reference& reference : model->references()) output.line("    source: " + citation(reference));
    output.line("");
  }
  output.line(std::to_string(models.size()) + " lobes; brdf models NAME shows one with its formula");
}

void printPage(const Output& output, const Model& model) {
  output.line(model.name() + ": " + model.title() + "\n");
  output.line(model.description() + "\n");
  output.line(parameterTable(model, "  ") + "\n");
  output.line(std::string("  ") + (model.isotropic() ? "isotropic" : "anisotropic") + ", " +
              (model.reciprocal() ? "reciprocal" : "not reciprocal") +
              "; value in 1/sr without the cosine, 0 below the horizon\n");
  output.line("Formula\n" + model.equation() + "\n");
  output.line("Source");
  for (const Reference& reference : model.references()) output.line("  " + citation(reference));
}

}  // namespace

Command modelsCommand() {
  struct Values {
    std::string name;
  };
  const auto values = std::make_shared<Values>();
  return {"models", "List the lobes and their parameters; for one, the page with its formula",
          "  brdf models\n  brdf models GGX",
          [values](Arguments& arguments) {
            arguments.positional("NAME", values->name, "A lobe; all of them when left out");
            arguments.optional();
          },
          [values](const Output& output) {
            if (!values->name.empty()) {
              const ModelPointer model = findModel(values->name);
              printPage(output, *model);
              output.report(Json::array({modelJson(*model, true)}));
              return;
            }
            const auto models = allModels();
            printList(output, models);
            Json list = Json::array();
            for (const auto& model : models) list.push_back(modelJson(*model, false));
            output.report(list);
          }};
}

}  // namespace brdf::app
