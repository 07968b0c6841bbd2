#include "Records.h"

#include "commands/FitReportJson.h"

#include <brdf/base/Base64.h>
#include <brdf/base/Error.h>
#include <brdf/fit/StoredFit.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostJournals = 100000;

Json recordOf(const BatchTask& task, const BatchTarget& target) {
  return {{"key", task.key}, {"target", target.name}, {"words", task.words}};
}

std::string lineOf(const Json& record) { return record.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

std::string fittedRecord(const BatchTask& task, const BatchTarget& target, const FitReport& report,
                         Provenance provenance) {
  provenance.options = "fit " + task.words;
  provenance.date = makeProvenance({}).date;
  ContainerWriter writer("batch");
  storeFit(writer.add("fit", *report.material, provenance), report);
  Json record = recordOf(task, target);
  record["report"] = fitReportJson(report);
  record["entry"] = toBase64(writer.finish());
  return lineOf(record);
}

std::string failedRecord(const BatchTask& task, const BatchTarget& target, const std::string& reason) {
  Json record = recordOf(task, target);
  record["failed"] = reason;
  return lineOf(record);
}

BatchRecords::BatchRecords(const fs::path& folder) {
  std::vector<fs::path> journals;
  if (!fs::exists(folder)) return;
  for (const auto& file : fs::directory_iterator(folder)) {
    const std::string name = file.path().filename().string();
    if (name.starts_with("journal-") && name.ends_with(".jsonl")) journals.push_back(file.path());
  }
  std::ranges::sort(journals);
  for (const fs::path& journal : journals)
    damaged_ += Journal::read(journal, [this](std::string_view line) {
      Json record = Json::parse(line, nullptr, false);
      if (!record.is_object() || !record.contains("key") || !record["key"].is_string() ||
          !(record.contains("failed") || (record.contains("report") && record.contains("entry")))) {
        ++damaged_;
        return;
      }
      Kept kept;
      if (record.contains("entry") && record["entry"].is_string()) kept.entry = record["entry"].get<std::string>();
      record.erase("entry");
      kept.record = std::move(record);
      const std::string key = kept.record["key"].get<std::string>();
      // A fit that was tried again and then succeeded is one that succeeded.
      if (const auto present = records_.find(key);
          present == records_.end() || (present->second.entry.empty() && !kept.entry.empty()))
        records_[key] = std::move(kept);
    });
}

BatchRecords::State BatchRecords::state(const std::string& key) const {
  const auto found = records_.find(key);
  if (found == records_.end()) return State::Open;
  return found->second.entry.empty() ? State::Failed : State::Fitted;
}

const Json& BatchRecords::record(const std::string& key) const {
  static const Json none;
  const auto found = records_.find(key);
  return found == records_.end() ? none : found->second.record;
}

Container BatchRecords::container(const std::string& key) const {
  const auto bytes = fromBase64(records_.at(key).entry);
  if (!bytes)
    throw Error(Error::Kind::Format, {"damaged record", "journal, key " + key, "an entry that is no base64", ""});
  return Container::fromBytes(*bytes, "journal, key " + key);
}

Journal openJournal(const fs::path& folder, std::size_t first, std::size_t step) {
  for (std::size_t number = first; number < kMostJournals; number += step)
    if (auto journal = Journal::tryOpen(folder / ("journal-" + std::to_string(number) + ".jsonl")))
      return std::move(*journal);
  throw Error(Error::Kind::File, {"no journal is free", folder.string(), "", "at most 100000 at a time"});
}

}  // namespace brdf::app
