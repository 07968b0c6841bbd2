#pragma once
#include <brdf/brdf_export.h>

#include <array>
#include <cstddef>
#include <vector>

namespace brdf {

/// Densities on the unit square, bilinear between the width x height nodes of a grid, for a grid of conditions: 0 or 2
/// parameters between whose values the densities are interpolated linearly (and held at the ends). Drawing and its
/// inverse are exact for that density: y by its marginal, which is linear between rows, then x by the row's density.
class BRDF_EXPORT Warp2D {
 public:
  struct Point {
    double x, y;
  };
  struct Drawn {
    Point at;        ///< where the two numbers lead, or come from
    double density;  ///< per unit area of the square, at the point that is no random number
  };
  /// Slices between which a condition lies, and their weights.
  struct Condition {
    std::array<std::size_t, 4> slice{};
    std::array<double, 4> weight{};
    std::size_t count = 0;
  };

  Warp2D() = default;
  /// `values`: [first parameter][second parameter][y][x]. With `normalise` each slice integrates to 1 (its values are
  /// never negative; a slice of zeros becomes even), and draw and invert may be called. Both sizes are at least 2.
  Warp2D(std::size_t width, std::size_t height, std::vector<float> first, std::vector<float> second,
         std::vector<float> values, bool normalise);

  Condition locate(double first, double second) const;
  double evaluate(const Point& at, const Condition& condition) const;
  /// The point for two numbers in [0, 1).
  Drawn draw(const Point& numbers, const Condition& condition) const;
  /// The numbers that lead to a point.
  Drawn invert(const Point& at, const Condition& condition) const;

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }

 private:
  double value(std::size_t index, const Condition& condition) const;
  double row(std::size_t y, std::size_t x, const Condition& condition) const;
  double rows(std::size_t y, const Condition& condition) const;

  std::size_t width_ = 2, height_ = 2;
  std::vector<float> first_, second_, values_;
  std::vector<double> rowSums_;  ///< of each slice and row: integral of its density over x from 0 to node x
  std::vector<double> sums_;     ///< of each slice: integral of the marginal over y from 0 to row y
};

}  // namespace brdf
