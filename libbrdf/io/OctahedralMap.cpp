#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/io/OctahedralMap.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace brdf {
namespace {

/// Solid angle of the triangle of three directions of any length: A. Van Oosterom and J. Strackee, "The Solid Angle of
/// a Plane Triangle", IEEE Trans. Biomed. Eng. 30(2), 1983, equation (8).
double triangleSolidAngle(const Direction& a, const Direction& b, const Direction& c) {
  const double la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c));
  const double below = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la;
  return 2 * std::atan2(std::abs(dot(a, cross(b, c))), below);
}

/// Point of the octahedron over (x, z) in [-1, 1]^2.
Direction unfolded(double x, double z) {
  const double y = 1 - std::abs(x) - std::abs(z);
  if (y >= 0) return {x, y, z};
  return {std::copysign(1 - std::abs(z), x), y, std::copysign(1 - std::abs(x), z)};
}

/// See Footprints. `part`, [0, 1), decides how much of a step is left out when rounding down.
std::uint32_t packed(const float* colour, float unit, double part) {
  const float largest = std::max({colour[0], colour[1], colour[2], 0.0f});
  int exponent = 0;
  std::frexp(largest / (511 * unit), &exponent);
  std::uint32_t word = 0;
  for (exponent = std::clamp(exponent, -31, 0);; ++exponent) {
    word = static_cast<std::uint32_t>(exponent + 31) << 27;
    bool fits = true;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double steps =
          std::floor(std::ldexp(double{std::max(colour[channel], 0.0f)} / double{unit}, -exponent) + part);
      fits = fits && steps < 512;
      word |= static_cast<std::uint32_t>(std::min(steps, 511.0)) << (9 * channel);
    }
    if (fits || exponent == 0) return word;
  }
}

}  // namespace

OctahedralMap::OctahedralMap(std::size_t size, const std::vector<float>& texels) : size_(size) {
  if (!std::has_single_bit(size) || texels.size() != 3 * size * size)
    throw Error(Error::Kind::Value, {"size of an octahedral map", {}, std::to_string(size), "a power of two"});
  levels_ = static_cast<std::size_t>(std::bit_width(size));
  width_ = size + 2 + size / 2 + 2;
  height_ = size + 2 * std::max<std::size_t>(levels_ - 1, 1);
  picture_.resize(4 * width_ * height_);
  for (std::size_t row = 0; row < size; ++row)
    for (std::size_t column = 0; column < size; ++column) {
      float* out = texel(0, std::ptrdiff_t(column), std::ptrdiff_t(row));
      std::copy_n(texels.data() + 3 * (row * size + column), 3, out);
      out[3] = 1;
    }
  fillBorder(0);

  // A texel's solid angle is the sum of its children's, so that power is kept exactly.
  std::vector<double> angles(size * size);
  parallelFor(size, 32, [&](std::size_t first, std::size_t last) {
    for (std::size_t row = first; row < last; ++row)
      for (std::size_t column = 0; column < size; ++column) angles[row * size + column] = solidAngle(size, column, row);
  });
  for (std::size_t level = 1; level < levels_; ++level) {
    const std::size_t n = size >> level;
    std::vector<double> sums(n * n);
    for (std::size_t row = 0; row < n; ++row)
      for (std::size_t column = 0; column < n; ++column) {
        double sum[3] = {}, weight = 0;
        for (std::size_t child = 0; child < 4; ++child) {
          const std::size_t x = 2 * column + child % 2, y = 2 * row + child / 2;
          const double angle = angles[y * 2 * n + x];
          const float* from = texel(level - 1, std::ptrdiff_t(x), std::ptrdiff_t(y));
          for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += angle * double(from[channel]);
          weight += angle;
        }
        float* out = texel(level, std::ptrdiff_t(column), std::ptrdiff_t(row));
        for (std::size_t channel = 0; channel < 3; ++channel) out[channel] = static_cast<float>(sum[channel] / weight);
        out[3] = 1;
        sums[row * n + column] = weight;
      }
    angles = std::move(sums);
    fillBorder(level);
  }
}

float* OctahedralMap::texel(std::size_t level, std::ptrdiff_t column, std::ptrdiff_t row) {
  return const_cast<float*>(std::as_const(*this).texel(level, column, row));
}

const float* OctahedralMap::texel(std::size_t level, std::ptrdiff_t column, std::ptrdiff_t row) const {
  const std::size_t n = size_ >> level;
  const std::size_t left = level == 0 ? 0 : size_ + 2, top = level == 0 ? 0 : size_ - 2 * n + 2 * (level - 1);
  return picture_.data() + 4 * ((top + std::size_t(row + 1)) * width_ + left + std::size_t(column + 1));
}

void OctahedralMap::fillBorder(std::size_t level) {
  const auto n = std::ptrdiff_t(size_ >> level);
  // Over an edge the square goes on at the mirrored place of the same edge; its corners are all the nadir.
  for (std::ptrdiff_t i = 0; i < n; ++i)
    for (const std::ptrdiff_t side : {std::ptrdiff_t{0}, n - 1}) {
      const std::ptrdiff_t outside = side == 0 ? -1 : n;
      std::copy_n(texel(level, side, n - 1 - i), 4, texel(level, outside, i));
      std::copy_n(texel(level, n - 1 - i, side), 4, texel(level, i, outside));
    }
  for (const std::ptrdiff_t x : {std::ptrdiff_t{0}, n - 1})
    for (const std::ptrdiff_t y : {std::ptrdiff_t{0}, n - 1})
      std::copy_n(texel(level, n - 1 - x, n - 1 - y), 4, texel(level, x == 0 ? -1 : n, y == 0 ? -1 : n));
}

std::array<double, 3> OctahedralMap::radiance(const Direction& direction, std::size_t level) const {
  const auto [u, v] = project(direction);
  const double n = static_cast<double>(size_ >> level), x = u * n - 0.5, y = v * n - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  std::array<double, 3> sum{};
  for (int corner = 0; corner < 4; ++corner) {
    const double weight = (corner % 2 ? x - left : 1 - (x - left)) * (corner / 2 ? y - top : 1 - (y - top));
    const float* from = texel(level, std::ptrdiff_t(left) + corner % 2, std::ptrdiff_t(top) + corner / 2);
    for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += weight * double(from[channel]);
  }
  return sum;
}

std::array<double, 3> OctahedralMap::totalPower(std::size_t level) const {
  const std::size_t n = size_ >> level;
  std::array<double, 3> power{};
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column < n; ++column)
      for (std::size_t channel = 0; channel < 3; ++channel)
        power[channel] +=
            solidAngle(n, column, row) * double(texel(level, std::ptrdiff_t(column), std::ptrdiff_t(row))[channel]);
  return power;
}

Direction OctahedralMap::direction(double u, double v) { return normalized(unfolded(2 * u - 1, 2 * v - 1)); }

std::array<double, 2> OctahedralMap::project(const Direction& d) {
  const double scale = 1 / (std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]));
  double x = d[0] * scale, z = d[2] * scale;
  if (d[1] < 0) {
    const double folded = std::copysign(1 - std::abs(z), x);
    z = std::copysign(1 - std::abs(x), z);
    x = folded;
  }
  return {(x + 1) / 2, (z + 1) / 2};
}

double OctahedralMap::solidAngle(std::size_t n, std::size_t column, std::size_t row) {
  if (n == 1) return 4 * kPi;
  // Folds run along the axes, which texels do not cross, and the diagonals, along which each texel is cut in two: from
  // (+, +) and (-, -) quadrants' lower right to upper left corner, from the others' lower left to upper right.
  const double step = 2 / static_cast<double>(n);
  const double x = static_cast<double>(column) * step - 1, z = static_cast<double>(row) * step - 1;
  const Direction corners[4] = {unfolded(x, z), unfolded(x + step, z), unfolded(x + step, z + step),
                                unfolded(x, z + step)};
  const bool falling = (x < 0) == (z < 0);
  const std::size_t first = falling ? 1 : 0;
  const Direction &a = corners[first], &b = corners[first + 1], &c = corners[(first + 2) % 4],
                  &d = corners[(first + 3) % 4];
  return triangleSolidAngle(a, b, c) + triangleSolidAngle(a, c, d);
}

OctahedralMap::Footprints OctahedralMap::footprints() const {
  float largest = 0;
  for (std::size_t i = 0; i < picture_.size(); ++i)
    if (i % 4 < 3) largest = std::max(largest, picture_[i]);
  Footprints result;
  // A power of two, so that equal numbers stay equal and 1 stays 1.
  if (largest > 0) result.unit = std::exp2(std::ceil(std::log2(largest / 511)));
  const std::size_t rowLength = size_ + 1;
  result.words.resize(4 * rowLength * (2 * size_ - 1 + levels_));
  for (std::size_t level = 0; level < levels_; ++level) {
    const std::size_t n = size_ >> level, top = 2 * (size_ - n) + level;
    parallelFor(n + 1, 16, [&](std::size_t first, std::size_t last) {
      for (std::size_t row = first; row < last; ++row)
        for (std::size_t column = 0; column <= n; ++column)
          for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t x = column + k % 2, y = row + k / 2;  // with the border, from 0
            // Dithered by the R2 sequence (M. Roberts, 2018): the mean over a few texels is right to far below a step.
            const double part =
                0.7548776662466927 * static_cast<double>(x) + 0.5698402909980532 * static_cast<double>(top + y);
            result.words[4 * ((top + row) * rowLength + column) + k] = packed(
                texel(level, std::ptrdiff_t(x) - 1, std::ptrdiff_t(y) - 1), result.unit, part - std::floor(part));
          }
    });
  }
  return result;
}

}  // namespace brdf
