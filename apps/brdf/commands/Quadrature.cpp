#include "Quadrature.h"

#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace brdf::app {
namespace {

Direction cosineDirection(double u, double v) {
  const double r = std::sqrt(u), phi = 2 * kPi * v;
  return {r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u)};
}

/// The R2 sequence (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences") shifted by (u, v).
void shiftedR2(std::size_t count, double u, double v, std::vector<double>& x, std::vector<double>& y) {
  constexpr double plastic = 1.32471795724474602596;
  x.resize(count);
  y.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    double whole;
    x[i] = std::modf(u + static_cast<double>(i + 1) / plastic, &whole);
    y[i] = std::modf(v + static_cast<double>(i + 1) / (plastic * plastic), &whole);
  }
}

std::vector<double> albedoOnce(const Brdf& brdf, const Direction& light, std::size_t points, double u, double v) {
  std::vector<double> x, y;
  shiftedR2(points, u, v, x, y);
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
  std::uniform_real_distribution<double> uniform;
  std::vector<std::vector<double>> all;
  for (std::size_t k = 0; k < copies; ++k) {
    const double u = uniform(random), v = uniform(random);
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

Violations reciprocityViolations(const Brdf& brdf, std::size_t count, double tolerance) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform;
  DirectionPairBuffer<double> pairs(count), swapped(count);
  for (std::size_t i = 0; i < count; ++i) {
    double u[4];
    for (double& number : u) number = uniform(random);
    const Direction wi = cosineDirection(u[0], u[1]), wo = cosineDirection(u[2], u[3]);
    pairs.set(i, wi, wo);
    swapped.set(i, wo, wi);
  }
  const std::size_t channels = brdf.channels().count();
  std::vector<double> there(channels * count), back(channels * count);
  std::vector<std::uint8_t> thereValid(count), backValid(count);
  brdf.evaluateParallel(pairs.view(), there.data(), thereValid.data());
  brdf.evaluateParallel(swapped.view(), back.data(), backValid.data());
  Violations result;
  std::vector<double> differences;
  for (std::size_t i = 0; i < count; ++i) {
    if (!thereValid[i] || !backValid[i]) continue;
    double worst = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      const double a = there[c * count + i], b = back[c * count + i];
      if (a != b) worst = std::max(worst, std::abs(a - b) / std::max(std::abs(a), std::abs(b)));
    }
    differences.push_back(worst);
  }
  std::sort(differences.begin(), differences.end());
  result.tested = differences.size();
  if (differences.empty()) return result;
  result.count =
      static_cast<std::size_t>(differences.end() - std::upper_bound(differences.begin(), differences.end(), tolerance));
  result.median = differences[differences.size() / 2];
  result.worst = differences.back();
  return result;
}

Violations energyViolations(const Brdf& brdf, std::size_t points) {
  Violations result;
  for (int angle = 0; angle < 90; angle += 5) {
    const Albedo albedo = directionalAlbedo(brdf, radians(angle), points);
    for (std::size_t c = 0; c < albedo.value.size(); ++c) {
      ++result.tested;
      result.count += albedo.value[c] - 3 * albedo.error[c] > 1;
      result.worst = std::max(result.worst, albedo.value[c]);
    }
  }
  return result;
}

}  // namespace brdf::app
