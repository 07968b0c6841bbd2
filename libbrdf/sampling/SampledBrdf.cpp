#include <brdf/sampling/SampledBrdf.h>
#include <brdf/sampling/SamplerEfficiency.h>

namespace brdf {

SampledBrdf::SampledBrdf(BrdfPointer source, TabulatedSampler sampler)
    : source_(std::move(source)), sampler_(std::move(sampler)) {}

void SampledBrdf::evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  source_->evaluate(pairs, values, valid);
}

void SampledBrdf::evaluate(const DirectionPairs<float>& pairs, float* values, std::uint8_t* valid) const {
  source_->evaluate(pairs, values, valid);
}

void SampledBrdf::sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
                         const std::array<double*, 3>& wi, std::size_t count) const {
  sampler_.sample(wo, u, wi, count);
}

void SampledBrdf::pdf(const DirectionPairs<double>& pairs, double* density) const { sampler_.pdf(pairs, density); }

BrdfPointer withSampler(BrdfPointer brdf, const SamplerOptions& options) {
  if (dynamic_cast<const SampledBrdf*>(brdf.get()) != nullptr) return brdf;
  const auto sampled = std::make_shared<const SampledBrdf>(brdf, TabulatedSampler(*brdf, options));
  const DirectionSampler samplers[] = {samplerOf(*brdf), samplerOf(*sampled)};
  double excess = 0;
  constexpr double angles[] = {10, 30, 50, 70, 85};  // degrees
  for (const double angle : angles) {
    const auto found = relativeVariances(*brdf, fromSpherical(radians(angle), 0.7), samplers, 4096).relativeVariance;
    excess += (found[0] - found[1]) / std::size(angles);
  }
  if (excess <= options.tolerance) return brdf;
  return sampled;
}

}  // namespace brdf
