#include <brdf/base/Plugins.h>
#include <brdf/base/Text.h>

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <set>

namespace brdf {
namespace {

/// Loads one; fills in what the plugin says of itself.
void load(Plugin& plugin) {
  void* library = dlopen(plugin.file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    plugin.error = dlerror();
    return;
  }
  const auto* record = static_cast<const PluginRecord*>(dlsym(library, "brdfPlugin"));
  if (!record) {
    plugin.error = "not a plugin: it has no BRDF_PLUGIN";
    return;
  }
  plugin.name = record->name;
  plugin.version = record->version;
  if (std::string_view(record->builtFor) != BRDF_VERSION) {
    plugin.error = std::string("built for BRDFLab ") + record->builtFor + ", this is " BRDF_VERSION;
    return;
  }
  try {
    record->registerAll({plugin.file});
  } catch (const std::exception& error) {
    plugin.error = error.what();
  }
}

std::vector<Plugin>& loaded() {
  static std::vector<Plugin> all;
  return all;
}

void loadAll() {
  std::set<std::filesystem::path> seen;
  for (const auto& folder : pluginFolders()) {
    std::vector<std::filesystem::path> files;
    std::error_code ignored;
    for (std::filesystem::directory_iterator it(folder, ignored), end; !ignored && it != end; it.increment(ignored))
      if (it->path().extension() == ".so") files.push_back(std::filesystem::absolute(it->path()).lexically_normal());
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
      if (!seen.insert(file).second) continue;
      loaded().push_back({file, "", "", ""});
      load(loaded().back());
    }
  }
}

}  // namespace

const std::vector<Plugin>& plugins() {
  // A plugin that registers itself asks registries, which ask here.
  thread_local bool inside = false;
  static std::once_flag once;
  if (!inside)
    std::call_once(once, [] {
      inside = true;
      loadAll();
      inside = false;
    });
  return loaded();
}

std::vector<std::filesystem::path> pluginFolders() {
  std::vector<std::filesystem::path> folders;
  const auto add = [&](std::filesystem::path folder) {
    std::error_code ignored;
    if (!folder.empty() && std::filesystem::is_directory(folder, ignored)) folders.push_back(std::move(folder));
  };
  if (const char* list = std::getenv("BRDFLAB_PLUGIN_PATH"))
    for (const std::string_view folder : split(list, ':')) add(folder);
  Dl_info here;
  if (dladdr(reinterpret_cast<const void*>(&pluginFolders), &here) != 0 && here.dli_fname)
    add(std::filesystem::path(here.dli_fname).parent_path() / "brdflab" / "plugins");
  return folders;
}

}  // namespace brdf
