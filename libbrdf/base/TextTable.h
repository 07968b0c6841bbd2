#pragma once
#include <brdf/brdf_export.h>

#include <string>
#include <vector>

namespace brdf {

/// A table of UTF-8 text whose columns are as wide as their widest cell.
class BRDF_EXPORT TextTable {
 public:
  TextTable() = default;
  explicit TextTable(std::vector<std::string> header) { row(std::move(header)); }
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace brdf
