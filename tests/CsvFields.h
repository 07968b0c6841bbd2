#pragma once
// For tests that read the reference tables.
#include <string>
#include <string_view>
#include <vector>

/// The fields of a CSV line; a quoted field may hold commas.
inline std::vector<std::string> csvFields(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}
