#pragma once
#include <brdf/brdf_export.h>
#include <brdf/simulate/HeightField.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace brdf {

/// A height field as shaders/brdf_transport_field.glsl searches it, for a backend that keeps floats: heights by cell,
/// and the least and most height of squares of 2, 4, 8, ... cells. An axis along which no height changes is one cell.
/// Lengths are in units of spacingX, z counts from the middle of the heights.
struct FieldTexels {
  std::size_t columns = 1, rows = 1;  ///< cells
  /// `columns` a row. Of a cell the heights at its corners (0,0), (1,0), (1,1), (0,1); below these rows, of each square
  /// of 2, 4, ... cells the least and the most height in it, level k from row levelRows[k] on. A square at the end of
  /// the tile has the cells that are left.
  std::vector<std::array<float, 4>> texels{};
  std::vector<std::size_t> levelRows{0};  ///< as many as levels; the last level is one square
  std::array<double, 2> cellsPerUnit{};   ///< along x and y; 0 along which nothing changes
  double unit = 1;                        ///< micrometres
  double lowest = 0, highest = 0;         ///< z of the planes below and above everything, units

  /// Throws Error::Kind::Value, naming `where`, for more than `mostTexels` columns or rows of texels, or 2^24
  /// cells.
  BRDF_EXPORT FieldTexels(const HeightField& field, std::size_t mostTexels, const std::string& where);
};

}  // namespace brdf
