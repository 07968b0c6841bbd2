#pragma once
#include <brdf/geometry/Directions.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/ScatteredBrdf.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>

/// Scattered "measurements" of a known material: half of the pairs anywhere above 80 degrees from the horizon, half
/// near the mirror direction, where narrow lobes show.
inline brdf::ScatteredSamples synthesize(const brdf::Brdf& truth, std::size_t count, double noise = 0,
                                         std::uint64_t seed = 1) {
  using namespace brdf;
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto normal = [&] {
    const double u = 1 - uniform(), v = uniform();
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * kPi * v);
  };
  ScatteredSamples samples;
  samples.channels = truth.channels();
  samples.isotropic = truth.symmetry() == Symmetry::Isotropic;
  while (samples.pairs.size() < count) {
    const double ti = radians(80) * uniform(), pi = 2 * kPi * uniform();
    double to = radians(80) * uniform(), po = 2 * kPi * uniform();
    if (samples.pairs.size() % 2 == 1) {
      to = std::min(radians(80), std::abs(ti + 0.15 * normal()));
      po = pi + kPi + 0.15 * normal();
    }
    samples.pairs.push(fromSpherical(ti, pi), fromSpherical(to, po));
  }
  samples.values.resize(truth.channels().count() * count);
  truth.evaluate(samples.pairs.view(), samples.values.data(), nullptr);
  for (double& value : samples.values) value += noise * normal();
  return samples;
}

inline brdf::ScatteredBrdf syntheticTarget(const std::string& expression, std::size_t count, double noise = 0,
                                           std::uint64_t seed = 1) {
  return brdf::ScatteredBrdf(synthesize(*brdf::parseMaterialExpression(expression), count, noise, seed), expression);
}
