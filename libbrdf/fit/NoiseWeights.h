#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/SampleSet.h>

namespace brdf {

/// Samples whose standard errors are known, each of which stands for 1 / variance (solidAngles()) instead of its solid
/// angle. With the metric "rms" and independent Gaussian noise, the fit to them is that of maximum likelihood.
///
/// - A sample whose error is not known (NaN, infinite, negative) in some channel is invalid.
/// - Of several channels the variance is their mean: one weight a sample.
/// - An error of 0 means that no scatter was seen, not that there is none (a bin that no ray met): it counts as the
///   smallest twentieth (5 % quantile) of the positive errors of the valid samples.
class BRDF_EXPORT NoiseWeightedSamples : public SampleSet {
 public:
  /// `source` must outlive this. Throws Error::Kind::Value when it has no standard errors, or none above 0.
  explicit NoiseWeightedSamples(const SampleSet& source);

  std::size_t count() const override { return source_.count(); }
  const Channels& channels() const override { return source_.channels(); }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override;
  /// 1 / variance in (1/sr)^-2; 0 where the error is not known.
  bool solidAngles(std::size_t first, std::size_t length, double* measures) const override;
  bool standardErrors(std::size_t first, std::size_t length, double* errors) const override {
    return source_.standardErrors(first, length, errors);
  }

  double leastError() const { return leastError_; }  ///< what an error of 0 counts as, 1/sr

 private:
  /// Root mean square over channels, negative where it is not known.
  void errors(std::size_t first, std::size_t length, double* errors) const;

  const SampleSet& source_;
  double leastError_ = 0;
};

}  // namespace brdf
