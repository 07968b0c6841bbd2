#pragma once
// Cells that are narrow where light is concentrated. Internal to libbrdf/simulate.
#include <cstddef>
#include <functional>
#include <vector>

namespace brdf {

/// Light along one axis: of rays of one incident direction, where they left and how much they carried.
class AxisLight {
 public:
  /// Positions on the axis and shares of the light, in any order.
  AxisLight(const std::vector<double>& positions, const std::vector<double>& shares);

  struct Sums {
    double light = 0, squares = 0;  ///< of shares, and of their squares
  };
  /// Of the rays within [from, to).
  Sums between(double from, double to) const;

 private:
  std::vector<double> positions_;        ///< ascending
  std::vector<double> light_, squares_;  ///< sums of the rays before each
};

/// Edges of an axis whose cells are cut in three where they are too wide: where a cell holds a hundredth or more of
/// some light and a mean over it would lose a twentieth or more of the light's square, by more than four standard
/// errors; and the cells beside those, so that a peak's neighbours are as narrow as it. Cut in three, a peak in the
/// middle of its cell stays in the middle of one. `measure` is the integral of what light that is spread evenly has on
/// the axis; no cell becomes narrower than `narrowest` (radians). With `wraps`, the first and the last cell are
/// neighbours. The same edges, where nothing is too wide.
std::vector<double> cutWherePeaked(const std::vector<double>& edges, const std::vector<AxisLight>& lights,
                                   const std::function<double(double)>& measure, double narrowest, bool wraps);

}  // namespace brdf
