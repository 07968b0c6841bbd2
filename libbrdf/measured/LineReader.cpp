#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/measured/LineReader.h>
#include <brdf/measured/ScatteredText.h>

#include <algorithm>
#include <cmath>

namespace brdf {

LineReader::LineReader(std::string_view text, std::filesystem::path path)
    : text_(withoutByteOrderMark(text)), path_(std::move(path)) {}

bool LineReader::next(std::string_view& line) {
  while (!text_.empty()) {
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    line = trimmed(text_.substr(0, end));
    text_.remove_prefix(std::min(end + 1, text_.size()));
    ++line_;
    if (!line.empty()) return true;
  }
  return false;
}

std::string_view LineReader::bytes(std::size_t count, const char* what) {
  if (count > text_.size())
    fail(std::string("the file is too short for ") + what, std::to_string(text_.size()) + " bytes follow",
         std::to_string(count));
  const std::string_view result = text_.substr(0, count);
  line_ += static_cast<std::size_t>(std::count(result.begin(), result.end(), '\n'));
  text_.remove_prefix(count);
  return result;
}

double LineReader::number(std::string_view text, const char* what) const {
  const auto value = parseNumber(text);
  if (!value)
    fail(std::string("no number where ") + what + " should be", "\"" + std::string(text.substr(0, 40)) + "\"", {});
  return *value;
}

std::size_t LineReader::count(std::string_view text, const char* what, std::size_t low, std::size_t high) const {
  const double value = number(text, what);
  if (!(value >= static_cast<double>(low) && value <= static_cast<double>(high) && value == std::floor(value)))
    fail(std::string("wrong value of ") + what, formatNumber(value),
         "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  return static_cast<std::size_t>(value);
}

void LineReader::fail(std::string what, std::string found, std::string allowed) const {
  throw Error(Error::Kind::Format, {std::move(what), path_.string() + ", line " + std::to_string(line_),
                                    std::move(found), std::move(allowed)});
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  while (!(line = trimmed(line)).empty()) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    result.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return result;
}

}  // namespace brdf
