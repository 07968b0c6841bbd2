#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/SampleSet.h>

#include <vector>

namespace brdf {

/// Samples whose standard errors are known, to be read with weights by noise (fit/Samples.h): each value, of a sample
/// and channel, counts by 1 / variance. With the metric "rms" and independent Gaussian noise, the fit to them is that
/// of maximum likelihood.
///
/// - A sample whose error is not known (NaN, infinite, negative) in some channel is invalid.
/// - An error of 0 means that no scatter was seen, not that there is none (a bin that no ray met): it counts as the
///   smallest twentieth (5 % quantile) of the positive errors of the channel's valid samples, or where there is none as
///   the smallest that counts so in another channel.
class BRDF_EXPORT NoiseWeightedSamples : public SampleSet {
 public:
  /// `source` must outlive this. Throws Error::Kind::Value when it has no standard errors, or none above 0.
  explicit NoiseWeightedSamples(const SampleSet& source);

  std::size_t count() const override { return source_.count(); }
  const Channels& channels() const override { return source_.channels(); }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override;
  bool solidAngles(std::size_t first, std::size_t length, double* measures) const override {
    return source_.solidAngles(first, length, measures);
  }
  /// As they count: all positive, NaN where one is not known in some channel.
  bool standardErrors(std::size_t first, std::size_t length, double* errors) const override;

  /// What an error of 0 counts as in a channel, 1/sr.
  double leastError(std::size_t channel) const { return leastErrors_[channel]; }

 private:
  const SampleSet& source_;
  std::vector<double> leastErrors_;
};

}  // namespace brdf
