#include "Arguments.h"
#include "Commands.h"
#include "Output.h"

#include <brdf/base/Plugins.h>
#include <brdf/base/Text.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/models/Registry.h>

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
  output.line("lobes of one's own: " +
              (lobeFolders.empty() ? "no folder (BRDFLAB_MODEL_PATH names them)" : joined(lobeFolders)));
  output.report({{"folders", folders}, {"plugins", found}, {"materials", kinds}, {"lobe_folders", lobeFolders}});
}

}  // namespace

Command pluginsCommand() {
  return {"plugins", "List what was added from outside: plugins, and folders of lobes", "  brdf plugins",
          [](Arguments&) {}, run};
}

}  // namespace brdf::app
