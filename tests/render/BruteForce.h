#pragma once
// Environment light by a plain sum over all texels, independent of how the library reads and draws maps.
#include "RenderScene.h"

#include <algorithm>

namespace rendertest {

/// A map cut into `pieces` x `pieces` parts a texel: the direction of each, and its radiance, interpolated between the
/// centres of texels, times its solid angle.
class BruteForce {
 public:
  BruteForce(const brdf::EnvironmentMap& map, int pieces, double rotationDegrees = 0) {
    const int width = int(map.width()) * pieces, height = int(map.height()) * pieces;
    const double turn = rotationDegrees * brdf::kPi / 180;
    directions_.reserve(std::size_t(width) * std::size_t(height));
    for (int y = 0; y < height; ++y) {
      const double top = brdf::kPi * y / height, bottom = brdf::kPi * (y + 1) / height;
      const double theta = (top + bottom) / 2, angle = (std::cos(top) - std::cos(bottom)) * 2 * brdf::kPi / width;
      for (int x = 0; x < width; ++x) {
        // Column 0 begins at +z and columns run through -x, -z (the middle) and +x; rotation is counter-clockwise from
        // above, from +z to +x.
        const double phi = 2 * brdf::kPi * (x + 0.5) / width - turn;
        directions_.push_back({-std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)});
        const Rgb rgb = interpolated(map.picture(), (x + 0.5) / pieces - 0.5, (y + 0.5) / pieces - 0.5);
        light_.push_back({rgb[0] * angle, rgb[1] * angle, rgb[2] * angle});
      }
    }
  }

  /// Radiance that a pixel's point (Render::hit) reflects to the viewer.
  Rgb reflected(const brdf::Brdf& material, const auto& hit) const {
    brdf::DirectionPairBuffer<double> pairs;
    std::vector<std::size_t> lit;
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const Direction wi = hit.local(directions_[i]);
      if (wi[2] <= 0 || light_[i] == Rgb{}) continue;
      pairs.push(wi, hit.wo);
      lit.push_back(i);
    }
    const std::size_t channels = material.channels().count();
    std::vector<double> values(pairs.size() * channels);
    material.evaluateParallel(pairs.view(), values.data(), nullptr);
    Rgb sum{};
    for (std::size_t i = 0; i < lit.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += values[(channels == 1 ? 0 : c) * pairs.size() + i] * pairs.wi[2][i] * light_[lit[i]][c];
    return sum;
  }

 private:
  /// Bilinear at x, y in texels from the first centre; over a pole the row continues half way round.
  static Rgb interpolated(const brdf::Image& picture, double x, double y) {
    const int w = int(picture.width), h = int(picture.height);
    const int left = int(std::floor(x)), top = int(std::floor(y));
    Rgb rgb{};
    for (int row = top; row <= top + 1; ++row)
      for (int column = left; column <= left + 1; ++column) {
        const bool beyond = row < 0 || row >= h;
        const int at = (column + w + (beyond ? w / 2 : 0)) % w, line = std::min(std::max(row, 0), h - 1);
        const double share = (1 - std::abs(x - column)) * (1 - std::abs(y - row));
        for (std::size_t c = 0; c < 3; ++c)
          rgb[c] += share * double(picture.values[3 * (std::size_t(line) * std::size_t(w) + std::size_t(at)) + c]);
      }
    return rgb;
  }

  std::vector<Direction> directions_;
  std::vector<Rgb> light_;
};

/// A map of 32 x 16 texels, black but for one of radiance 1000 and an even sky of 0.1 above the horizon: hard for any
/// sampler that does not know where the light is.
inline brdf::EnvironmentMap sunMap() {
  brdf::Image picture(32, 16, 3);
  for (std::size_t y = 0; y < 8; ++y)
    for (std::size_t x = 0; x < 32; ++x) std::fill_n(picture.pixel(x, y), 3, 0.1f);
  const float sun[3] = {1000, 900, 700};
  std::copy_n(sun, 3, picture.pixel(20, 4));
  return brdf::EnvironmentMap(picture);
}

/// Smooth light of all directions: red grows to +x, green to +y, blue to +z.
inline brdf::EnvironmentMap smoothMap() {
  brdf::Image picture(32, 16, 3);
  const brdf::EnvironmentMap frame(picture);
  for (std::size_t y = 0; y < 16; ++y)
    for (std::size_t x = 0; x < 32; ++x)
      for (std::size_t axis = 0; axis < 3; ++axis)
        picture.pixel(x, y)[axis] = static_cast<float>(1.5 + frame.direction(x, y)[axis]);
  return brdf::EnvironmentMap(picture);
}

}  // namespace rendertest
