#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>

#include <functional>
#include <span>
#include <vector>

namespace brdf {

class Model;
class TabulatedSampler;

/// A way to draw light directions, as Brdf::sample and Brdf::pdf.
struct DirectionSampler {
  std::function<void(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
                     const std::array<double*, 3>& wi, std::size_t count)>
      sample;
  std::function<void(const DirectionPairs<double>& pairs, double* density)> pdf;
};

/// A BRDF's own sampler; `brdf` must outlive it.
BRDF_EXPORT DirectionSampler samplerOf(const Brdf& brdf);
/// A tabulated one; `sampler` must outlive it.
BRDF_EXPORT DirectionSampler samplerOf(const TabulatedSampler& sampler);
/// A lobe's own; `model` and `parameters` must outlive it.
BRDF_EXPORT DirectionSampler samplerOf(const Model& model, std::span<const double> parameters);
/// Cosine-weighted, what Brdf does unless told otherwise.
BRDF_EXPORT DirectionSampler cosineSampler();

/// How well samplers match a BRDF for one viewer.
struct SamplerVariances {
  double albedo = 0;  ///< integral of f cos, f averaged over the channels
  /// For each sampler the variance of f cos / pdf over the albedo squared, 0 for a perfect match; a render of n samples
  /// has the relative error sqrt(variance / n). 0 where the albedo is 0; infinity where f cos > 0 and pdf = 0.
  std::vector<double> relativeVariance;
  /// For each sampler the largest f cos / pdf seen, over the albedo: the brightest firefly.
  std::vector<double> largestWeight;
};

/// Both moments are integrals over the hemisphere, estimated by `draws` draws of EACH sampler combined by the balance
/// heuristic: a sampler that never finds a peak is charged for it as soon as another one does. Fixed sequence, so that
/// the same call gives the same figures. Throws Error::Kind::Value without samplers.
BRDF_EXPORT SamplerVariances relativeVariances(const Brdf& brdf, const Direction& wo,
                                               std::span<const DirectionSampler> samplers, std::size_t draws);

/// A BRDF's own sampler beside the cosine's at one polar angle of the viewer.
struct Efficiency {
  Direction wo{};
  double albedo = 0;
  double relativeVariance = 0;        ///< of the BRDF's own sampler
  double largestWeight = 0;           ///< of the BRDF's own sampler, see SamplerVariances
  double cosineRelativeVariance = 0;  ///< of cosine-weighted sampling
};

struct EfficiencyOptions {
  std::size_t draws = 8192;  ///< of each sampler for each viewer
  double phi = 0.7;          ///< azimuth of the viewers, radians
};

/// One entry for each polar angle of the viewer (radians, below pi/2). Peaks that the BRDF's own sampler misses are
/// found by a TabulatedSampler made for the purpose.
BRDF_EXPORT std::vector<Efficiency> efficiency(const Brdf& brdf, std::span<const double> thetas,
                                               const EfficiencyOptions& options = {});

/// The channels' mean value of each pair, 0 where it is negative or no number: what samplers follow. `scratch` is
/// resized.
void meanValues(const Brdf& brdf, const DirectionPairs<double>& pairs, double* result, std::vector<double>& scratch);

}  // namespace brdf
