#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// One axis of a hole map: the cells of an axis of the data's own layout.
struct HoleMapAxis {
  std::string name;           ///< e.g. "theta_h"
  std::vector<double> nodes;  ///< where each cell's value belongs, degrees, ascending
  std::vector<double> edges;  ///< nodes.size() + 1, degrees, ascending: halfway between nodes where the layout has none
};

/// How many cells of a table or grid hold what, over two of its own axes: each place of the map sums over all others.
struct HoleMap {
  /// The classes, which exclude each other: what a cell holds (material/CellState.h) where its directions are above the
  /// horizon, else BelowHorizon, whatever it holds.
  enum Class : std::size_t { Measured, Filled, Invalid, BelowHorizon };
  static constexpr std::array<std::string_view, 4> kNames{"measured", "filled", "invalid", "below the horizon"};
  using Counts = std::array<std::uint64_t, 4>;

  HoleMapAxis x, y;
  std::vector<Counts> counts;  ///< of place (i, j) at [j * x.nodes.size() + i]
  Counts total{};
  std::string layout;  ///< all axes, for people: "phi_d 180 x theta_d 90 x theta_h 90, half_difference"
};

/// `xAxis` and `yAxis` are names of two different axes of the layout; empty: theta_h and theta_d, or theta_o and
/// theta_i, or specular_theta and theta_i, where the layout has them, else its first two. Throws Error::Kind::Value for
/// a BRDF without a grid of cells, for a layout of one axis, and for an unknown axis.
BRDF_EXPORT HoleMap makeHoleMap(const Brdf& brdf, std::string_view xAxis = {}, std::string_view yAxis = {});

}  // namespace brdf
