#pragma once
#include <brdf/geometry/Directions.h>

#include <array>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace brdf {

/// An edge of a mesh: the indices of its ends, the smaller one in the upper half.
using MeshEdge = std::uint64_t;

inline MeshEdge meshEdge(std::uint32_t a, std::uint32_t b) {
  return a < b ? (MeshEdge{a} << 32) | b : (MeshEdge{b} << 32) | a;
}
inline std::uint32_t firstEnd(MeshEdge edge) { return static_cast<std::uint32_t>(edge >> 32); }
inline std::uint32_t secondEnd(MeshEdge edge) { return static_cast<std::uint32_t>(edge); }

/// Triangles over the upper unit hemisphere that share whole edges: the upper half of an octahedron, subdivided, then
/// refined wherever asked.
class GeodesicMesh {
 public:
  using Triangle = std::array<std::uint32_t, 3>;  ///< counter-clockwise from outside

  /// Four triangles; one edge from the rim to the pole lies at azimuth `phi` (radians).
  explicit GeodesicMesh(double phi);

  const std::vector<Direction>& directions() const { return directions_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// Every edge once, ascending.
  std::vector<MeshEdge> edges() const;
  double length(MeshEdge edge) const;              ///< of the chord
  Direction along(MeshEdge edge, double t) const;  ///< the direction over the chord's point at t from the first end

  /// Four triangles for each.
  void subdivide();

  /// Moves the nearest vertex that is neither on the rim nor `kept` to `target` (above the horizon); returns its index.
  /// For meshes that were only subdivided, and targets in the planes of the octahedron's edges: no triangle turns over.
  std::uint32_t moveNearest(const Direction& target, std::uint32_t kept);
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// Splits the marked edges for all their triangles, which keeps the mesh conforming. A triangle with a marked edge is
  /// bisected at its longest edge first (Rivara 1984, "Algorithms for refining triangular grids suitable for adaptive
  /// and multigrid techniques", doi:10.1002/nme.1620200412), which keeps its angles from degenerating; with three it
  /// becomes four. Returns false, having changed nothing, when there would be more than `maximumTriangles`.
  bool split(std::unordered_set<MeshEdge> marked, std::size_t maximumTriangles);

 private:
  Triangle longestFirst(const Triangle& triangle) const;

  std::vector<Direction> directions_;
  std::vector<Triangle> triangles_;
};

}  // namespace brdf
