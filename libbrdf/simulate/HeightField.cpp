#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/HeightField.h>

#include <algorithm>
#include <cmath>

namespace brdf {

void HeightField::check(const std::string& where) const {
  constexpr std::size_t most = std::size_t{1} << 28;
  const auto fail = [&](std::string what, std::string found, std::string allowed) {
    throw Error(Error::Kind::Value, {std::move(what), where, std::move(found), std::move(allowed)});
  };
  if (columns < 2 || rows < 2 || columns > most / rows)
    fail("size of a height field", std::to_string(columns) + " x " + std::to_string(rows),
         "at least 2 nodes along each axis, at most 2^28 in all");
  for (const double spacing : {spacingX, spacingY})
    if (!(spacing > 0 && std::isfinite(spacing)))
      fail("spacing of a height field", formatNumber(spacing), "a positive number of micrometres");
  if (heights.size() != columns * rows)
    fail("number of heights", std::to_string(heights.size()), std::to_string(columns * rows));
  const auto bad = std::find_if(heights.begin(), heights.end(), [](float h) { return !std::isfinite(h); });
  if (bad != heights.end()) {
    const auto at = static_cast<std::size_t>(bad - heights.begin());
    fail("height of node (" + std::to_string(at % columns) + ", " + std::to_string(at / columns) + ")",
         formatNumber(*bad), "a finite number of micrometres");
  }
}

}  // namespace brdf
