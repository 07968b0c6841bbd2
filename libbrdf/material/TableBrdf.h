#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>
#include <brdf/material/CellState.h>
#include <brdf/material/TableLayout.h>

#include <memory>
#include <string>
#include <vector>

namespace brdf {

class GridLocator;

/// The cells of a table. Always double (what MERL files hold): 8 bytes a value and 1 byte a cell, so 36.5 MB for MERL's
/// 90 x 90 x 180 cells in RGB.
struct TableData {
  TableLayout layout;
  Channels channels;
  std::vector<double> values;  ///< 1/sr without the cosine, planar: channel c of cell i at [c * layout.cells() + i]
  std::vector<std::uint8_t> valid;  ///< CellState of each cell
};

/// An isotropic BRDF tabulated in half/difference coordinates (TableLayout).
///
/// Its samples are its cells in their order, at the cells' centres: those that are Measured. A cell whose centre is
/// below the horizon is an invalid sample, though lookups from above the horizon that fall into it still see its value.
/// The symmetry is Bilateral: phi_d and -phi_d are different cells, and measured ones differ.
class BRDF_EXPORT TableBrdf : public Brdf {
 public:
  enum class Lookup {
    /// Trilinear in sqrt(theta_h), theta_d and phi_d (periodic), renormalised over the valid ones of the eight cells;
    /// invalid where none is valid.
    Interpolated,
    /// The value of the cell that holds the pair: MERL's official lookup, which truncates.
    Nearest
  };
  /// Where in its cell a value belongs when interpolating. The official lookup makes cell i the interval [i, i + 1), so
  /// its centre is the unbiased place and the default; tools that interpolate at nodes (i) show the highlight half a
  /// cell narrower.
  enum class Position { Centre, Node };

  /// Invalid and non-finite cells get the value 0. Throws Error::Kind::Value when an axis has no cell or the arrays
  /// disagree with the layout.
  TableBrdf(TableData data, std::string description, Lookup lookup = Lookup::Interpolated,
            Position position = Position::Centre);
  ~TableBrdf() override;

  /// The same cells (shared, not copied) looked up in another way.
  std::shared_ptr<const TableBrdf> with(Lookup lookup, Position position = Position::Centre) const;

  /// Any BRDF at the cell centres, on all threads. Cells below the horizon, and where `brdf` is invalid or not finite,
  /// are invalid; the others are what its values rest on (material/ValueOrigins.h). An anisotropic BRDF is cut at phi_h
  /// = 0; a non-reciprocal one in a reciprocal layout keeps phi_d in [0, pi).
  static std::shared_ptr<const TableBrdf> tabulate(const Brdf& brdf, const TableLayout& layout = {});

  const TableData& data() const { return *data_; }
  Lookup lookup() const { return lookup_; }
  Position position() const { return position_; }

  const Channels& channels() const override { return data_->channels; }
  Symmetry symmetry() const override { return Symmetry::Bilateral; }
  bool reciprocal() const override { return data_->layout.reciprocal; }
  std::string description() const override { return description_; }
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override;
  void evaluate(const DirectionPairs<float>& pairs, float* values, std::uint8_t* valid) const override;
  using Brdf::evaluate;
  const SampleSet* samples() const override;

 private:
  class Cells;
  TableBrdf(std::shared_ptr<const TableData> data, std::shared_ptr<const Cells> cells, std::string description,
            Lookup lookup, Position position);

  std::shared_ptr<const TableData> data_;
  std::shared_ptr<const Cells> cells_;
  std::unique_ptr<const GridLocator> locator_;
  std::string description_;
  Lookup lookup_;
  Position position_;
};

}  // namespace brdf
