#pragma once
#include "Job.h"
#include "Records.h"

#include <filesystem>

namespace brdf::app {

/// How far a batch is.
struct BatchCounts {
  std::size_t fits = 0, fitted = 0, failed = 0;
  std::size_t open() const { return fits - fitted - failed; }
};
BatchCounts countBatch(const BatchJob& job, const BatchRecords& records);

/// One row a task, in the job's order; numbers with 17 digits. An open or failed task has no numbers.
std::string batchCsv(const BatchJob& job, const BatchRecords& records);

/// The whole as JSON: counts, and for each task its options with the report of its fit or the reason of its failure.
nlohmann::ordered_json batchJson(const BatchJob& job, const BatchRecords& records);

/// Writes results.csv and results.vtkhdf into the folder, each replaced when it is complete. In the container an entry
/// is one fit, in the job's order, called TARGET-KEY; without any fit there is no container.
void writeResults(const BatchJob& job, const BatchRecords& records, const std::filesystem::path& folder);

/// Removes what a process that was killed while it wrote results left half-written.
void removeUnfinishedResults(const std::filesystem::path& folder);

}  // namespace brdf::app
