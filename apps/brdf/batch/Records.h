#pragma once
#include "Job.h"

#include <brdf/base/Journal.h>
#include <brdf/fit/Fit.h>
#include <brdf/io/Container.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace brdf::app {

/// What the journals of a batch hold: one record a finished fit, JSON on one line, with the keys
///   key, target, words    the task
///   report                as `brdf fit --json` writes it, and
///   entry                 a container with the fit as its only entry, base64; or
///   failed                why there is none
/// Journals lie in the batch's folder: journal-0.jsonl and so on.

std::string fittedRecord(const BatchTask& task, const BatchTarget& target, const FitReport& report,
                         Provenance provenance);
std::string failedRecord(const BatchTask& task, const BatchTarget& target, const std::string& reason);

/// The newest state of every task that the journals know.
class BatchRecords {
 public:
  /// Reads all journals of the folder; a missing folder has none. Throws Error::Kind::File.
  explicit BatchRecords(const std::filesystem::path& folder);

  enum class State { Open, Fitted, Failed };
  State state(const std::string& key) const;
  /// The record without its entry; null for an open task.
  const nlohmann::ordered_json& record(const std::string& key) const;
  /// The stored fit. Throws Error::Kind::Format when the record is damaged.
  Container container(const std::string& key) const;

  std::size_t damagedLines() const { return damaged_; }
  std::size_t size() const { return records_.size(); }

 private:
  struct Kept {
    nlohmann::ordered_json record;
    std::string entry;  ///< base64
  };
  std::map<std::string, Kept> records_;
  std::size_t damaged_ = 0;
};

/// A journal of its own for this process: the first that no other process writes. `first` and `step` keep the ranks of
/// one batch apart. Throws Error::Kind::File.
Journal openJournal(const std::filesystem::path& folder, std::size_t first, std::size_t step);

}  // namespace brdf::app
