#pragma once
// A tree of boxes for shaders. Internal to libbrdf/simulate.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace brdf {

struct FloatBox {
  std::array<float, 3> least{1e30F, 1e30F, 1e30F}, most{-1e30F, -1e30F, -1e30F};
  void add(const FloatBox& other);
  float area() const;  ///< half the surface, 0 of an empty box
};

/// Puts `order` (indices of boxes) into the order of the leaves and returns the nodes in the layout of TileTree::nodes.
/// Splits by the surface area heuristic over bins (I. Wald 2007, "On fast Construction of SAH-based Bounding Volume
/// Hierarchies", DOI 10.1109/RT.2007.4342588); deep down by halves, so that no path is longer than 44 nodes.
std::vector<std::array<float, 4>> makeBoxTree(std::span<const FloatBox> boxes, std::vector<std::uint32_t>& order);

}  // namespace brdf
