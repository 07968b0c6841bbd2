#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/material/PatchBasis.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace brdf {
namespace {

constexpr std::size_t kMostRings = 1000, kMostPatches = 100000;
constexpr double kRightAngle = kPi / 2;

PatchBasis fromDegrees(const char* name, std::initializer_list<PatchBasis::Ring> rings) {
  std::vector<PatchBasis::Ring> converted(rings);
  for (PatchBasis::Ring& ring : converted) ring.upperTheta = radians(ring.upperTheta);
  return {name, std::move(converted)};
}

}  // namespace

PatchBasis::PatchBasis(std::string name, std::vector<Ring> rings) : name_(std::move(name)), rings_(std::move(rings)) {
  const std::string where = "angle basis " + name_;
  const auto fail = [&](const char* what, std::string found, std::string allowed) {
    throw Error(Error::Kind::Value, {what, where, std::move(found), std::move(allowed)});
  };
  if (rings_.empty() || rings_.size() > kMostRings)
    fail("wrong number of rings", std::to_string(rings_.size()), "1 to " + std::to_string(kMostRings));
  first_.push_back(0);
  double lower = 0;
  for (Ring& ring : rings_) {
    // 90 degrees in radians and back may miss by a rounding.
    if (std::abs(ring.upperTheta - kRightAngle) < 1e-12) ring.upperTheta = kRightAngle;
    if (!(ring.upperTheta > lower && ring.upperTheta <= kRightAngle))
      fail("polar angles out of order", formatNumber(degrees(ring.upperTheta), 6) + " degrees",
           "above " + formatNumber(degrees(lower), 6) + ", at most 90 degrees");
    if (ring.count < 1 || ring.count > kMostPatches)
      fail("wrong number of azimuths", std::to_string(ring.count), "1 to " + std::to_string(kMostPatches));
    const double low = lower == 0 ? 1 : upperCos_.back();
    const double high = ring.upperTheta == kRightAngle ? 0 : std::cos(ring.upperTheta);
    upperCos_.push_back(high);
    projected_.push_back(kPi * (low - high) * (low + high) / static_cast<double>(ring.count));
    first_.push_back(first_.back() + ring.count);
    lower = ring.upperTheta;
  }
}

const PatchBasis& PatchBasis::klemsFull() {
  static const PatchBasis basis = fromDegrees(
      "LBNL/Klems Full", {{5, 1}, {15, 8}, {25, 16}, {35, 20}, {45, 24}, {55, 24}, {65, 24}, {75, 16}, {90, 12}});
  return basis;
}

const PatchBasis& PatchBasis::klemsHalf() {
  static const PatchBasis basis =
      fromDegrees("LBNL/Klems Half", {{6.5, 1}, {19.5, 8}, {32.5, 12}, {45.5, 16}, {58.5, 20}, {71.5, 12}, {90, 8}});
  return basis;
}

const PatchBasis& PatchBasis::klemsQuarter() {
  static const PatchBasis basis = fromDegrees("LBNL/Klems Quarter", {{9, 1}, {27, 8}, {45, 12}, {63, 12}, {90, 8}});
  return basis;
}

std::size_t PatchBasis::find(double x, double y, double z) const {
  // The first ring whose upper bound the direction does not reach.
  const auto above = std::upper_bound(upperCos_.begin(), upperCos_.end(), z, std::greater<>());
  if (!(z > 0) || above == upperCos_.end()) return npos;
  const auto ring = static_cast<std::size_t>(above - upperCos_.begin());
  const std::size_t count = rings_[ring].count;
  if (count == 1) return first_[ring];
  const double turn = std::atan2(y, x) * (0.5 / kPi);
  const auto step = static_cast<std::ptrdiff_t>(std::floor(turn * static_cast<double>(count) + 0.5));
  const auto n = static_cast<std::ptrdiff_t>(count);
  return first_[ring] + static_cast<std::size_t>((step % n + n) % n);
}

double PatchBasis::solidAngle(std::size_t patch) const {
  const std::size_t ring = ringOf(patch);
  const double low = ring == 0 ? 1 : upperCos_[ring - 1];
  return 2 * kPi * (low - upperCos_[ring]) / static_cast<double>(rings_[ring].count);
}

std::size_t PatchBasis::ringOf(std::size_t patch) const {
  return static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), patch) - first_.begin()) - 1;
}

Direction PatchBasis::centre(std::size_t patch) const {
  const std::size_t ring = ringOf(patch), count = rings_[ring].count;
  if (ring == 0 && count == 1) return {0, 0, 1};
  const double turn = static_cast<double>(patch - first_[ring]) / static_cast<double>(count);
  return fromSpherical((lowerTheta(ring) + rings_[ring].upperTheta) / 2, 2 * kPi * turn);
}

Direction PatchBasis::at(std::size_t patch, double u, double v) const {
  const std::size_t ring = ringOf(patch);
  const double low = ring == 0 ? 1 : upperCos_[ring - 1], high = upperCos_[ring];
  const double sin2 = (1 - low * low) + u * (low - high) * (low + high);
  const double phi =
      2 * kPi * (static_cast<double>(patch - first_[ring]) + v - 0.5) / static_cast<double>(rings_[ring].count);
  const double radius = std::sqrt(sin2);
  return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(std::max(0.0, 1 - sin2))};
}

std::size_t PatchBasis::mirrored(std::size_t patch) const {
  const std::size_t ring = ringOf(patch), k = patch - first_[ring];
  return first_[ring] + (k == 0 ? 0 : rings_[ring].count - k);
}

}  // namespace brdf
