#include <brdf/base/Error.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

namespace brdf {
namespace {

std::string oneLine(const Error::Details& details) {
  std::string text;
  if (!details.where.empty()) text += details.where + ": ";
  text += details.what;
  if (!details.found.empty()) text += "; found " + details.found;
  if (!details.allowed.empty()) text += "; allowed: " + details.allowed;
  // One line and printable, whatever bytes a file or the user put into the parts.
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

}  // namespace

Error::Error(Kind kind, Details details)
    : std::runtime_error(oneLine(details)), kind_(kind), details_(std::move(details)) {}

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substitute = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j + 1] + 1, row[j] + 1, substitute});
    }
  }
  return row.back();
}

}  // namespace brdf
