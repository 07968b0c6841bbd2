#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>
#include <brdf/material/CellState.h>
#include <brdf/material/GridLayout.h>
#include <brdf/material/Quantity.h>

#include <memory>
#include <string>
#include <vector>

namespace brdf {

class GridLocator;

/// The content of a grid. Values are f_r in 1/sr without the cosine, whatever the file had (`original`): a reader
/// converts with convertQuantity(). Double: 8 bytes a value and 1 byte a cell.
struct GridData {
  GridLayout layout;
  Channels channels;
  std::vector<double> values;           ///< planar: channel c of cell i at [c * layout.cells() + i]
  std::vector<std::uint8_t> states;     ///< CellState, one a cell; empty: all Measured
  std::vector<double> standardError{};  ///< empty, or as `values`: one standard deviation, 1/sr; NaN where unknown
  Quantity original = Quantity::Brdf;   ///< what the source had
};

/// A BRDF on a rectilinear grid of 1 to 4 angles (GridLayout).
///
/// Its samples are its Measured cells at the directions of their nodes; a cell whose directions are not both above the
/// horizon is an invalid sample, though look-ups from above the horizon that come near it still see its value (a reader
/// that knows better calls invalidateBelowHorizon()).
class BRDF_EXPORT GridBrdf : public Brdf {
 public:
  enum class Lookup {
    Interpolated,  ///< multilinear in the axes' scales, renormalised over the valid cells; invalid where none is
    Nearest        ///< the value of the cell that holds the pair
  };

  /// Invalid and non-finite cells get the value 0. Throws Error::Kind::Value for a layout that is no good
  /// (GridLayout::check) or arrays that do not match it.
  GridBrdf(GridData data, std::string description, Lookup lookup = Lookup::Interpolated);
  ~GridBrdf() override;

  /// The same cells (shared, not copied) looked up in another way.
  std::shared_ptr<const GridBrdf> with(Lookup lookup) const;

  /// Any BRDF at the nodes of `layout`, on all threads. Cells below the horizon, and where `brdf` is invalid or not
  /// finite, are Invalid; the others are what the values of `brdf` rest on, and get its standard errors where it has
  /// them (material/ValueOrigins.h). Symmetry that the layout assumes and `brdf` lacks is imposed: the nodes' own
  /// directions count.
  static std::shared_ptr<const GridBrdf> tabulate(const Brdf& brdf, const GridLayout& layout);

  const GridData& data() const { return *data_; }
  const GridLayout& layout() const { return data_->layout; }
  Lookup lookup() const { return lookup_; }

  const Channels& channels() const override { return data_->channels; }
  Symmetry symmetry() const override { return data_->layout.surfaceSymmetry(); }
  bool reciprocal() const override { return data_->layout.reciprocal(); }
  std::string description() const override { return description_; }
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override;
  void evaluate(const DirectionPairs<float>& pairs, float* values, std::uint8_t* valid) const override;
  using Brdf::evaluate;
  const SampleSet* samples() const override;

 private:
  class Cells;
  GridBrdf(std::shared_ptr<const GridData> data, std::shared_ptr<const Cells> cells, std::string description,
           Lookup lookup);

  std::shared_ptr<const GridData> data_;
  std::shared_ptr<const Cells> cells_;
  std::unique_ptr<const GridLocator> locator_;
  std::string description_;
  Lookup lookup_;
};

/// Makes the values of a grid, which are `quantity`, f_r, and records it: divides by cos theta_o or pi, standard errors
/// as well. Cells whose viewer is not above the horizon become Invalid where the cosine is needed.
BRDF_EXPORT void convertQuantity(GridData& data, Quantity quantity);

/// Makes the cells below the horizon Invalid, so that interpolation near it leaves them out: for grids that hold a
/// filler there. Returns how many there were.
BRDF_EXPORT std::size_t invalidateBelowHorizon(GridData& data);

}  // namespace brdf
