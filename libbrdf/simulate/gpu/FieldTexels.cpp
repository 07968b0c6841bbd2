#include <brdf/base/Error.h>
#include <brdf/simulate/gpu/FieldTexels.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

constexpr std::size_t kMostCells = std::size_t{1} << 24;  ///< a quarter of a gigabyte of heights

}  // namespace

FieldTexels::FieldTexels(const HeightField& field, std::size_t mostTexels, const std::string& where)
    : unit(field.spacingX) {
  const auto at = [&](std::size_t i, std::size_t j) { return field.height(i % field.columns, j % field.rows); };
  bool alongX = false, alongY = false;  // whether heights change
  for (std::size_t j = 0; j < field.rows; ++j)
    for (std::size_t i = 0; i < field.columns; ++i) {
      alongX = alongX || at(i, j) != at(i + 1, j);
      alongY = alongY || at(i, j) != at(i, j + 1);
    }
  columns = alongX ? field.columns : 1;
  rows = alongY ? field.rows : 1;
  std::size_t texelRows = rows;
  for (std::size_t w = columns, h = rows; w > 1 || h > 1;) {
    w = (w + 1) / 2;
    h = (h + 1) / 2;
    levelRows.push_back(texelRows);
    texelRows += h;
  }
  if (columns > mostTexels || texelRows > mostTexels || columns > kMostCells / rows)
    throw Error(Error::Kind::Value,
                {"height field too large for the gpu backend", where,
                 std::to_string(columns) + " x " + std::to_string(rows) + " nodes",
                 "at most " + std::to_string(mostTexels) + " columns, about " + std::to_string(mostTexels / 2) +
                     " rows and 2^24 in all; the cpu backend takes 2^26"});
  cellsPerUnit = {alongX ? 1.0 : 0.0, alongY ? unit / field.spacingY : 0.0};

  const auto [low, high] = std::ranges::minmax_element(field.heights);
  const double middle = (double(*low) + double(*high)) / 2, range = (double(*high) - double(*low)) / unit;
  const double gap = 1e-3 * range + 1e-4 * std::min(field.periodX(), field.periodY()) / unit;
  lowest = -range / 2 - gap;
  highest = range / 2 + gap;

  texels.resize(columns * texelRows);
  const auto z = [&](std::size_t i, std::size_t j) { return static_cast<float>((double(at(i, j)) - middle) / unit); };
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i)
      texels[j * columns + i] = {z(i, j), z(i + 1, j), z(i + 1, j + 1), z(i, j + 1)};

  std::size_t width = columns, height = rows;
  for (std::size_t level = 1; level < levelRows.size(); ++level) {
    constexpr float none = std::numeric_limits<float>::infinity();
    const std::size_t wide = (width + 1) / 2, high2 = (height + 1) / 2;
    const auto* below = texels.data() + levelRows[level - 1] * columns;
    auto* squares = texels.data() + levelRows[level] * columns;
    for (std::size_t j = 0; j < high2; ++j)
      std::fill_n(squares + j * columns, wide, std::array<float, 4>{none, -none, 0, 0});
    for (std::size_t j = 0; j < height; ++j)
      for (std::size_t i = 0; i < width; ++i) {
        const auto& from = below[j * columns + i];
        const auto [least, most] =
            level == 1 ? std::ranges::minmax(from) : std::ranges::minmax_result<float>{from[0], from[1]};
        auto& to = squares[j / 2 * columns + i / 2];
        to[0] = std::min(to[0], least);
        to[1] = std::max(to[1], most);
      }
    width = wide;
    height = high2;
  }
}

}  // namespace brdf
