#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/io/CubeMap.h>

#include <bit>
#include <cmath>

namespace brdf {
namespace {

/// Solid angles of one face's texels, row by row (the faces are alike).
std::vector<double> faceSolidAngles(std::size_t size) {
  std::vector<double> angles(size * size);
  for (std::size_t row = 0; row < size; ++row)
    for (std::size_t column = 0; column < size; ++column)
      angles[row * size + column] = CubeMap::solidAngle(size, row, column);
  return angles;
}

CubeMap::Level halved(const CubeMap::Level& fine) {
  CubeMap::Level coarse(fine.size / 2);
  const std::vector<double> angles = faceSolidAngles(fine.size);
  parallelFor(6 * coarse.size, 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t line = first; line < last; ++line) {
      const std::size_t face = line / coarse.size, row = line % coarse.size;
      for (std::size_t column = 0; column < coarse.size; ++column) {
        double sum[3] = {}, weight = 0;
        for (std::size_t child = 0; child < 4; ++child) {
          const std::size_t y = 2 * row + child / 2, x = 2 * column + child % 2;
          const double angle = angles[y * fine.size + x];
          const float* texel = fine.texel(face, y, x);
          for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += angle * double(texel[channel]);
          weight += angle;
        }
        float* out = coarse.texel(face, row, column);
        for (std::size_t channel = 0; channel < 3; ++channel) out[channel] = static_cast<float>(sum[channel] / weight);
        out[3] = 1;
      }
    }
  });
  return coarse;
}

}  // namespace

CubeMap CubeMap::withMipLevels(Level finest) {
  if (!std::has_single_bit(finest.size))
    throw Error(Error::Kind::Value, {"size of a cube map with mip levels", {}, std::to_string(finest.size), "2^n"});
  CubeMap map = single(std::move(finest));
  while (map.levels_.back().size > 1) map.levels_.push_back(halved(map.levels_.back()));
  return map;
}

CubeMap CubeMap::single(Level level) {
  CubeMap map;
  map.levels_.push_back(std::move(level));
  return map;
}

Direction CubeMap::direction(std::size_t face, double s, double t) {
  const double a = 2 * s - 1, b = 2 * t - 1;
  switch (face) {
    case 0:
      return {1, -b, -a};
    case 1:
      return {-1, -b, a};
    case 2:
      return {a, 1, b};
    case 3:
      return {a, -1, -b};
    case 4:
      return {a, -b, 1};
    default:
      return {-a, -b, -1};
  }
}

double CubeMap::solidAngle(std::size_t size, std::size_t row, std::size_t column) {
  // Solid angle of the rectangle between (0, 0) and (x, y) on the plane z = 1.
  const auto corner = [](double x, double y) { return std::atan2(x * y, std::sqrt(x * x + y * y + 1)); };
  const double step = 2.0 / static_cast<double>(size);
  const double x0 = static_cast<double>(column) * step - 1, x1 = x0 + step;
  const double y0 = static_cast<double>(row) * step - 1, y1 = y0 + step;
  return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
}

std::vector<double> CubeMap::totalPower(std::size_t level) const {
  const Level& map = levels_.at(level);
  const std::vector<double> angles = faceSolidAngles(map.size);
  std::vector<double> power(3);
  for (std::size_t texel = 0; texel < 6 * angles.size(); ++texel)
    for (std::size_t channel = 0; channel < 3; ++channel)
      power[channel] += angles[texel % angles.size()] * double(map.texels[4 * texel + channel]);
  return power;
}

}  // namespace brdf
