#pragma once
#include <brdf/brdf_export.h>
#include <brdf/io/Hdf5.h>
#include <brdf/material/GridBrdf.h>

#include <cstdint>
#include <string>
#include <vector>

namespace brdf {

/// Writes a grid into an empty group, losslessly, as a VTKHDF ImageData (material/GridImage.h says what its Origin,
/// Spacing and AxisUnits mean). Point arrays: value_c (1/sr) and, where known, error_c for each channel; valid, a
/// CellState each. What an image cannot say stands beside: attributes Parametrisation, Quantity, OriginalQuantity,
/// Mirror, Reciprocal, Lookup, Channels; groups Axes/0, 1, ... with Quantity, Scale, Period, Outside, and the arrays
/// nodes (radians) and edges; SpecularOffsets.
void storeGrid(const h5::Group& group, const GridBrdf& grid);
BrdfPointer restoreGrid(const h5::Group& group, const std::string& description);

/// The layout alone, without reading values.
GridLayout restoreGridLayout(const h5::Group& group);

class Container;

/// A table or grid of a container, opened without reading its values: they are read by channel and by slice. A slice
/// is what one index of the third axis and those beyond holds: of a 4-D grid whose outgoing axes come first, one
/// incident direction.
class BRDF_EXPORT StoredTable {
 public:
  /// Throws Error::Kind::Value when the entry is neither a table nor a grid.
  StoredTable(const Container& container, std::size_t index);

  const GridLayout& layout() const { return layout_; }
  const Channels& channels() const { return channels_; }
  std::size_t slices() const { return static_cast<std::size_t>(shape_[0]); }
  std::size_t cellsPerSlice() const { return static_cast<std::size_t>(shape_[1] * shape_[2]); }

  /// Values of one channel, 1/sr, of `count` slices from `first` on.
  std::vector<double> values(std::size_t channel, std::size_t first, std::size_t count) const;
  /// Their CellStates.
  std::vector<std::uint8_t> states(std::size_t first, std::size_t count) const;

 private:
  h5::Group cells_;
  GridLayout layout_;
  Channels channels_;
  std::vector<std::uint64_t> shape_;  ///< z, y, x
};

}  // namespace brdf
