#include <brdf/sampling/DirectionalAlbedo.h>
#include <brdf/sampling/Sequence.h>

#include <cmath>
#include <random>

namespace brdf {
namespace {

std::vector<double> albedoOnce(const Brdf& brdf, const Direction& light, std::size_t points, double u, double v) {
  std::vector<double> x(points), y(points);
  for (std::size_t i = 0; i < points; ++i) {
    const auto [first, second] = r2(i, u, v);
    x[i] = first;
    y[i] = second;
  }
  // The sampler draws lights for a viewer; here it draws viewers for the light, weighted by its own density.
  std::array<std::vector<double>, 3> fixed, drawn;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    fixed[axis].assign(points, light[axis]);
    drawn[axis].resize(points);
  }
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

}  // namespace

Albedo directionalAlbedo(const Brdf& brdf, double theta, std::size_t points) {
  constexpr std::size_t copies = 8;
  const std::size_t channels = brdf.channels().count();
  Albedo albedo{theta, std::vector<double>(channels), std::vector<double>(channels)};
  std::mt19937_64 random(1);
  // By hand: the standard leaves the numbers of its distributions to the implementation.
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<std::vector<double>> all;
  for (std::size_t k = 0; k < copies; ++k) {
    const double u = uniform(), v = uniform();
    all.push_back(albedoOnce(brdf, fromSpherical(theta, 0), points, u, v));
  }
  for (std::size_t c = 0; c < channels; ++c) {
    double mean = 0, squares = 0;
    for (const auto& one : all) mean += one[c] / copies;
    for (const auto& one : all) squares += (one[c] - mean) * (one[c] - mean);
    albedo.value[c] = mean;
    albedo.error[c] = std::sqrt(squares / (copies * (copies - 1)));
  }
  return albedo;
}

}  // namespace brdf
