#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Plugins.h>
#include <brdf/base/Text.h>
#include <brdf/models/FormulaModel.h>
#include <brdf/models/LegacyModel.h>
#include <brdf/models/Microfacet.h>
#include <brdf/models/Registry.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>

#include "lobeFiles.h"

namespace brdf {
namespace {

constexpr std::uint64_t kMaximumModelBytes = 1 << 20;

class Registry {
 public:
  static Registry& instance() {
    static Registry registry;
    return registry;
  }

  ModelPointer find(std::string_view name) {
    const std::lock_guard lock(mutex_);
    for (const auto* models : {&builtIn_, &added_})
      if (const auto it = models->find(name); it != models->end()) return it->second;
    return nullptr;
  }

  std::vector<ModelPointer> all() {
    const std::lock_guard lock(mutex_);
    std::vector<ModelPointer> models;
    for (const auto& [name, model] : builtIn_) models.push_back(model);
    for (const auto& [name, model] : added_) models.push_back(model);
    return models;
  }

  /// `where`: the model's file, if any.
  void add(ModelPointer model, const std::string& where = {}) {
    const std::lock_guard lock(mutex_);
    if (builtIn_.find(model->name()) != builtIn_.end() && !replaceable(model->name()))
      throw Error(Error::Kind::Value,
                  {"a built-in model has this name", where, "'" + model->name() + "'", "another name"});
    builtIn_.erase(model->name());
    added_[model->name()] = std::move(model);
  }

 private:
  Registry() {
    for (const EmbeddedFile& file : lobeFiles()) {
      const std::string where(file.name);
      auto model = std::make_shared<FormulaModel>(file.text, where);
      builtIn_[model->name()] = std::move(model);
    }
  }
  /// A model file of the original program stands for our transcription of it.
  static bool replaceable(const std::string& name) { return name.rfind("BRDFLab082", 0) == 0; }

  std::mutex mutex_;
  std::map<std::string, ModelPointer, std::less<>> builtIn_, added_;
};

std::vector<std::string>& failures() {
  static std::vector<std::string> lines;
  return lines;
}

/// Adds, once, what plugins and the user's folders bring.
void completeRegistry() {
  plugins();
  thread_local bool inside = false;  // models that are being read ask for others
  static std::once_flag once;
  if (inside) return;
  std::call_once(once, [] {
    inside = true;
    for (const auto& folder : userModelFolders()) {
      try {
        loadModelFolder(folder);
      } catch (const std::exception& error) {
        failures().push_back(error.what());
      }
    }
    inside = false;
  });
}

}  // namespace

void registerModel(ModelPointer model) { Registry::instance().add(std::move(model)); }

ModelPointer readModelFile(const std::filesystem::path& file) {
  std::string text = readFile(file, kMaximumModelBytes);
  if (isLegacyModel(text)) text = translateLegacyModel(text, file.string());
  auto model = std::make_shared<FormulaModel>(text, file.string());
  model->compile();
  return model;
}

std::vector<std::string> loadModelFolder(const std::filesystem::path& folder) {
  std::error_code code;
  std::vector<std::filesystem::path> files;
  for (std::filesystem::directory_iterator it(folder, code), end; !code && it != end; it.increment(code))
    if (it->path().extension() == ".xml") files.push_back(it->path());
  if (code) throw Error(Error::Kind::File, {"model folder cannot be read", folder.string(), code.message()});
  std::sort(files.begin(), files.end());
  std::vector<std::string> names;
  for (const auto& file : files) {
    ModelPointer model = readModelFile(file);
    names.push_back(model->name());
    Registry::instance().add(std::move(model), file.string());
  }
  return names;
}

std::vector<std::filesystem::path> userModelFolders() {
  std::vector<std::filesystem::path> folders;
  const auto add = [&](std::filesystem::path folder) {
    if (!folder.empty() && std::filesystem::is_directory(folder)) folders.push_back(std::move(folder));
  };
  if (const char* list = std::getenv("BRDFLAB_MODEL_PATH"))
    for (const std::string_view folder : split(list, ':')) add(folder);
  const char* data = std::getenv("XDG_DATA_HOME");
  const char* home = std::getenv("HOME");
  if (data != nullptr && *data != '\0')
    add(std::filesystem::path(data) / "brdflab" / "models");
  else if (home != nullptr)
    add(std::filesystem::path(home) / ".local" / "share" / "brdflab" / "models");
  return folders;
}

const std::vector<std::string>& userModelFailures() {
  completeRegistry();
  return failures();
}

std::vector<ModelPointer> allModels() {
  completeRegistry();
  return Registry::instance().all();
}

ModelPointer findModel(std::string_view name) {
  completeRegistry();
  if (ModelPointer model = Registry::instance().find(name)) return model;
  if (ModelPointer model = findMicrofacet(name)) return model;
  std::vector<std::string> names;
  for (const ModelPointer& model : allModels()) names.push_back(model->name());
  const std::string nearest = closestName(name, names);
  throw Error(Error::Kind::Value, {"unknown lobe",
                                   {},
                                   "'" + std::string(name) + "'",
                                   joined(names) + (nearest.empty() ? "" : " (did you mean " + nearest + "?)")});
}

}  // namespace brdf
