#include "Results.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/fit/StoredFit.h>
#include <brdf/material/LobeSum.h>

#include <algorithm>
#include <set>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;
using State = BatchRecords::State;

const char* stateName(State state) {
  return state == State::Fitted ? "fitted" : state == State::Failed ? "failed" : "open";
}

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string jsonCell(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_number_float()) return formatNumber(value.get<double>(), 17);
  return cell(value.is_string() ? value.get<std::string>() : value.dump());
}

/// Options of the job that have no column of their own, in order of first appearance.
std::vector<std::string> otherOptions(const BatchJob& job) {
  std::vector<std::string> names;
  for (const auto& task : job.tasks)
    for (const auto& [name, value] : task->options)
      if (name != "lobes" && name != "optimizer" && name != "metric" && std::ranges::find(names, name) == names.end())
        names.push_back(name);
  return names;
}

std::string entryName(const BatchTarget& target, const BatchTask& task) {
  std::string name = target.name.substr(0, 150);
  std::ranges::replace(name, '#', '_');
  return name + "-" + task.key;
}

}  // namespace

BatchCounts countBatch(const BatchJob& job, const BatchRecords& records) {
  BatchCounts counts;
  counts.fits = job.tasks.size();
  for (const auto& task : job.tasks) {
    counts.fitted += records.state(task->key) == State::Fitted;
    counts.failed += records.state(task->key) == State::Failed;
  }
  return counts;
}

std::string batchCsv(const BatchJob& job, const BatchRecords& records) {
  const std::vector<std::string> others = otherOptions(job);
  std::set<std::string> metrics;
  for (const auto& task : job.tasks)
    if (records.state(task->key) == State::Fitted)
      for (const auto& [name, value] : records.record(task->key)["report"]["metrics"].items()) metrics.insert(name);
  static const char* const numbers[] = {"error",    "seconds",   "evaluations", "iterations", "samples",
                                        "channels", "converged", "termination", "strategy",   "material"};
  std::string text = "entry,key,target,lobes,optimizer,metric";
  for (const std::string& name : others) text += "," + cell(name);
  text += ",state";
  for (const char* name : numbers) text += std::string(",") + name;
  for (const std::string& name : metrics) text += ",error_" + name + ",zero_" + name;
  text += ",reason\n";
  std::size_t entry = 0;
  for (const auto& task : job.tasks) {
    const State state = records.state(task->key);
    text += (state == State::Fitted ? std::to_string(entry++) : "") + "," + task->key + "," +
            cell(job.targets[task->target].name) + "," + cell(task->fit.lobes()) + "," + cell(task->fit.optimizer()) +
            "," + cell(task->fit.metric());
    for (const std::string& name : others) {
      const auto found = std::ranges::find(task->options, name, &std::pair<std::string, std::string>::first);
      text += "," + (found == task->options.end() ? "" : cell(found->second));
    }
    text += std::string(",") + stateName(state);
    const Json& record = records.record(task->key);
    const Json report = state == State::Fitted ? record["report"] : Json::object();
    const auto add = [&text](const Json& value) { text += "," + jsonCell(value); };
    for (const char* name : numbers) add(report.value(name, Json()));
    for (const std::string& name : metrics)
      for (const char* group : {"metrics", "zero_model"}) add(report.value(group, Json::object()).value(name, Json()));
    add(state == State::Failed ? record["failed"] : Json());
    text += "\n";
  }
  return text;
}

Json batchJson(const BatchJob& job, const BatchRecords& records) {
  const BatchCounts counts = countBatch(job, records);
  Json results = Json::array();
  for (const auto& task : job.tasks) {
    Json result = {{"key", task->key}, {"target", job.targets[task->target].name}, {"options", Json::object()}};
    for (const auto& [name, value] : task->options) result["options"][name] = value;
    const State state = records.state(task->key);
    result["state"] = stateName(state);
    if (state == State::Fitted) result["report"] = records.record(task->key)["report"];
    if (state == State::Failed) result["failed"] = records.record(task->key)["failed"];
    results.push_back(std::move(result));
  }
  return {{"title", job.title},      {"note", job.note},      {"fits", counts.fits},          {"fitted", counts.fitted},
          {"failed", counts.failed}, {"open", counts.open()}, {"results", std::move(results)}};
}

void writeResults(const BatchJob& job, const BatchRecords& records, const std::filesystem::path& folder) {
  ContainerWriter writer(folder / "results.vtkhdf");
  std::size_t entries = 0;
  for (const auto& task : job.tasks) {
    if (records.state(task->key) != State::Fitted) continue;
    const Container stored = records.container(task->key);
    const FitReport report = loadFit(stored, 0);
    storeFit(writer.add(entryName(job.targets[task->target], *task), *report.material, stored.provenance(0)), report);
    ++entries;
  }
  if (entries > 0) writer.commit();
  writeFile(folder / "results.csv", batchCsv(job, records));
}

void removeUnfinishedResults(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> unfinished;
  for (const auto& file : std::filesystem::directory_iterator(folder))
    if (file.path().filename().string().starts_with(".results.part")) unfinished.push_back(file.path());
  std::error_code ignored;
  for (const auto& file : unfinished) std::filesystem::remove(file, ignored);
}

}  // namespace brdf::app
