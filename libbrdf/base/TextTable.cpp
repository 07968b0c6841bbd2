#include <brdf/base/TextTable.h>

#include <algorithm>

namespace brdf {
namespace {

/// Letters, not bytes: what continues a letter in UTF-8 begins with the bits 10.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

std::string TextTable::text() const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_)
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (column == widths.size()) widths.push_back(0);
      widths[column] = std::max(widths[column], width(row[column]));
    }
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (column > 0) line += "  ";
      line += row[column];
      if (column + 1 < row.size()) line.append(widths[column] - width(row[column]), ' ');
    }
    if (!text.empty()) text += "\n";
    text += line;
  }
  return text;
}

}  // namespace brdf
