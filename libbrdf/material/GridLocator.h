#pragma once
// Where direction pairs fall on the axes of a grid. Internal to libbrdf/material.
#include <brdf/formula/Program.h>
#include <brdf/material/GridLayout.h>

#include <array>
#include <optional>

namespace brdf {

class GridLocator {
 public:
  static constexpr std::size_t kBlock = 256;

  /// `cells` true: which cell a pair is in; false: which nodes it is between.
  GridLocator(const GridLayout& layout, bool cells);

  /// Ascending points of one axis in its scale, and where a coordinate lies among them.
  struct Axis {
    std::vector<double> points;
    std::size_t count;   ///< cells
    std::size_t stride;  ///< of the grid
    bool uniform;
    double origin, inverseStep;
    std::vector<std::uint32_t> buckets;  ///< where points are not equally spaced: last point at or below each bucket
    bool bounded;                        ///< pairs below `low` or above `high` are outside
    double low, high;

    void prepare();
    double position(double coordinate) const;  ///< in [0, points.size() - 1]; where points are not equally spaced
  };
  const std::vector<Axis>& axes() const { return axes_; }
  /// A formula that assigns coordinate_0, coordinate_1, ..., where a pair lies on each of the axes in its scale.
  const std::string& coordinates() const { return coordinates_; }

  /// Axes with more than one node: the others change nothing.
  std::size_t dimensions() const { return axes_.size(); }

  /// For each pair: the cell below it on all axes, and on each axis what leads from there to the next cell and its
  /// weight.
  template <class T>
  struct Block {
    std::array<std::uint32_t, kBlock> base;
    std::array<std::array<std::int32_t, kBlock>, 4> step;
    std::array<std::array<T, kBlock>, 4> weight;
    std::array<std::uint8_t, kBlock> outside;  ///< 1 where an axis says that there is no value
    bool anyOutside;
  };
  /// At most kBlock pairs. T is float or double.
  template <class T>
  void locate(const DirectionPairs<T>& pairs, Block<T>& block) const;

 private:
  std::vector<Axis> axes_;
  std::string coordinates_;
  std::optional<formula::Program> program_;
};

}  // namespace brdf
