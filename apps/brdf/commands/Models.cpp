#include "Arguments.h"
#include "Commands.h"
#include "Output.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/reference/ModelPage.h>

#include <filesystem>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

Json modelJson(const ModelPointer& pointer, bool page) {
  const Model& model = *pointer;
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
    if (!p.follows.empty()) parameter["follows"] = p.follows;
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
    json["albedo"] = Json::array();
    for (const MeasuredAlbedo& albedo : measuredAlbedos(pointer))
      json["albedo"].push_back({{"theta", albedo.degrees}, {"value", albedo.value}, {"bound", albedo.bound}});
    json["breaks"] = declaredBreaks(model);
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

/// Writes the reference into a folder that is there: a lobe's name in its place is a mistake.
void writeReference(const Output& output, const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder))
    throw Error(Error::Kind::File, {"no such folder", "--markdown", "'" + folder.string() + "'",
                                    "an existing folder; for one lobe's page, NAME --markdown"});
  std::filesystem::create_directories(folder / "models");
  const auto files = modelReference();
  Json written = Json::array();
  for (const auto& [path, text] : files) {
    writeFile(folder / path, text);
    written.push_back((folder / path).string());
  }
  output.line(std::to_string(files.size()) + " files in " + folder.string());
  output.report({{"files", written}});
}

}  // namespace

Command modelsCommand() {
  struct Values {
    std::string name, folder;
    bool markdown = false;
  };
  const auto values = std::make_shared<Values>();
  return {"models", "List the lobes and their parameters; for one, its page: formula, parameters, albedo, sources",
          "  brdf models\n  brdf models GGX\n  brdf models GGX --markdown\n  brdf models --markdown .",
          [values](Arguments& arguments) {
            arguments.positional("NAME", values->name, "A lobe; all of them when left out");
            arguments.optional();
            arguments.optionWithOptionalValue("--markdown", values->markdown, values->folder, "DIR",
                                              "Print the page in Markdown; without NAME, write the whole reference "
                                              "into DIR");
          },
          [values](const Output& output) {
            if (values->markdown && values->name.empty() == values->folder.empty())
              throw Error(
                  Error::Kind::Usage,
                  {"names neither one lobe nor one folder", "--markdown", {}, "NAME --markdown, or --markdown DIR"});
            if (!values->folder.empty()) return writeReference(output, values->folder);
            if (!values->name.empty()) {
              const ModelPointer model = findModel(values->name);
              if (output.textWanted())
                output.line(brdf::trimmed(values->markdown ? modelPageMarkdown(model) : modelPageText(model)));
              if (!output.jsonTarget.empty()) output.report(Json::array({modelJson(model, true)}));
              return;
            }
            const auto models = allModels();
            printList(output, models);
            Json list = Json::array();
            for (const auto& model : models) list.push_back(modelJson(model, false));
            output.report(list);
          }};
}

}  // namespace brdf::app
