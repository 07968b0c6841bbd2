#pragma once
#include <brdf/base/TextTable.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace brdf::app {

/// Where a command's answers go. Text for people goes to standard output unless --quiet or `--json -` was given; the
/// report goes where --json says. Standard error is for the one line of an error (and a progress bar on a terminal).
class Output {
 public:
  std::string jsonTarget;  ///< empty: none; "-": standard output; else a file, replaced when complete
  bool quiet = false;

  bool textWanted() const { return !quiet && jsonTarget != "-"; }
  /// Writes `text` and a line end to standard output if text is wanted.
  void line(std::string_view text) const;
  /// Writes the report as JSON if asked for.
  void report(const nlohmann::ordered_json& json) const;
};

using brdf::TextTable;

/// `value` with six significant digits, for people.
std::string number(double value);

/// Throws Error::Kind::File when `path` (if not empty) could not be written, before any work is spent.
void checkWritable(const std::string& path);

}  // namespace brdf::app
