#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace brdf::app {

/// Runs this very program in `folder`. Empty when it succeeded, else what it wrote to standard error, or how it ended.
/// `log` takes its output, and is removed again.
std::string runThisProgram(const std::vector<std::string>& words, const std::filesystem::path& folder,
                           const std::filesystem::path& log);

}  // namespace brdf::app
