#include "Output.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

void writeStandardOutput(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw Error(Error::Kind::File, {"cannot be written", "standard output", std::strerror(errno), ""});
}

}  // namespace

void Output::line(std::string_view text) const {
  if (textWanted()) writeStandardOutput(std::string(text) + "\n");
}

void Output::report(const nlohmann::ordered_json& json) const {
  if (jsonTarget.empty()) return;
  const std::string text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  if (jsonTarget == "-")
    writeStandardOutput(text);
  else
    writeFile(jsonTarget, text);
}

std::string TextTable::text() const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_)
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (column == widths.size()) widths.push_back(0);
      widths[column] = std::max(widths[column], row[column].size());
    }
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (column > 0) line += "  ";
      line += row[column];
      if (column + 1 < row.size()) line.append(widths[column] - row[column].size(), ' ');
    }
    if (!text.empty()) text += "\n";
    text += line;
  }
  return text;
}

std::string number(double value) { return formatNumber(value, 6); }

void checkWritable(const std::string& path) {
  if (!path.empty() && path != "-" && path != "/dev/null" && path != "/dev/stdout") AtomicFile probe(path);
}

}  // namespace brdf::app
