#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>

#include <cstdint>
#include <vector>

namespace brdf {

/// What the values of a BRDF at given directions rest on: measured cells or samples, or less. For whoever tabulates it:
/// a cell of the new table deserves what its value was made from (material/CellState.h).
///
/// - Tables and grids: Measured where the cells that the value is interpolated from are Measured, all but a millionth
///   of their weight; Extrapolated where one of them is Extrapolated or Invalid, and beyond the ends of an axis;
///   Invalid where all but a millionth lies on Invalid ones.
/// - Scattered samples: Measured within the convex hull of the samples that the value is interpolated from, in the
///   coordinates of the interpolation (material/ScatteredBrdf.h), however wide the gaps between them; Extrapolated
///   outside.
/// - Other channels of a BRDF (ChannelView): as the source.
/// - All else (formulas, patches, trees): Measured; they have values of their own everywhere.
class BRDF_EXPORT ValueOrigins {
 public:
  /// `brdf` must outlive it.
  explicit ValueOrigins(const Brdf& brdf);

  /// Makes the flags that `brdf` gave for the pairs (Brdf::evaluate) CellStates: 0 stays Invalid.
  void classify(const DirectionPairs<double>& pairs, std::uint8_t* states) const;

  /// Whether standard errors are known: of a grid that has them, seen through its own channels.
  bool hasStandardErrors() const { return errors_ != nullptr; }
  /// One standard deviation of each value, 1/sr, planar: the cells' standard errors, interpolated as the values are.
  /// The standard error of the interpolated value is never more, whatever the correlation of neighbouring cells (a
  /// standard deviation is a norm; the weights are not negative and sum to 1), and equal to it where their errors are
  /// one (calibration). What interpolation itself misses is not in it. NaN where one of the cells' is unknown.
  void standardErrors(const DirectionPairs<double>& pairs, double* errors) const;

 private:
  const Brdf* samples_ = nullptr;  ///< scattered ones
  BrdfPointer measured_, valid_;   ///< the share of such cells in the weight; invalid beyond the ends
  BrdfPointer errors_;
  BrdfPointer unknown_;  ///< the share of cells with an unknown standard error, where there are any
};

}  // namespace brdf
