#include "Quadrature.h"

#include <brdf/sampling/DirectionalAlbedo.h>
#include <brdf/sampling/Sequence.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace brdf::app {

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
