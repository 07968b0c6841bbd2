#pragma once
#include "Job.h"
#include "Records.h"

#include <filesystem>
#include <string>

namespace brdf::app {

/// Writes what a batch found into `folder`, for people: report.md with one part for each part of the job, and beside it
/// table-N.csv and pictures: the errors and times of all fits; and for parts that compare up to five sums of lobes, the
/// lobes of each target with those of its fits, the error map of its best fit, and spheres under a lamp. `results` is
/// the folder of the batch. The job's note stands in the report, in every table and on the plots and spheres. Returns
/// why there are no pictures, in words; empty when there are. Throws Error::Kind::File.
std::string writeBatchReport(const BatchJob& job, const BatchRecords& records, const std::filesystem::path& results,
                             const std::filesystem::path& folder);

}  // namespace brdf::app
