#include "Job.h"

#include "Arguments.h"
#include "Assumptions.h"

#include <brdf/Version.h>
#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/JsonText.h>
#include <brdf/base/Text.h>
#include <brdf/io/Sha256.h>
#include <brdf/material/LobeSum.h>

#include <algorithm>
#include <map>
#include <set>

namespace fs = std::filesystem;

namespace brdf::app {
namespace {

constexpr std::size_t kMostTasks = 100000;

[[noreturn]] void bad(std::string what, std::string where, const Json& found, std::string allowed) {
  throw Error(Error::Kind::Format, {std::move(what), std::move(where), shortened(found, 60), std::move(allowed)});
}

/// Refuses keys that nothing reads: a misspelt one would otherwise be silently without effect.
void checkKeys(const Json& object, const std::string& where, const std::vector<std::string>& known) {
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::string nearest = closestName(key, known);
    bad("unknown key", where, key, joined(known) + (nearest.empty() ? "" : "; nearest: " + nearest));
  }
}

std::string textOf(const Json& object, const char* key, const std::string& where, const std::string& otherwise) {
  if (!object.contains(key)) return otherwise;
  if (!object[key].is_string()) bad("not a text", where + ": " + key, object[key], "a text");
  return object[key].get<std::string>();
}

/// A file named by the job lies beside it, unless the path is absolute; expressions and presets stay as they are.
std::string materialBeside(const fs::path& folder, const std::string& material) {
  const fs::path whole = folder / material;
  const fs::path file = folder / material.substr(0, material.rfind('#'));
  std::error_code ignored;
  return fs::exists(whole, ignored) || fs::exists(file, ignored) ? whole.lexically_normal().string() : material;
}

std::vector<BatchTarget> readTargets(const Json& list, const fs::path& path,
                                     const std::function<std::string(const std::string&)>& contentHash) {
  const std::string where = path.string() + ": targets";
  if (!list.is_array() || list.empty())
    bad("no targets", where, list, "a list of materials, or of objects with name and material");
  std::vector<BatchTarget> targets;
  std::set<std::string> names;
  for (const Json& item : list) {
    const std::string at = where + "[" + std::to_string(targets.size()) + "]";
    BatchTarget target;
    if (item.is_string()) {
      target.material = item.get<std::string>();
    } else if (item.is_object()) {
      checkKeys(item, at, {"name", "material"});
      target.material = textOf(item, "material", at, "");
      target.name = textOf(item, "name", at, "");
    }
    if (target.material.empty()) bad("no material", at, item, "a material, or an object with name and material");
    if (target.name.empty()) target.name = fs::path(target.material).stem().string();
    if (!names.insert(target.name).second)
      bad("two targets of one name", at, target.name, "names of their own: {\"name\": ..., \"material\": ...}");
    target.material = materialBeside(path.parent_path(), target.material);
    target.hash = contentHash(target.material);
    targets.push_back(std::move(target));
  }
  return targets;
}

/// One value of an option: the words for the command line (several where it is given several times), and for people.
struct Choice {
  std::vector<std::string> words;
  std::string text;
};

void addValue(const std::string& name, const Json& value, const std::string& where, Choice& choice) {
  if (value.is_boolean()) {
    if (value.get<bool>()) choice.words.push_back("--" + name);
    choice.text += value.get<bool>() ? "yes" : "no";
  } else if (value.is_string() || value.is_number()) {
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    choice.words.push_back("--" + name + "=" + text);
    choice.text += (choice.text.empty() ? "" : " ") + text;
  } else {
    bad("not a value of an option", where, value, "a text, a number, true or false, or a list of them");
  }
}

struct Option {
  std::string name;
  std::vector<Choice> choices;
};

std::vector<Option> readOptions(const Json& fits, const std::string& where) {
  std::vector<Option> options;
  for (const auto& [name, value] : fits.items()) {
    if (name == "title") continue;
    const std::string at = where + ": " + name;
    if (name.empty() || name.starts_with("-"))
      bad("not an option's name", where, name, "an option of brdf fit without its dashes");
    Option option{name, {}};
    const Json list = value.is_array() ? value : Json::array({value});
    if (list.empty()) bad("an empty list", at, value, "at least one value");
    for (const Json& item : list) {
      Choice choice;
      if (item.is_array())
        for (const Json& part : item) addValue(name, part, at, choice);
      else
        addValue(name, item, at, choice);
      option.choices.push_back(std::move(choice));
    }
    options.push_back(std::move(option));
  }
  return options;
}

/// "--lobes=Lambertian + GGX" as a shell takes it.
std::string typed(const std::string& word) {
  const std::size_t value = word.find('=') + 1;
  if (word.find_first_of(" ()*+'#", value) == std::string::npos) return word;
  return word.substr(0, value) + "\"" + word.substr(value) + "\"";
}

std::unique_ptr<BatchTask> makeTask(const std::vector<Option>& options, const std::vector<std::size_t>& choice,
                                    const std::string& where) {
  auto task = std::make_unique<BatchTask>();
  std::vector<std::string> words;
  for (std::size_t k = 0; k < options.size(); ++k) {
    const Choice& chosen = options[k].choices[choice[k]];
    words.insert(words.end(), chosen.words.begin(), chosen.words.end());
    task->options.emplace_back(options[k].name, chosen.text);
  }
  for (const std::string& word : words) task->words += (task->words.empty() ? "" : " ") + typed(word);
  try {
    Arguments arguments("fit", "", "");
    task->fit.declare(arguments);
    if (!arguments.parse(words))
      throw Error(Error::Kind::Usage, {"not an option of a fit", "", "'help'", "what brdf fit --help lists"});
    task->fit.resolve();
  } catch (const Error& error) {
    Error::Details details = error.details();
    details.where = where + (details.where.empty() || details.where == "brdf fit" ? "" : ", " + details.where);
    throw Error(error.kind(), std::move(details));
  }
  return task;
}

std::string keyOf(const BatchTask& task, const BatchTarget& target) {
  std::map<std::string, std::string> sorted(task.options.begin(), task.options.end());
  for (auto& [name, value] : sorted) {  // a file that an option names, as in metric sphere:MAP
    std::error_code ignored;
    if (const std::string file = value.substr(value.find(':') + 1); fs::is_regular_file(file, ignored))
      value += " " + sha256(readFile(file));
  }
  const Json content = {{"format", 1},           {"program", BRDF_VERSION},
                        {"target", target.hash}, {"assume", assumptionItems()},
                        {"options", sorted},     {"models", task.fit.modelDefinitions()}};
  return sha256(content.dump(-1, ' ', false, Json::error_handler_t::replace)).substr(0, 16);
}

void addBlock(BatchJob& job, const Json& fits, const std::string& where, std::map<std::string, std::size_t>& known) {
  if (!fits.is_object()) bad("not a set of fits", where, fits, "an object whose keys are options of brdf fit");
  BatchBlock block;
  block.title = textOf(fits, "title", where, "");
  const std::vector<Option> options = readOptions(fits, where);
  double count = static_cast<double>(job.targets.size());
  for (const Option& option : options) {
    if (option.choices.size() > 1) block.varied.push_back(option.name);
    count *= static_cast<double>(option.choices.size());
  }
  if (count + static_cast<double>(job.tasks.size()) > kMostTasks)
    throw Error(Error::Kind::Format,
                {"too many fits", where, formatNumber(count), "at most " + std::to_string(kMostTasks) + " in all"});
  for (std::size_t target = 0; target < job.targets.size(); ++target) {
    std::vector<std::size_t> choice(options.size(), 0);
    for (bool more = true; more;) {
      auto task = makeTask(options, choice, where);
      task->target = target;
      task->key = keyOf(*task, job.targets[target]);
      const auto [entry, isNew] = known.emplace(task->key + " " + std::to_string(target), job.tasks.size());
      if (isNew) job.tasks.push_back(std::move(task));
      block.tasks.push_back(entry->second);
      more = false;
      for (std::size_t k = options.size(); k-- > 0 && !more;) {
        more = ++choice[k] < options[k].choices.size();
        if (!more) choice[k] = 0;
      }
    }
  }
  job.blocks.push_back(std::move(block));
}

}  // namespace

std::string BatchTask::title(const std::string& targetName) const {
  std::string text = targetName + ": " + fit.lobes() + ", " + fit.optimizer() + ", " + fit.metric();
  for (const auto& [name, value] : options)
    if (name != "lobes" && name != "optimizer" && name != "metric") text += ", " + name + " " + value;
  return text;
}

BatchJob parseBatchJob(const std::string& text, const fs::path& path,
                       const std::function<std::string(const std::string&)>& contentHash) {
  const Json json = parseJson(text, path.string());
  if (!json.is_object()) bad("not a job", path.string(), json, "an object with targets and fits");
  checkKeys(json, path.string(), {"title", "note", "targets", "fits"});
  for (const char* key : {"targets", "fits"})
    if (!json.contains(key))
      throw Error(Error::Kind::Format, {"missing key", path.string(), "no " + std::string(key), "targets and fits"});
  BatchJob job;
  job.title = textOf(json, "title", path.string(), path.stem().string());
  job.note = textOf(json, "note", path.string(), "");
  job.targets = readTargets(json["targets"], path, contentHash);
  std::map<std::string, std::size_t> known;
  const Json& fits = json["fits"];
  if (!fits.is_array()) {
    addBlock(job, fits, path.string() + ": fits", known);
  } else {
    if (fits.empty()) bad("no fits", path.string() + ": fits", fits, "at least one");
    for (std::size_t k = 0; k < fits.size(); ++k)
      addBlock(job, fits[k], path.string() + ": fits[" + std::to_string(k) + "]", known);
  }
  return job;
}

std::string targetContentHash(const std::string& material) {
  const LoadedMaterial loaded = loadTarget(material);
  const auto fileHash = [](const fs::path& path) { return sha256(readFile(path)); };
  std::string content;
  fs::path path = material;
  if (!fs::exists(path)) path = material.substr(0, material.rfind('#'));
  if (fs::is_directory(path)) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(path))
      if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    for (const fs::path& file : files) content += file.lexically_relative(path).string() + " " + fileHash(file) + "\n";
  } else if (fs::exists(path)) {
    content = fileHash(path) + material.substr(path.string().size());
  } else {  // an expression or a preset
    content = loaded.brdf->description();
    if (const auto* sum = dynamic_cast<const LobeSum*>(loaded.brdf.get()))
      for (const Lobe& lobe : sum->lobes()) content += "\n" + lobe.model->equation();
  }
  // A file may name another that holds the measurement (XML of BRDFLab 0.8.2).
  std::error_code ignored;
  const fs::path source = loaded.report.source;
  if (source != path && fs::is_regular_file(source, ignored)) content += " " + fileHash(source);
  return sha256(content);
}

std::string exampleBatchJob() {
  return R"({
  "title": "Two lobes, two optimizers",
  "targets": [{"name": "sample", "material": "sample.binary"}],
  "fits": {
    "lobes": ["Lambertian + GGX", "Lambertian + Ward"],
    "optimizer": ["lm", "bobyqa"],
    "metric": "rms",
    "channels": "luminance",
    "max-theta": 80
  }
}
)";
}

}  // namespace brdf::app
