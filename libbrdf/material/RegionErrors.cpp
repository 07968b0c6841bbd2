#include <brdf/base/Error.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/RegionErrors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace brdf {
namespace {

enum Region { kMirror, kRetro, kGrazing, kRest };
constexpr double kCone = radians(15), kGrazingAngle = radians(75);

double radicalInverse(std::size_t index, std::size_t base) {
  double result = 0, digit = 1.0 / static_cast<double>(base);
  for (; index > 0; index /= base, digit /= static_cast<double>(base))
    result += static_cast<double>(index % base) * digit;
  return result;
}

Direction onHemisphere(double u, double v) {
  const double sine = std::sqrt(u);
  return {sine * std::cos(2 * kPi * v), sine * std::sin(2 * kPi * v), std::sqrt(1 - u)};
}

Direction inCone(const Direction& axis, double u, double v) {
  Direction t, b, result{};
  orthonormalBasis(axis, t, b);
  const double cosine = 1 - u * (1 - std::cos(kCone)), sine = std::sqrt(1 - cosine * cosine);
  const double x = sine * std::cos(2 * kPi * v), y = sine * std::sin(2 * kPi * v);
  for (std::size_t k = 0; k < 3; ++k) result[k] = x * t[k] + y * b[k] + cosine * axis[k];
  return result;
}

Region regionOf(const Direction& wi, const Direction& wo) {
  const double cone = std::cos(kCone);
  if (dot(wo, {-wi[0], -wi[1], wi[2]}) > cone) return kMirror;
  if (dot(wo, wi) > cone) return kRetro;
  return std::min(wi[2], wo[2]) < std::cos(kGrazingAngle) ? kGrazing : kRest;
}

/// The pair of this index, or none when it is not of the region.
std::optional<DirectionPair> pairOf(Region region, std::size_t index) {
  const Direction wi = onHemisphere(radicalInverse(index, 2), radicalInverse(index, 3));
  const double u = radicalInverse(index, 5), v = radicalInverse(index, 7);
  Direction wo = onHemisphere(u, v);
  if (region == kMirror) wo = inCone({-wi[0], -wi[1], wi[2]}, u, v);
  if (region == kRetro) wo = inCone(wi, u, v);
  if (!(wi[2] > 0 && wo[2] > 0) || regionOf(wi, wo) != region) return std::nullopt;
  return DirectionPair{wi, wo};
}

}  // namespace

std::size_t directionRegion(const Direction& wi, const Direction& wo) { return regionOf(wi, wo); }

std::vector<RegionError> regionErrors(const Brdf& a, const Brdf& b, std::size_t count) {
  const std::size_t channels = b.channels().count();
  if (a.channels().count() != channels)
    throw Error(Error::Kind::Value,
                {"the channels differ", "comparison", std::to_string(a.channels().count()), std::to_string(channels)});
  std::vector<RegionError> result;
  for (const Region region : {kMirror, kRetro, kGrazing, kRest}) {
    DirectionPairBuffer<double> pairs(count);
    std::size_t found = 0;
    for (std::size_t index = 1; found < count; ++index)
      if (const auto pair = pairOf(region, index)) pairs.set(found++, pair->wi, pair->wo);
    std::vector<double> x(count * channels), y(count * channels);
    std::vector<std::uint8_t> validX(count), validY(count);
    a.evaluateParallel(pairs.view(), x.data(), validX.data());
    b.evaluateParallel(pairs.view(), y.data(), validY.data());
    RegionError error;
    error.region = kDirectionRegions[region];
    double sum = 0, magnitude = 0;
    for (std::size_t i = 0; i < count; ++i) {
      error.lost += validY[i] && !validX[i];
      if (!validX[i] || !validY[i]) continue;
      ++error.pairs;
      for (std::size_t at = i; at < x.size(); at += count) {
        const double difference = std::abs(x[at] - y[at]);
        sum += difference;
        magnitude += std::abs(y[at]);
        error.largest = std::max(error.largest, difference);
      }
    }
    if (error.pairs > 0) error.mean = sum / static_cast<double>(error.pairs * channels);
    if (magnitude > 0) error.relativeMean = sum / magnitude;
    result.push_back(std::move(error));
  }
  return result;
}

}  // namespace brdf
