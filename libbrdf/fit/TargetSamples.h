#pragma once
#include <brdf/fit/Fit.h>
#include <brdf/fit/Samples.h>

#include <memory>
#include <string>

namespace brdf {

/// Samples of a BRDF, measured or taken, and how they count.
struct TargetSamples {
  const SampleSet* set = nullptr;         ///< the BRDF's own, or `made`
  std::shared_ptr<const SampleSet> made;  ///< what was taken
  SampleRule rule;
  std::string sampling;  ///< for people: which samples
  std::string weights;   ///< "none", "solid-angle", "noise" or "importance"
};

/// The samples that `choice` asks for; `brdf` must outlive them.
///
/// - All: the BRDF's own.
/// - Hemisphere: values at pairs of directions in equal solid angles of both hemispheres up to maximumTheta: midpoints
///   in the cosines and in the azimuth of wo from wi; anisotropic BRDFs are covered by turning the incident azimuth by
///   the golden angle from pair to pair. n x n x 2n pairs, n the nearest to what the number of samples asks for.
/// - Importance: draws; wo uniform in solid angle, wi half of the time likewise, half by the BRDF's own sampler
///   (sampling/SampledBrdf.h; the balance heuristic of Veach and Guibas 1995, doi:10.1145/218380.218498). Each counts
///   by 1 / density, which is at most 2, relative to uniform draws, so that the mean square is an unbiased estimate of
///   the mean over equal solid angles of both hemispheres. Draws beyond maximumTheta count nothing.
///
/// Noise weights are for All: fit/NoiseWeights.h.
///
/// Throws Error::Kind::Value for a number of samples out of bounds, a theta limit out of (0, 90], and for All where the
/// BRDF has no samples.
BRDF_EXPORT TargetSamples takeSamples(BrdfPointer brdf, const SampleChoice& choice, double maximumTheta);

}  // namespace brdf
