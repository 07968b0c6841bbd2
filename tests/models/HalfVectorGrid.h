#pragma once
// Quadrature and binning over the half vectors of one view direction, where every lobe is smooth. The slopes of the
// half vector (hx/hz, hy/hz), turned and scaled to the lobe, have polar coordinates r and psi; cells are even in psi
// and in q, r = (q/(1-q))^3, which resolves every scale from a thousandth of the lobe's to a thousand times that.
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/geometry/Directions.h>

#include <functional>
#include <vector>

namespace brdf::test {

class HalfVectorGrid {
 public:
  static constexpr std::size_t kRadial = 24, kAzimuthal = 24;
  static constexpr std::size_t kCells = kRadial * kAzimuthal;

  /// `scaleX` and `scaleY` are typical slopes of the lobe's half vectors along axes turned by `turn` radians from x.
  HalfVectorGrid(const Direction& wo, double scaleX, double scaleY, double turn = 0);
  /// At the median slopes of `count` light directions (z = 0 marks a failed draw), along x and y or along and across
  /// the view direction, whichever fits closer.
  HalfVectorGrid(const Direction& wo, const std::array<const double*, 3>& wi, std::size_t count);

  /// The cell that holds the half vector of wi and wo.
  std::size_t cellOf(const Direction& wi) const;

  /// Writes a density (1/sr of light directions) for a batch of pairs.
  using Density = std::function<void(const DirectionPairs<double>& pairs, double* values)>;
  /// The integral of `density` over the light directions of each cell above the horizon, by `points` x `points`
  /// midpoints a cell.
  std::vector<double> integrate(const Density& density, std::size_t points) const;

 private:
  Direction wo_;
  double scaleX_, scaleY_, cosine_, sine_;
};

}  // namespace brdf::test
