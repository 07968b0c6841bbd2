#pragma once
#include <brdf/brdf_export.h>
#include <brdf/sampling/TabulatedSampler.h>

namespace brdf {

/// A BRDF with a sampler made from its own values; everything else is the source's.
class BRDF_EXPORT SampledBrdf : public Brdf {
 public:
  SampledBrdf(BrdfPointer source, TabulatedSampler sampler);

  const BrdfPointer& source() const { return source_; }
  const TabulatedSampler& sampler() const { return sampler_; }

  const Channels& channels() const override { return source_->channels(); }
  Symmetry symmetry() const override { return source_->symmetry(); }
  bool reciprocal() const override { return source_->reciprocal(); }
  std::string description() const override { return source_->description(); }
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override;
  void evaluate(const DirectionPairs<float>& pairs, float* values, std::uint8_t* valid) const override;
  using Brdf::evaluate;
  void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
              const std::array<double*, 3>& wi, std::size_t count) const override;
  void pdf(const DirectionPairs<double>& pairs, double* density) const override;
  const SampleSet* samples() const override { return source_->samples(); }

 private:
  BrdfPointer source_;
  TabulatedSampler sampler_;
};

/// `brdf` with a tabulated sampler. Comes back as it was when it has one already, and when its own sampler has no more
/// variance than `options.tolerance` above the tables' (mean over five polar angles, measured): an analytic sampler
/// that fits needs no tables. Throws Error::Kind::Value when an option is out of its range.
BRDF_EXPORT BrdfPointer withSampler(BrdfPointer brdf, const SamplerOptions& options = {});

}  // namespace brdf
