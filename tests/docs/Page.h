#pragma once
// Reading of the documentation's Markdown.
#include <brdf/base/File.h>
#include <brdf/base/Text.h>

#include <filesystem>
#include <string>
#include <vector>

namespace brdf {

inline std::filesystem::path docs() { return std::filesystem::path(BRDF_SOURCE_DIR) / "docs"; }

/// The cells of every table row of a page's section ("" for the whole page), rules and headers included.
inline std::vector<std::vector<std::string>> tableRows(const std::string& page, const std::string& section) {
  std::vector<std::vector<std::string>> rows;
  bool inside = section.empty();
  for (const std::string_view line : split(page, '\n')) {
    if (line.starts_with("#") && !section.empty())
      inside = trimmed(line.substr(line.find_first_not_of('#'))) == section;
    if (!inside || !line.starts_with("| ")) continue;
    std::vector<std::string> cells(1);
    for (std::size_t k = 1; k + 1 < line.size(); ++k) {
      if (line[k] == '\\' && line[k + 1] == '|')
        cells.back() += line[++k];
      else if (line[k] == '|')
        cells.emplace_back();
      else
        cells.back() += line[k];
    }
    for (std::string& cell : cells) cell = std::string(trimmed(cell));
    rows.push_back(std::move(cells));
  }
  return rows;
}

/// What stands between backticks in a cell.
inline std::vector<std::string> codeIn(const std::string& cell) {
  std::vector<std::string> pieces;
  for (std::size_t start = cell.find('`'); start != std::string::npos;) {
    const std::size_t end = cell.find('`', start + 1);
    if (end == std::string::npos) break;
    pieces.push_back(cell.substr(start + 1, end - start - 1));
    start = cell.find('`', end + 1);
  }
  return pieces;
}

/// The fenced blocks of a language.
inline std::vector<std::string> blocks(const std::string& page, const std::string& language) {
  std::vector<std::string> result;
  const std::string fence = "```" + language + "\n";
  for (std::size_t start = page.find(fence); start != std::string::npos; start = page.find(fence, start)) {
    start += fence.size();
    const std::size_t end = page.find("\n```", start);
    result.push_back(page.substr(start, end - start));
    start = end;
  }
  return result;
}

}  // namespace brdf
