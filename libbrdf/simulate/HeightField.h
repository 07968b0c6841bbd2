#pragma once
#include <brdf/brdf_export.h>

#include <cstddef>
#include <string>
#include <vector>

namespace brdf {

/// A surface z = h(x, y) that repeats without end along x and y: heights at the nodes of a lattice. Every cell of four
/// nodes is two triangles, parted by the diagonal from its corner of lowest x and y to the opposite one, so that every
/// backend means the same surface. Lengths are micrometres; ray optics looks at their ratios only.
struct HeightField {
  std::size_t columns = 0, rows = 0;  ///< nodes of one period along x and y; the node after the last is the first again
  double spacingX = 1, spacingY = 1;  ///< between nodes, micrometres, > 0
  std::vector<float> heights{};  ///< micrometres; that of node (i, j), at (i spacingX, j spacingY), is [j columns + i]

  double periodX() const { return static_cast<double>(columns) * spacingX; }
  double periodY() const { return static_cast<double>(rows) * spacingY; }
  float height(std::size_t i, std::size_t j) const { return heights[j * columns + i]; }

  /// Throws Error::Kind::Value, naming `where`, for fewer than 2 nodes along an axis, more than 2^28 of them, a spacing
  /// that is not positive, heights that are not finite, or a wrong number of them.
  BRDF_EXPORT void check(const std::string& where) const;
};

}  // namespace brdf
