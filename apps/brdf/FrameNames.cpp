#include "FrameNames.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <optional>

namespace brdf::app {
namespace {

struct Place {
  std::size_t begin, end, digits;
};

/// Where the number goes; empty for anything but one %d or %0Nd with N from 1 to 9.
std::optional<Place> numberPlace(const std::string& pattern) {
  const std::size_t begin = pattern.find('%');
  if (begin == std::string::npos || pattern.find('%', begin + 1) != std::string::npos) return {};
  if (pattern.compare(begin, 2, "%d") == 0) return Place{begin, begin + 2, 1};
  const bool padded = begin + 3 < pattern.size() && pattern[begin + 1] == '0' && pattern[begin + 2] >= '1' &&
                      pattern[begin + 2] <= '9' && pattern[begin + 3] == 'd';
  if (!padded) return {};
  return Place{begin, begin + 4, static_cast<std::size_t>(pattern[begin + 2] - '0')};
}

}  // namespace

void checkFrameNames(const std::string& pattern) {
  if (!numberPlace(pattern))
    throw Error(Error::Kind::Usage, {"no place for the frame's number", "--out", "'" + pattern + "'",
                                     "one %d or %0Nd, say frame_%03d.png"});
}

std::string frameName(const std::string& pattern, std::size_t frame) {
  const auto place = numberPlace(pattern);
  if (!place) return pattern;
  std::string digits = std::to_string(frame);
  digits.insert(0, place->digits - std::min(place->digits, digits.size()), '0');
  return pattern.substr(0, place->begin) + digits + pattern.substr(place->end);
}

}  // namespace brdf::app
