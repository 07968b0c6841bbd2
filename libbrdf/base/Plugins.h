#pragma once
#include <brdf/Version.h>
#include <brdf/brdf_export.h>

#include <filesystem>
#include <string>
#include <vector>

/// A plugin is a shared library that adds to the registries: formats (measured/Format.h), metrics (fit/Metric.h),
/// optimizers (fit/Optimizer.h), exporters (exports/Exporter.h), lobes (models/Registry.h), kinds of materials
/// (io/LoadMaterial.h) and kinds of surfaces to simulate (simulate/SurfaceKinds.h). It is loaded when the first of them
/// is asked for anything, in every program that uses the library: the command line, Python, ParaView. docs/extending.md
/// shows one.
namespace brdf {

struct PluginContext {
  std::filesystem::path file;  ///< of the plugin: what it brings besides (a folder of formulas, say) lies beside it
};

/// What a plugin exports under the name `brdfPlugin`; written by BRDF_PLUGIN.
struct PluginRecord {
  const char* builtFor;  ///< BRDF_VERSION
  const char* name;
  const char* version;
  void (*registerAll)(const PluginContext& context);  ///< calls the register functions; may throw std::exception
};

struct Plugin {
  std::filesystem::path file;
  std::string name, version;
  std::string error;  ///< why it was left out, in one line; empty when it was loaded
};

/// Every *.so of pluginFolders(), in the order of the folders and the alphabet; loaded by the first call of this
/// function or of any registry. A plugin that fails is left out, and says why here. Plugins are never unloaded.
BRDF_EXPORT const std::vector<Plugin>& plugins();

/// Where plugins are looked for: the folders of BRDFLAB_PLUGIN_PATH (separated by ':'), then brdflab/plugins beside the
/// library. Those that do not exist are left out.
BRDF_EXPORT std::vector<std::filesystem::path> pluginFolders();

}  // namespace brdf

/// At file scope of one source of a plugin: BRDF_PLUGIN("mine", "1.0", registerMine)
#define BRDF_PLUGIN(name, version, function)        \
  extern "C" __attribute__((visibility("default"))) \
  const ::brdf::PluginRecord brdfPlugin{BRDF_VERSION, name, version, function};
