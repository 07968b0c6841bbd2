#pragma once
#include <brdf/fit/Metric.h>
#include <brdf/fit/Samples.h>
#include <brdf/geometry/DirectionPairs.h>

#include <vector>

namespace brdf {

/// Up to kChunkLength valid samples, packed: the unit of parallel work and of summation order.
struct FitChunk {
  DirectionPairBuffer<double> pairs;
  /// Planar, channel c of sample i at target[c * pairs.size() + i]: as the metric prepares it, and for quadratic
  /// metrics times the factor, so that a residual is factor f - target.
  std::vector<double> target;
  /// Square roots of weights: one a sample, or planar by channel (FitData::weightsByChannel). Empty: all 1.
  std::vector<double> weight;
  /// Quadratic metrics: the slope of the residual, weight included; one plane, or one a channel where the metric weighs
  /// by the target, or weights are a channel's. Empty: all 1.
  std::vector<double> factor;
  /// Pictures (FitData::pairsAResidual above 1): what each pair adds to its pixel, as a multiple of f; planar by
  /// channel.
  std::vector<double> light;
};

/// Samples of one chunk in one channel: what their residuals are made of.
struct BRDF_EXPORT ResidualBlock {
  const Metric* metric;
  DirectionPairs<double> pairs;  ///< of a picture only their count, that of the pixels
  const double* target;
  const double* weight;  ///< or null: 1
  const double* factor;  ///< or null: 1

  /// Weighted residuals of the values f (1/sr), and their derivative with respect to f.
  void residual(const double* f, double* r) const;
  void slope(const double* f, double* slope) const;
  /// The target's values, 1/sr.
  void values(double* f) const;
};

/// The valid samples of a target, in the metric's own values. Chunks are summed in their order, so that no result
/// depends on the number of threads.
struct BRDF_EXPORT FitData {
  static constexpr std::size_t kChunkLength = 8192;
  /// Pairs that a cost function evaluates at a time; a multiple of pairsAResidual, and a part of kChunkLength.
  static constexpr std::size_t kBlockLength = 512;

  MetricPointer metric;
  std::vector<FitChunk> chunks;
  std::size_t samples = 0;
  std::size_t channels = 0;
  /// The squared error of a fit is the sum of squared residuals over this and the number of channels.
  double totalWeight = 0;
  double weightFactor = 1;  ///< what the set's weights were multiplied by
  /// 1, or in pictures the light directions of a pixel: so many pairs after one another make one residual, that of the
  /// sum of f times FitChunk::light.
  std::size_t pairsAResidual = 1;

  std::size_t residuals(const FitChunk& chunk) const { return chunk.pairs.size() / pairsAResidual; }

  /// Reads what is valid within the rule. A metric that takes its scale from the data is given it. Throws
  /// Error::Kind::Value when the set has no weights to go by, and where the metric has no finite value at a sample.
  static FitData read(const SampleSet& set, MetricPointer metric, const SampleRule& rule);

  /// Residuals first .. first + count - 1 of a chunk in a channel.
  ResidualBlock block(const FitChunk& chunk, std::size_t channel, std::size_t first, std::size_t count) const;
  ResidualBlock block(const FitChunk& chunk, std::size_t channel) const {
    return block(chunk, channel, 0, residuals(chunk));
  }
  bool weightsByChannel = false;
  /// Whether each channel has factors of its own.
  bool factorsByChannel() const { return channels > 1 && (weightsByChannel || metric->weighsByTarget()); }
  /// Sum over the samples of the mean over channels of their weights.
  double weightSum() const;

  /// About `count` of the samples, one from each of `count` equal runs, at a fixed pseudo-random place in its run: a
  /// regular stride would see only some columns of a table.
  FitData subset(std::size_t count) const;

  /// The samples whose entry in `parts` (one a sample, in order) is `part`, or those whose entry is not.
  FitData select(const std::vector<std::uint8_t>& parts, std::uint8_t part, bool inside) const;

  /// The same samples with one channel: the mean of f over channels first .. first + count - 1.
  FitData mean(std::size_t first, std::size_t count) const;
};

}  // namespace brdf
