#include <brdf/sampling/DirectionalAlbedo.h>
#include <brdf/sampling/Sequence.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace brdf {
namespace {

using Components = std::array<std::vector<double>, 3>;

/// The mean over the lights of the share of their light that is reflected, from one viewer each, which the numbers x
/// and y in [0, 1) draw.
std::vector<double> meanAlbedo(const Brdf& brdf, const Components& fixed, const std::vector<double>& x,
                               const std::vector<double>& y) {
  // The sampler draws lights for a viewer; here it draws viewers for the light, weighted by its own density.
  const std::size_t points = x.size();
  Components drawn;
  for (auto& component : drawn) component.resize(points);
  const std::size_t half = points / 2;
  brdf.sample({fixed[0].data(), fixed[1].data(), fixed[2].data()}, {x.data(), y.data()},
              {drawn[0].data(), drawn[1].data(), drawn[2].data()}, half);
  for (std::size_t i = half; i < points; ++i) {
    const Direction w = cosineDirection(x[i], y[i]);
    for (std::size_t axis = 0; axis < 3; ++axis) drawn[axis][i] = w[axis];
  }
  DirectionPairs<double> pairs, swapped;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    pairs.wi[axis] = swapped.wo[axis] = fixed[axis].data();
    pairs.wo[axis] = swapped.wi[axis] = drawn[axis].data();
  }
  pairs.count = swapped.count = points;
  const std::size_t channels = brdf.channels().count();
  std::vector<double> values(channels * points), density(points), sums(channels);
  brdf.evaluate(pairs, values.data(), nullptr);
  brdf.pdf(swapped, density.data());
  for (std::size_t i = 0; i < points; ++i) {
    const double cosine = drawn[2][i];
    if (!(cosine > 0)) continue;  // a failed draw
    const double weight = cosine / (0.5 * density[i] + 0.5 * cosine / kPi);
    for (std::size_t c = 0; c < channels; ++c) sums[c] += values[c * points + i] * weight;
  }
  for (double& sum : sums) sum /= static_cast<double>(points);
  return sums;
}

constexpr std::size_t kCopies = 8;

/// Mean and standard error of the mean over `once(u)` for shifts u, one number in [0, 1) for each of `Dimensions`.
template <std::size_t Dimensions, class Once>
Albedo meanOfShifts(std::size_t channels, const Once& once) {
  std::mt19937_64 random(1);
  std::vector<std::vector<double>> all;
  for (std::size_t k = 0; k < kCopies; ++k) {
    std::array<double, Dimensions> shift;
    // By hand: the standard leaves the numbers of its distributions to the implementation.
    for (double& number : shift) number = static_cast<double>(random() >> 11) * 0x1p-53;
    all.push_back(once(shift));
  }
  Albedo albedo{0, std::vector<double>(channels), std::vector<double>(channels)};
  for (std::size_t c = 0; c < channels; ++c) {
    double mean = 0, squares = 0;
    for (const auto& one : all) mean += one[c] / kCopies;
    for (const auto& one : all) squares += (one[c] - mean) * (one[c] - mean);
    albedo.value[c] = mean;
    albedo.error[c] = std::sqrt(squares / (kCopies * (kCopies - 1)));
  }
  return albedo;
}

}  // namespace

Albedo directionalAlbedo(const Brdf& brdf, double theta, std::size_t points, double phi) {
  const Direction light = fromSpherical(theta, phi);
  Components lights;
  for (std::size_t axis = 0; axis < 3; ++axis) lights[axis].assign(points, light[axis]);
  std::vector<double> x(points), y(points);
  Albedo albedo = meanOfShifts<2>(brdf.channels().count(), [&](const std::array<double, 2>& shift) {
    for (std::size_t i = 0; i < points; ++i) {
      const auto [first, second] = r2(i, shift[0], shift[1]);
      x[i] = first;
      y[i] = second;
    }
    return meanAlbedo(brdf, lights, x, y);
  });
  albedo.theta = theta;
  return albedo;
}

Albedo bihemisphericalAlbedo(const Brdf& brdf, std::size_t points) {
  Components lights;
  for (auto& component : lights) component.resize(points);
  std::vector<double> x(points), y(points);
  return meanOfShifts<4>(brdf.channels().count(), [&](const std::array<double, 4>& shift) {
    // The two halves of meanAlbedo each see all of the hemisphere: point i of one has the numbers of point i of the
    // other.
    for (std::size_t i = 0; i < points; ++i) {
      const auto numbers = r4(i % std::max<std::size_t>(points / 2, 1), shift);
      const Direction light = cosineDirection(numbers[0], numbers[1]);
      for (std::size_t axis = 0; axis < 3; ++axis) lights[axis][i] = light[axis];
      x[i] = numbers[2];
      y[i] = numbers[3];
    }
    return meanAlbedo(brdf, lights, x, y);
  });
}

}  // namespace brdf
