#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/base/Text.h>
#include <brdf/fit/FitData.h>
#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// Sets the target and the factors of a chunk whose pairs and weights are there.
void setTarget(const FitData& data, FitChunk& chunk, const double* values, std::size_t stride) {
  const Metric& metric = *data.metric;
  const std::size_t channels = data.channels, count = chunk.pairs.size();
  const DirectionPairs<double> pairs = chunk.pairs.view();
  chunk.target.resize(channels * count);
  for (std::size_t c = 0; c < channels; ++c)
    metric.prepare(values + c * stride, pairs, chunk.target.data() + c * count);
  if (!metric.quadratic()) return;
  const std::size_t planes = data.factorsByChannel() ? channels : 1;
  chunk.factor.resize(planes * count);
  for (std::size_t c = 0; c < planes; ++c) {
    double* factor = chunk.factor.data() + c * count;
    metric.slope(chunk.target.data() + c * count, chunk.target.data() + c * count, pairs, factor);
    if (!chunk.weight.empty())
      for (std::size_t i = 0; i < count; ++i) factor[i] *= chunk.weight[(data.weightsByChannel ? c * count : 0) + i];
  }
  if (std::ranges::all_of(chunk.factor, [](double factor) { return factor == 1; })) {
    chunk.factor = {};
    return;
  }
  for (std::size_t c = 0; c < channels; ++c)
    for (std::size_t i = 0; i < count; ++i)
      chunk.target[c * count + i] *= chunk.factor[(planes > 1 ? c * count : 0) + i];
}

/// Throws where the residual of a sample at its own value is not finite: a user's formula may have no value there.
void checkFinite(const FitData& data, const FitChunk& chunk) {
  const std::size_t count = chunk.pairs.size();
  std::vector<double> values(count), residuals(count);
  for (std::size_t c = 0; c < data.channels; ++c) {
    const ResidualBlock block = data.block(chunk, c);
    block.values(values.data());
    block.residual(values.data(), residuals.data());
    for (std::size_t i = 0; i < count; ++i)
      if (!std::isfinite(residuals[i]))
        throw Error(Error::Kind::Value,
                    {"the metric has no finite value at a sample of the target", data.metric->name(),
                     "f = " + formatNumber(values[i], 4) + "/sr at theta_i " +
                         formatNumber(degrees(std::acos(std::min(1.0, chunk.pairs.wi[2][i]))), 4) + " degrees",
                     "a formula that is finite at every target value, as with max(f, 0)"});
  }
}

}  // namespace

void ResidualBlock::residual(const double* f, double* r) const {
  if (metric->quadratic()) {
    if (factor)
      for (std::size_t i = 0; i < pairs.count; ++i) r[i] = factor[i] * f[i] - target[i];
    else
      for (std::size_t i = 0; i < pairs.count; ++i) r[i] = f[i] - target[i];
    return;
  }
  metric->residual(f, target, pairs, r);
  if (weight)
    for (std::size_t i = 0; i < pairs.count; ++i) r[i] *= weight[i];
}

void ResidualBlock::slope(const double* f, double* slope) const {
  if (metric->quadratic()) {
    if (factor)
      std::copy_n(factor, pairs.count, slope);
    else
      std::fill_n(slope, pairs.count, 1.0);
    return;
  }
  metric->slope(f, target, pairs, slope);
  if (weight)
    for (std::size_t i = 0; i < pairs.count; ++i) slope[i] *= weight[i];
}

void ResidualBlock::values(double* f) const {
  metric->restore(target, pairs, f);
  if (factor)
    for (std::size_t i = 0; i < pairs.count; ++i) f[i] = factor[i] != 0 ? f[i] / factor[i] : 0.0;
}

ResidualBlock FitData::block(const FitChunk& chunk, std::size_t channel, std::size_t first, std::size_t count) const {
  const std::size_t total = residuals(chunk);
  const auto plane = [&](const std::vector<double>& all, std::size_t index) {
    return all.empty() ? nullptr : all.data() + index * total + first;
  };
  return {metric.get(), chunk.pairs.view().slice(first, count), plane(chunk.target, channel),
          plane(chunk.weight, weightsByChannel ? channel : 0), plane(chunk.factor, factorsByChannel() ? channel : 0)};
}

FitData FitData::read(const SampleSet& set, MetricPointer metric, const SampleRule& rule) {
  if (metric->needsScale()) metric = metric->scaledTo(typicalValue(set, nullptr, rule.maximumTheta));
  FitData data;
  data.metric = std::move(metric);
  data.channels = set.channels().count();
  if (rule.noise && data.metric->bySolidAngle())
    throw Error(Error::Kind::Value, {"the metric weighs by solid angle, which excludes weights by noise", "metric",
                                     data.metric->name(), "a metric without weights, such as rms"});
  SampleWeights weights = weightsOf(rule);
  if (data.metric->bySolidAngle()) weights = SampleWeights::SolidAngle;
  const bool weighted = weights != SampleWeights::None;
  data.weightsByChannel = weights == SampleWeights::Noise;
  const std::size_t planes = data.weightsByChannel ? data.channels : 1;
  const std::size_t count = set.count();
  data.chunks.resize((count + kChunkLength - 1) / kChunkLength);
  std::vector<SampleBlock> blocks(weighted ? data.chunks.size() : 0);  // their weights are known when all are read
  const auto fill = [&](const SampleBlock& block, FitChunk& chunk, double weightFactor) {
    chunk.pairs.resize(block.count);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::copy_n(block.pairs.wi[axis].data(), block.count, chunk.pairs.wi[axis].data());
      std::copy_n(block.pairs.wo[axis].data(), block.count, chunk.pairs.wo[axis].data());
    }
    if (weighted) {
      chunk.weight.resize(planes * block.count);
      for (std::size_t plane = 0; plane < planes; ++plane)
        for (std::size_t i = 0; i < block.count; ++i)
          chunk.weight[plane * block.count + i] = std::sqrt(weightFactor * block.weights[plane * block.stride + i]);
    }
    setTarget(data, chunk, block.values.data(), block.stride);
    if (data.metric->partial()) checkFinite(data, chunk);
  };
  parallelFor(count, kChunkLength, [&](std::size_t first, std::size_t last) {
    SampleBlock block = readSamples(set, first, last - first, rule.maximumTheta, weights);
    if (weighted)
      blocks[first / kChunkLength] = std::move(block);
    else
      fill(block, data.chunks[first / kChunkLength], 1);
  });
  if (weighted) {
    double sum = 0;
    for (const SampleBlock& block : blocks) {
      data.samples += block.count;
      for (std::size_t plane = 0; plane < planes; ++plane)
        for (std::size_t i = 0; i < block.count; ++i) sum += block.weights[plane * block.stride + i];
    }
    const auto values = static_cast<double>(planes * data.samples);
    const double factor = rule.totalWeight || !(sum > 0) ? 1 : values / sum;
    data.weightFactor = factor;
    parallelFor(blocks.size(), 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        fill(blocks[k], data.chunks[k], factor);
        blocks[k] = {};
      }
    });
    data.samples = 0;
  }
  std::erase_if(data.chunks, [](const FitChunk& chunk) { return chunk.pairs.size() == 0; });
  for (const FitChunk& chunk : data.chunks) data.samples += chunk.pairs.size();
  data.totalWeight = rule.totalWeight.value_or(static_cast<double>(data.samples));
  return data;
}

double FitData::weightSum() const {
  double sum = 0;
  for (const FitChunk& chunk : chunks) {
    for (const double root : chunk.weight) sum += root * root / static_cast<double>(weightsByChannel ? channels : 1);
    if (chunk.weight.empty()) sum += static_cast<double>(chunk.pairs.size());
  }
  return sum;
}

FitData FitData::subset(std::size_t count) const {
  FitData data;
  data.metric = metric;
  data.channels = channels;
  data.weightsByChannel = weightsByChannel;
  data.samples = std::min(count, samples);
  data.totalWeight = samples > 0 ? totalWeight * static_cast<double>(data.samples) / static_cast<double>(samples) : 0;
  std::vector<std::size_t> picks(data.samples);
  for (std::size_t k = 0; k < data.samples; ++k) {
    const std::size_t first = k * samples / data.samples, last = (k + 1) * samples / data.samples;
    picks[k] = first + mixedBits(k) % (last - first);
  }
  // A chunk whose factors are all 1 has none, beside others that have.
  const std::size_t slopes = metric->quadratic() ? (factorsByChannel() ? channels : 1) : 0;
  const std::size_t weights = weightsByChannel ? channels : 1;
  const bool factors = std::ranges::any_of(chunks, [](const FitChunk& chunk) { return !chunk.factor.empty(); });
  const bool weighted = std::ranges::any_of(chunks, [](const FitChunk& chunk) { return !chunk.weight.empty(); });
  std::size_t chunkIndex = 0, chunkFirst = 0;
  for (std::size_t start = 0; start < data.samples; start += kChunkLength) {
    const std::size_t length = std::min(kChunkLength, data.samples - start);
    FitChunk& out = data.chunks.emplace_back();
    out.pairs.resize(length);
    out.target.resize(channels * length);
    if (weighted) out.weight.assign(weights * length, 1.0);
    if (factors) out.factor.assign(slopes * length, 1.0);
    for (std::size_t k = 0; k < length; ++k) {
      const std::size_t pick = picks[start + k];
      while (pick >= chunkFirst + chunks[chunkIndex].pairs.size()) chunkFirst += chunks[chunkIndex++].pairs.size();
      const FitChunk& in = chunks[chunkIndex];
      const std::size_t i = pick - chunkFirst, inLength = in.pairs.size();
      out.pairs.set(k, {in.pairs.wi[0][i], in.pairs.wi[1][i], in.pairs.wi[2][i]},
                    {in.pairs.wo[0][i], in.pairs.wo[1][i], in.pairs.wo[2][i]});
      for (std::size_t channel = 0; channel < channels; ++channel)
        out.target[channel * length + k] = in.target[channel * inLength + i];
      for (std::size_t plane = 0; plane * inLength < in.weight.size(); ++plane)
        out.weight[plane * length + k] = in.weight[plane * inLength + i];
      for (std::size_t plane = 0; plane * inLength < in.factor.size(); ++plane)
        out.factor[plane * length + k] = in.factor[plane * inLength + i];
    }
  }
  return data;
}

FitData FitData::select(const std::vector<std::uint8_t>& parts, std::uint8_t part, bool inside) const {
  FitData data;
  data.metric = metric;
  data.channels = channels;
  data.weightsByChannel = weightsByChannel;
  std::size_t first = 0;
  for (const FitChunk& in : chunks) {
    const std::size_t length = in.pairs.size();
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < length; ++i)
      if ((parts[first + i] == part) == inside) kept.push_back(i);
    first += length;
    if (kept.empty()) continue;
    const auto picked = [&](const std::vector<double>& planes) {
      std::vector<double> result;
      result.reserve(planes.size() / length * kept.size());
      for (std::size_t plane = 0; plane < planes.size(); plane += length)
        for (const std::size_t i : kept) result.push_back(planes[plane + i]);
      return result;
    };
    FitChunk& out = data.chunks.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      out.pairs.wi[axis] = picked(in.pairs.wi[axis]);
      out.pairs.wo[axis] = picked(in.pairs.wo[axis]);
    }
    out.target = picked(in.target);
    out.weight = picked(in.weight);
    out.factor = picked(in.factor);
    data.samples += kept.size();
  }
  data.totalWeight = samples > 0 ? totalWeight * static_cast<double>(data.samples) / static_cast<double>(samples) : 0;
  return data;
}

FitData FitData::mean(std::size_t first, std::size_t count) const {
  FitData data;
  data.metric = metric;
  data.samples = samples;
  data.channels = 1;
  data.totalWeight = totalWeight;
  std::vector<double> values, mean;
  for (const FitChunk& in : chunks) {
    const std::size_t length = in.pairs.size();
    FitChunk& out = data.chunks.emplace_back(FitChunk{in.pairs, {}, in.weight, {}, {}});
    if (weightsByChannel && !in.weight.empty()) {
      // Variances add up, and those of the mean's parts are divided by the square of their number.
      out.weight.assign(length, 0.0);
      for (std::size_t channel = first; channel < first + count; ++channel)
        for (std::size_t i = 0; i < length; ++i)
          out.weight[i] += 1 / (in.weight[channel * length + i] * in.weight[channel * length + i]);
      for (double& root : out.weight) root = std::sqrt(static_cast<double>(count) / root);
    }
    values.resize(length);
    mean.assign(length, 0.0);
    for (std::size_t channel = first; channel < first + count; ++channel) {
      block(in, channel).values(values.data());
      for (std::size_t i = 0; i < length; ++i) mean[i] += values[i] / static_cast<double>(count);
    }
    setTarget(data, out, mean.data(), length);
  }
  return data;
}

}  // namespace brdf
