#include <brdf/base/Error.h>
#include <brdf/simulate/gpu/FieldTexels.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

constexpr std::size_t kMostCells = std::size_t{1} << 24;  ///< a quarter of a gigabyte of heights

}  // namespace

FieldTexels::FieldTexels(const HeightField& field, std::size_t mostCells, const std::string& where)
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
  if (columns > mostCells || rows > mostCells || columns > kMostCells / rows)
    throw Error(Error::Kind::Value, {"height field too large for the gpu backend", where,
                                     std::to_string(columns) + " x " + std::to_string(rows) + " nodes",
                                     "at most " + std::to_string(mostCells) +
                                         " along an axis and 2^24 in all; the cpu backend takes 2^26"});
  cellsPerUnit = {alongX ? 1.0 : 0.0, alongY ? unit / field.spacingY : 0.0};

  const auto [low, high] = std::ranges::minmax_element(field.heights);
  const double middle = (double(*low) + double(*high)) / 2, range = (double(*high) - double(*low)) / unit;
  const double gap = 1e-3 * range + 1e-4 * std::min(field.periodX(), field.periodY()) / unit;
  lowest = -range / 2 - gap;
  highest = range / 2 + gap;

  cells.resize(columns * rows);
  const auto z = [&](std::size_t i, std::size_t j) { return static_cast<float>((double(at(i, j)) - middle) / unit); };
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i)
      cells[j * columns + i] = {z(i, j), z(i + 1, j), z(i + 1, j + 1), z(i, j + 1)};

  std::size_t width = columns, height = rows;
  std::vector<std::array<float, 2>> below(cells.size());
  std::ranges::transform(cells, below.begin(), [](const std::array<float, 4>& h) {
    const auto [least, most] = std::ranges::minmax(h);
    return std::array<float, 2>{least, most};
  });
  boundsWidth = (columns + 1) / 2;
  while (width > 1 || height > 1) {
    const std::size_t wide = (width + 1) / 2, high2 = (height + 1) / 2;
    std::vector<std::array<float, 2>> level(
        wide * high2, {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()});
    for (std::size_t j = 0; j < height; ++j)
      for (std::size_t i = 0; i < width; ++i) {
        auto& to = level[j / 2 * wide + i / 2];
        to[0] = std::min(to[0], below[j * width + i][0]);
        to[1] = std::max(to[1], below[j * width + i][1]);
      }
    levelRows.push_back(boundsRows);
    bounds.resize((boundsRows + high2) * boundsWidth);
    for (std::size_t j = 0; j < high2; ++j)
      std::copy_n(level.begin() + static_cast<std::ptrdiff_t>(j * wide), wide,
                  bounds.begin() + static_cast<std::ptrdiff_t>((boundsRows + j) * boundsWidth));
    boundsRows += high2;
    below = std::move(level);
    width = wide;
    height = high2;
  }
  if (bounds.empty()) {
    bounds.resize(1);
    boundsRows = 1;
  }
}

}  // namespace brdf
