#pragma once
// Where direction pairs fall on the axes of a grid. Internal to libbrdf/material.
#include <brdf/formula/Program.h>
#include <brdf/material/GridLayout.h>

#include <array>
#include <optional>

namespace brdf {

/// A point between two cells of one axis.
struct GridPlace {
  std::uint32_t lower, upper;  ///< offsets into the grid: index times stride
  double weight;               ///< of the upper one
};

class GridLocator {
 public:
  static constexpr std::size_t kBlock = 512;

  /// `cells` true: which cell a pair is in (weight 0, lower = upper); false: which nodes it is between.
  GridLocator(const GridLayout& layout, bool cells);

  /// Axes with more than one node: the others change nothing.
  std::size_t dimensions() const { return axes_.size(); }

  struct Block {
    std::array<std::array<GridPlace, kBlock>, 4> places;  ///< for each dimension, for each pair
    std::array<std::uint8_t, kBlock> outside;             ///< 1 where an axis says that there is no value
  };
  /// At most kBlock pairs.
  void locate(const DirectionPairs<double>& pairs, Block& block) const;

 private:
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
    double position(double coordinate) const;  ///< in [0, points.size() - 1]
  };
  std::vector<Axis> axes_;
  std::optional<formula::Program> program_;
  bool cells_;
};

}  // namespace brdf
