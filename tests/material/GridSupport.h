#pragma once
#include <brdf/geometry/Directions.h>
#include <brdf/material/GridBrdf.h>

#include <functional>
#include <random>
#include <vector>

/// What the tests of grids share.
namespace gridtest {

using brdf::AxisQuantity;
using brdf::AxisScale;
using brdf::Direction;
using brdf::DirectionPair;
using brdf::GridAxis;
using brdf::GridBrdf;
using brdf::GridData;
using brdf::GridLayout;
using brdf::Parametrisation;
using brdf::radians;

/// Random pairs above the horizon, uniform in solid angle, polar angles up to `maximum` radians.
inline std::vector<DirectionPair> randomPairs(std::size_t count, double maximum = 1.5, unsigned seed = 3) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto direction = [&] {
    const double z = 1 - (1 - std::cos(maximum)) * uniform(random);
    return brdf::fromSpherical(std::acos(z), 2 * brdf::kPi * uniform(random));
  };
  std::vector<DirectionPair> pairs(count);
  for (DirectionPair& pair : pairs) pair = {direction(), direction()};
  return pairs;
}

inline brdf::DirectionPairBuffer<double> bufferOf(const std::vector<DirectionPair>& pairs) {
  brdf::DirectionPairBuffer<double> buffer(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) buffer.set(i, pairs[i].wi, pairs[i].wo);
  return buffer;
}

struct Values {
  std::vector<double> value;  ///< of the first channel
  std::vector<std::uint8_t> valid;
};
inline Values valuesOf(const brdf::Brdf& brdf, const std::vector<DirectionPair>& pairs) {
  Values result{std::vector<double>(pairs.size() * brdf.channels().count()), std::vector<std::uint8_t>(pairs.size())};
  brdf.evaluate(bufferOf(pairs).view(), result.value.data(), result.valid.data());
  result.value.resize(pairs.size());
  return result;
}

/// A one-channel grid whose cells hold `value(index along each axis)`.
inline std::shared_ptr<const GridBrdf> filled(const GridLayout& layout,
                                              const std::function<double(const std::vector<std::size_t>&)>& value,
                                              GridBrdf::Lookup lookup = GridBrdf::Lookup::Interpolated) {
  GridData data{layout, brdf::Channels::monochrome(), {}, {}};
  std::vector<std::size_t> index(layout.axes.size(), 0);
  for (std::size_t cell = 0; cell < layout.cells(); ++cell) {
    std::size_t rest = cell;
    for (std::size_t a = 0; a < index.size(); ++a) {
      index[a] = rest % layout.axes[a].size();
      rest /= layout.axes[a].size();
    }
    data.values.push_back(value(index));
  }
  return std::make_shared<const GridBrdf>(std::move(data), "test grid", lookup);
}

/// `v` turned about the unit vector `axis` by `angle`, right-handed (Rodrigues' formula).
inline Direction turned(const Direction& v, const Direction& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), along = (1 - c) * brdf::dot(v, axis);
  const Direction side = brdf::cross(axis, v);
  Direction result{};
  for (std::size_t k = 0; k < 3; ++k) result[k] = c * v[k] + s * side[k] + along * axis[k];
  return result;
}

inline double angleBetween(const Direction& a, const Direction& b) {
  const Direction normal = brdf::cross(a, b);
  return std::atan2(std::sqrt(brdf::dot(normal, normal)), brdf::dot(a, b));
}

/// `angle` as the same direction within [0, 2 pi).
inline double wrapped(double angle) { return angle - 2 * brdf::kPi * std::floor(angle / (2 * brdf::kPi)); }

}  // namespace gridtest
