#include "Arguments.h"
#include "Commands.h"
#include "Output.h"

#include <brdf/base/Error.h>
#include <brdf/base/Plugins.h>
#include <brdf/base/Text.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/models/Registry.h>
#include <brdf/simulate/SurfaceKinds.h>

#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> texts(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::string> result;
  for (const auto& path : paths) result.push_back(path.string());
  return result;
}

void run(const Output& output) {
  const auto folders = texts(pluginFolders()), lobeFolders = texts(userModelFolders());
  Json found = Json::array(), kinds = Json::array();
  TextTable table;
  for (const Plugin& plugin : plugins()) {
    table.row({plugin.file.string(), plugin.name, plugin.version, plugin.error.empty() ? "loaded" : plugin.error});
    found.push_back({{"file", plugin.file.string()},
                     {"name", plugin.name},
                     {"version", plugin.version},
                     {"loaded", plugin.error.empty()},
                     {"error", plugin.error}});
  }
  output.line("plugins: " + (folders.empty() ? "no folder (BRDFLAB_PLUGIN_PATH names them)" : joined(folders)));
  if (!plugins().empty()) output.line(table.text());
  for (const MaterialKind& kind : materialKinds()) {
    output.line("material " + kind.title);
    kinds.push_back({{"name", kind.name}, {"title", kind.title}});
  }
  Json surfaces = Json::array();
  for (const SurfaceKind& kind : surfaceKinds()) {
    if (kind.builtIn) continue;
    output.line("surface " + kind.name + ": " + kind.title);
    surfaces.push_back({{"name", kind.name}, {"title", kind.title}});
  }
  output.line("lobes of one's own: " +
              (lobeFolders.empty() ? "no folder (BRDFLAB_MODEL_PATH names them)" : joined(lobeFolders)));
  output.report({{"folders", folders},
                 {"plugins", found},
                 {"materials", kinds},
                 {"surfaces", surfaces},
                 {"lobe_folders", lobeFolders}});
}

const MaterialKind& findKind(const std::string& name) {
  std::vector<std::string> names;
  for (const MaterialKind& kind : materialKinds()) {
    if (kind.name == name) return kind;
    names.push_back(kind.name);
  }
  throw Error(Error::Kind::Value, {"unknown kind of materials", "brdf plugins", "'" + name + "'", joined(names)});
}

/// The models of a kind, or the parameters of one of them.
void runKind(const Output& output, const std::string& what) {
  const std::size_t colon = what.find(':');
  const std::string name = what.substr(0, colon);
  const MaterialKind& kind = findKind(name);
  const bool one = colon != std::string::npos;
  Json report = {{"name", kind.name}, {"title", kind.title}};
  output.line(kind.title);
  TextTable table;
  if (one && kind.describe) {
    const MaterialModel model = kind.describe(std::string_view(what).substr(colon + 1));
    Json parameters = Json::array();
    for (const MaterialParameter& p : model.parameters) {
      table.row({"  " + p.name, p.value, p.type, p.description});
      parameters.push_back({{"name", p.name},
                            {"type", p.type},
                            {"value", p.value},
                            {"description", p.description},
                            {"choices", p.choices}});
      if (!p.choices.empty()) table.row({"", "", "", "one of " + joined(p.choices)});
    }
    output.line(model.name + ": " + model.title + "\n" + table.text());
    report["models"] = Json::array({{{"name", model.name}, {"title", model.title}, {"parameters", parameters}}});
  } else {
    Json models = Json::array();
    if (kind.models)
      for (const MaterialModel& model : kind.models()) {
        table.row({"  " + model.name, model.title});
        models.push_back({{"name", model.name}, {"title", model.title}});
      }
    if (!models.empty())
      output.line(table.text() + "\nbrdf plugins " + kind.name + ":NAME shows one with its parameters");
    report["models"] = models;
  }
  output.report(report);
}

}  // namespace

Command pluginsCommand() {
  const auto kind = std::make_shared<std::string>();
  return {"plugins", "List what was added from outside: plugins, kinds of materials, and folders of lobes",
          "  brdf plugins\n  brdf plugins program",
          [kind](Arguments& arguments) {
            arguments.positional("KIND", *kind, "A kind of materials, or KIND:MODEL: the models, or one's parameters");
            arguments.optional();
          },
          [kind](const Output& output) { kind->empty() ? run(output) : runKind(output, *kind); }};
}

}  // namespace brdf::app
