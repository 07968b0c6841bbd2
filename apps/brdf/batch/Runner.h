#pragma once
#include "Job.h"
#include "Output.h"
#include "Ranks.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace brdf::app {

/// Does the tasks of `job` whose indices `open` lists, each on the rank that asks for it first. A finished fit, or the
/// reason of one that failed, is in a journal of `folder`, on the disk, before it is told of: on rank 0 `told(index,
/// words)` is called, from the thread that calls runTasks. Stops early when interrupted(); what is then under way is
/// dropped. `ranks` is null for a process alone; other ranks than 0 call it with the same job and need no `open`.
/// Throws Error::Kind::File when a journal cannot be kept.
void runTasks(const BatchJob& job, const std::vector<std::size_t>& open, const std::filesystem::path& folder,
              Ranks* ranks, const std::function<void(std::size_t task, const std::string& words)>& told,
              const std::function<void()>& idle);

}  // namespace brdf::app
