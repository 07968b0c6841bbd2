#pragma once
#include <brdf/brdf_export.h>
#include <brdf/simulate/Microsurface.h>

#include <array>
#include <string>
#include <vector>

namespace brdf {

/// The triangles or spheres that reach into one tile, with a tree of boxes over them, as
/// shaders/brdf_transport_tree.glsl searches it. Lengths are in units of the longer period; coordinates count from the
/// middle of the tile.
struct TileTree {
  using Texel = std::array<float, 4>;
  /// Of a triangle its three corners, with in w of the first the facet and of the second its medium (-1: opaque); of a
  /// sphere (centre, radius). In the order of the leaves.
  std::vector<Texel> primitives{};
  /// Four texels a node: least and most corner of the first child's box, then of the second's. In w of the least
  /// corner: the node, or of a leaf its first primitive; in w of the most corner: 0, or of a leaf how many primitives.
  /// Node 0 is the root. No path from it is longer than 44 nodes.
  std::vector<Texel> nodes{};
  std::array<double, 2> half{};    ///< of the periods, units
  double unit = 1;                 ///< micrometres
  double lowest = 0, highest = 0;  ///< z of the planes below and above everything, units
  double plane = 0;                ///< z = 0 micrometres, units
  double rounding = 0;             ///< how far from a facet float arithmetic may put a point, units

  /// `mediumOf`: by facet, -1 for an opaque one. Throws Error::Kind::Value, naming `where`, for more than 2^24
  /// primitives.
  BRDF_EXPORT TileTree(const TiledMesh& mesh, const std::vector<int>& mediumOf, const std::string& where);
  BRDF_EXPORT TileTree(const SpherePacking& packing, const std::vector<int>& mediumOf, const std::string& where);
};

}  // namespace brdf
