#pragma once
#include <brdf/brdf_export.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// The number that `text` holds, whole and independent of the locale: decimal or scientific, an optional leading '+',
/// "nan" and "inf" accepted. Empty when anything else is left over.
BRDF_EXPORT std::optional<double> parseNumber(std::string_view text);

/// The shortest decimal text that reads back as exactly `value`.
BRDF_EXPORT std::string formatNumber(double value);

/// `value` with `digits` significant digits (17 read back exactly).
BRDF_EXPORT std::string formatNumber(double value, int digits);

/// `text` without blanks (space, tab, CR, LF) at either end.
BRDF_EXPORT std::string_view trimmed(std::string_view text);

/// The pieces of `text` between separators, trimmed; "a,,b" has an empty piece.
BRDF_EXPORT std::vector<std::string_view> split(std::string_view text, char separator);

/// The names joined by ", ", for lists of allowed values in errors.
template <class Range>
std::string joined(const Range& names, std::string_view separator = ", ") {
  std::string text;
  for (const auto& name : names) {
    if (!text.empty()) text += separator;
    text += name;
  }
  return text;
}

}  // namespace brdf
