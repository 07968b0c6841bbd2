#pragma once
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/sampling/SamplingChart.h>

#include <functional>
#include <span>
#include <vector>

namespace brdf {

/// Cells of the hemisphere, small where directions are dense: halved at the median direction, by turns along the two
/// coordinates. These are polar about the mirror direction of the viewer and about the viewer, each where it is nearer:
/// phi, and w = log(1 + x/e) of x = sin^2(theta/2), in which a peak there is smooth whatever its width.
class HemispherePartition {
 public:
  struct Cell {
    double w0, w1, phi0, phi1;
    bool retro;  ///< about the viewer
  };

  /// About `cells` cells over all of the hemisphere, from directions above the horizon.
  HemispherePartition(const Direction& wo, std::span<const Direction> directions, std::size_t cells);

  const std::vector<Cell>& cells() const { return cells_; }
  std::size_t cellOf(const Direction& wi) const;
  /// Between a cell's ends; may lie below the horizon where the cell does in part.
  Direction centre(const Cell& cell) const;

  /// The integral of a density (1/sr) over the lights of each cell: midpoints of 8 x 8, quartered
  /// where the range of their densities, times the area that one stands for, is more than `tolerance` of a cell's even
  /// share of 1, or of what has been found where that is more, and where one of the directions that laid out the cells
  /// has a density well above theirs (a peak between the midpoints). At most 2^18 times: the integral of a density that
  /// has none comes out large, and ends.
  using Density = std::function<void(const DirectionPairs<double>& pairs, double* values)>;
  std::vector<double> integrate(const Density& density, double tolerance) const;

 private:
  using Point = std::array<double, 2>;  ///< w and phi
  struct Split {
    double at = 0;
    std::size_t lower = 0, upper = 0;  ///< indices of splits, or of cells where `leaf`
    bool alongW = true, leaf = false;
  };
  bool nearViewer(const Direction& wi) const;
  Point coordinates(const Direction& wi) const;
  /// The direction, and d omega / (dw dphi): 0 where it is below the horizon or nearer to the other pole.
  double directionAt(bool retro, const Point& at, Direction& wi) const;
  std::size_t divide(std::size_t first, std::size_t count, const Cell& cell, std::size_t depth, bool alongW);

  ChartViewer poles_[2];  ///< whose charts about the viewer these are: the mirror direction's and the viewer's
  std::vector<Cell> cells_;
  std::vector<Split> splits_;
  std::vector<Point> points_;            ///< the directions, those of a cell together
  std::vector<std::size_t> cellPoints_;  ///< first point of each cell, and the end
  std::size_t roots_[2] = {0, 0};
};

}  // namespace brdf
