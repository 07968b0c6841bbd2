#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/material/Brdf.h>

#include <memory>
#include <vector>

namespace brdf {

class ScatteredBrdf;
class ValueOrigins;

/// Standard errors of the values of a BRDF, where the data carry them, seen through its channels: a channel that is a
/// weighted sum of measured ones has the sum of |weight| times their errors, which its own error never exceeds, and
/// which it equals where their errors are one (calibration).
class BRDF_EXPORT ValueErrors {
 public:
  /// `brdf` must outlive it.
  explicit ValueErrors(const Brdf& brdf);
  ~ValueErrors();

  /// Of interpolated values at any directions: of grids.
  bool knownOfValues() const;
  /// Planar, 1/sr; NaN where unknown.
  void ofValues(const DirectionPairs<double>& pairs, double* errors) const;

  /// Of the BRDF's own samples: of scattered ones, and of the cells of grids.
  bool knownOfSamples() const { return sampleErrors_ != nullptr; }
  /// Of channel `channel` of sample `index`.
  double ofSample(std::size_t index, std::size_t channel) const;

 private:
  std::size_t inputs_ = 0, outputs_ = 0, samples_ = 0;
  std::vector<double> weights_;  ///< |weight|, a row for each channel; empty: the source's own channels
  std::unique_ptr<const ValueOrigins> origins_;
  const std::vector<double>* sampleErrors_ = nullptr;
};

}  // namespace brdf
