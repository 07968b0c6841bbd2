#include "HalfVectorGrid.h"

#include <algorithm>
#include <cmath>

#include "ModelKit.h"

namespace brdf::test {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 1;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return std::max(*middle, 1e-8);
}

}  // namespace

HalfVectorGrid::HalfVectorGrid(const Direction& wo, double scaleX, double scaleY, double turn)
    : wo_(wo), scaleX_(scaleX), scaleY_(scaleY), cosine_(std::cos(turn)), sine_(std::sin(turn)) {}

HalfVectorGrid::HalfVectorGrid(const Direction& wo, const std::array<const double*, 3>& wi, std::size_t count)
    : HalfVectorGrid(wo, 1, 1) {
  double area = INFINITY;
  for (const double turn : {0.0, std::atan2(wo[1], wo[0])}) {
    const double c = std::cos(turn), s = std::sin(turn);
    std::vector<double> slopesX, slopesY;
    for (std::size_t k = 0; k < count; ++k) {
      if (!(wi[2][k] > 0)) continue;
      const double x = (wi[0][k] + wo[0]) / (wi[2][k] + wo[2]), y = (wi[1][k] + wo[1]) / (wi[2][k] + wo[2]);
      slopesX.push_back(std::fabs(c * x + s * y));
      slopesY.push_back(std::fabs(c * y - s * x));
    }
    const HalfVectorGrid grid(wo, median(slopesX), median(slopesY), turn);
    if (grid.scaleX_ * grid.scaleY_ < 0.99 * area) {
      *this = grid;
      area = scaleX_ * scaleY_;
    }
  }
}

std::size_t HalfVectorGrid::cellOf(const Direction& wi) const {
  const double slopeX = (wi[0] + wo_[0]) / (wi[2] + wo_[2]), slopeY = (wi[1] + wo_[1]) / (wi[2] + wo_[2]);
  const double x = (cosine_ * slopeX + sine_ * slopeY) / scaleX_, y = (cosine_ * slopeY - sine_ * slopeX) / scaleY_;
  const double root = std::cbrt(std::hypot(x, y)), q = std::isinf(root) ? 1 : root / (1 + root);
  const double turn = (std::atan2(y, x) + kPi) / (2 * kPi);
  const auto index = [](double share, std::size_t count) {
    return std::min(static_cast<std::size_t>(share * static_cast<double>(count)), count - 1);
  };
  return index(q, kRadial) * kAzimuthal + index(turn, kAzimuthal);
}

std::vector<double> HalfVectorGrid::integrate(const Density& density, std::size_t points) const {
  std::vector<double> sums(kCells);
  const std::size_t count = points * points;
  DirectionPairBuffer<double> pairs(count);
  std::vector<double> weights(count), values(count);
  const double stepQ = 1.0 / static_cast<double>(kRadial * points);
  const double stepPhi = 2 * kPi / static_cast<double>(kAzimuthal * points);
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    for (std::size_t k = 0; k < count; ++k) {
      const double q = (static_cast<double>(cell / kAzimuthal * points + k / points) + 0.5) * stepQ;
      const double phi = (static_cast<double>(cell % kAzimuthal * points + k % points) + 0.5) * stepPhi - kPi;
      const double root = q / (1 - q), r = root * root * root;
      const double x = r * std::cos(phi) * scaleX_, y = r * std::sin(phi) * scaleY_;
      const Direction h = normalized({cosine_ * x - sine_ * y, cosine_ * y + sine_ * x, 1});
      const double facing = dot(wo_, h);
      const Direction wi = mirrored(wo_, h);
      const bool lit = facing > 0 && wi[2] > 0;
      // d omega_i = 4 (wo.h) d omega_h, d omega_h = hz^3 dx dy of the slopes = hz^3 scaleX scaleY r dr dpsi,
      // dr = 3 (q/(1-q))^2 dq/(1-q)^2
      const double slopes = scaleX_ * scaleY_ * r * 3 * root * root / ((1 - q) * (1 - q)) * stepQ * stepPhi;
      weights[k] = lit ? 4 * facing * h[2] * h[2] * h[2] * slopes : 0;
      pairs.set(k, lit ? wi : Direction{0, 0, -1}, wo_);
    }
    density(pairs.view(), values.data());
    for (std::size_t k = 0; k < count; ++k) sums[cell] += weights[k] * values[k];
  }
  return sums;
}

}  // namespace brdf::test
