#pragma once
#include <brdf/material/Brdf.h>
#include <brdf/material/SampleSet.h>

#include <optional>
#include <vector>

namespace brdf {

/// Which samples of a set count, and how much.
struct SampleRule {
  double maximumTheta = 90;  ///< degrees; samples with theta_i or theta_o above are left out
  bool solidAngles = false;  ///< each counts by SampleSet::solidAngles(), else all alike
  bool noise = false;        ///< each value, of a sample and channel, counts by 1 / variance instead
  /// What the weights add up to where the set knows it better than its samples (importance sampling); else the weights
  /// are scaled to add up to the number of samples.
  std::optional<double> totalWeight;
};

enum class SampleWeights {
  None,
  SolidAngle,  ///< SampleSet::solidAngles(): one a sample
  Noise        ///< 1 / SampleSet::standardErrors()^2: one a sample and channel
};

/// Some samples of a set: the valid ones within the limit, packed.
struct SampleBlock {
  DirectionPairBuffer<double> pairs;  ///< `count` of them, and unused space
  std::vector<double> values;         ///< planar: channel c of sample i at values[c * stride + i], 1/sr
  std::vector<double> weights;  ///< SampleWeights: one a sample, or planar as `values`; empty when all count alike
  std::size_t count = 0, stride = 0;

  DirectionPairs<double> view() const { return pairs.view().slice(0, count); }
};

/// Samples first .. first + length - 1. With weights; throws Error::Kind::Value when the set has none.
/// `other`, where given, is evaluated at the same pairs: its values are in the planes after the set's own, and samples
/// where it is invalid are left out.
BRDF_EXPORT SampleBlock readSamples(const SampleSet& set, std::size_t first, std::size_t length, double maximumTheta,
                                    SampleWeights weights, std::initializer_list<const Brdf*> others = {});

/// The median of |f| (1/sr) over valid samples and channels of the set, or of `b` at its pairs where given: of at most
/// 65536 samples, in runs spread over the set. Where it is 0 the mean, and 1 where that is 0 too.
double typicalValue(const SampleSet& set, const Brdf* b, double maximumTheta);

/// A well-mixed 64-bit value of a counter (Steele, Lea, Flood 2014, "Fast Splittable Pseudorandom Number Generators").
std::uint64_t mixedBits(std::uint64_t counter);

/// What a rule's samples are read with.
inline SampleWeights weightsOf(const SampleRule& rule) {
  return rule.noise ? SampleWeights::Noise : rule.solidAngles ? SampleWeights::SolidAngle : SampleWeights::None;
}

/// The least cosine that `maximumTheta` degrees allows, with a little slack for directions computed from angles.
double minimumCosine(double maximumTheta);

}  // namespace brdf
