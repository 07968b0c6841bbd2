#pragma once
#include <brdf/fit/Metric.h>
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/material/SampleSet.h>

#include <vector>

namespace brdf {

/// Up to kChunkLength valid samples, packed: the unit of parallel work and of summation order.
struct FitChunk {
  DirectionPairBuffer<double> pairs;
  std::vector<double> target;  ///< g(f) by the metric, planar: channel c of sample i at target[c * pairs.size() + i]
};

/// The valid samples of a target, in the metric's own values. Chunks are summed in their order, so that no result
/// depends on the number of threads.
struct BRDF_EXPORT FitData {
  static constexpr std::size_t kChunkLength = 8192;

  const Metric* metric = nullptr;
  std::vector<FitChunk> chunks;
  std::size_t samples = 0;
  std::size_t channels = 0;

  /// Reads what is valid with theta_i and theta_o at most `maximumTheta` degrees (90: all above the horizon).
  static FitData read(const SampleSet& set, const Metric& metric, double maximumTheta);

  /// About `count` of the samples, one from each of `count` equal runs, at a fixed pseudo-random place in its run: a
  /// regular stride would see only some columns of a table.
  FitData subset(std::size_t count) const;

  /// The same samples with one channel: the mean of f over channels first .. first + count - 1.
  FitData mean(std::size_t first, std::size_t count) const;
};

/// Keeps of a block of samples those marked valid with both cosines at least `minimumCosine` (and > 0), closing the
/// gaps; `values` is planar with `channels` planes. Returns how many remain; the arrays are not shortened and the
/// planes keep their stride.
std::size_t packValid(DirectionPairBuffer<double>& pairs, double* values, std::size_t channels,
                      const std::uint8_t* valid, double minimumCosine);

/// The least cosine that `maximumTheta` degrees allows, with a little slack for directions computed from angles.
double minimumCosine(double maximumTheta);

}  // namespace brdf
