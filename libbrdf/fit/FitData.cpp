#include <brdf/base/Parallel.h>
#include <brdf/fit/FitData.h>
#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// A well-mixed 64-bit value of a counter (Steele, Lea, Flood 2014, "Fast Splittable Pseudorandom Number Generators").
std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

double minimumCosine(double maximumTheta) { return maximumTheta >= 90 ? 0 : std::cos(radians(maximumTheta)) - 1e-12; }

std::size_t packValid(DirectionPairBuffer<double>& pairs, double* values, std::size_t channels,
                      const std::uint8_t* valid, double minimum) {
  const std::size_t length = pairs.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < length; ++i) {
    const double ci = pairs.wi[2][i], co = pairs.wo[2][i];
    if (!valid[i] || !(ci > 0 && co > 0 && ci >= minimum && co >= minimum)) continue;
    if (kept != i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        pairs.wi[axis][kept] = pairs.wi[axis][i];
        pairs.wo[axis][kept] = pairs.wo[axis][i];
      }
      for (std::size_t channel = 0; channel < channels; ++channel)
        values[channel * length + kept] = values[channel * length + i];
    }
    ++kept;
  }
  return kept;
}

FitData FitData::read(const SampleSet& set, const Metric& metric, double maximumTheta) {
  FitData data;
  data.metric = &metric;
  data.channels = set.channels().count();
  const std::size_t count = set.count();
  data.chunks.resize((count + kChunkLength - 1) / kChunkLength);
  const double minimum = minimumCosine(maximumTheta);
  parallelFor(count, kChunkLength, [&](std::size_t first, std::size_t last) {
    const std::size_t length = last - first;
    FitChunk& chunk = data.chunks[first / kChunkLength];
    DirectionPairBuffer<double> pairs(length);
    std::vector<double> values(data.channels * length);
    std::vector<std::uint8_t> valid(length);
    set.read(first, length, &pairs, values.data(), valid.data());
    const std::size_t kept = packValid(pairs, values.data(), data.channels, valid.data(), minimum);
    chunk.pairs.resize(kept);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::copy_n(pairs.wi[axis].data(), kept, chunk.pairs.wi[axis].data());
      std::copy_n(pairs.wo[axis].data(), kept, chunk.pairs.wo[axis].data());
    }
    chunk.target.resize(data.channels * kept);
    for (std::size_t channel = 0; channel < data.channels; ++channel)
      metric.transform(values.data() + channel * length, pairs.wi[2].data(), kept,
                       chunk.target.data() + channel * kept);
  });
  std::erase_if(data.chunks, [](const FitChunk& chunk) { return chunk.pairs.size() == 0; });
  for (const FitChunk& chunk : data.chunks) data.samples += chunk.pairs.size();
  return data;
}

FitData FitData::subset(std::size_t count) const {
  FitData data;
  data.metric = metric;
  data.channels = channels;
  data.samples = std::min(count, samples);
  std::vector<std::size_t> picks(data.samples);
  for (std::size_t k = 0; k < data.samples; ++k) {
    const std::size_t first = k * samples / data.samples, last = (k + 1) * samples / data.samples;
    picks[k] = first + mixed(k) % (last - first);
  }
  std::size_t chunkIndex = 0, chunkFirst = 0;
  for (std::size_t start = 0; start < data.samples; start += kChunkLength) {
    const std::size_t length = std::min(kChunkLength, data.samples - start);
    FitChunk& out = data.chunks.emplace_back();
    out.pairs.resize(length);
    out.target.resize(channels * length);
    for (std::size_t k = 0; k < length; ++k) {
      const std::size_t pick = picks[start + k];
      while (pick >= chunkFirst + chunks[chunkIndex].pairs.size()) chunkFirst += chunks[chunkIndex++].pairs.size();
      const FitChunk& in = chunks[chunkIndex];
      const std::size_t i = pick - chunkFirst, inLength = in.pairs.size();
      out.pairs.set(k, {in.pairs.wi[0][i], in.pairs.wi[1][i], in.pairs.wi[2][i]},
                    {in.pairs.wo[0][i], in.pairs.wo[1][i], in.pairs.wo[2][i]});
      for (std::size_t channel = 0; channel < channels; ++channel)
        out.target[channel * length + k] = in.target[channel * inLength + i];
    }
  }
  return data;
}

FitData FitData::mean(std::size_t first, std::size_t count) const {
  FitData data;
  data.metric = metric;
  data.samples = samples;
  data.channels = 1;
  std::vector<double> values;
  for (const FitChunk& in : chunks) {
    const std::size_t length = in.pairs.size();
    FitChunk& out = data.chunks.emplace_back(FitChunk{in.pairs, std::vector<double>(length)});
    values.assign(length, 0.0);
    for (std::size_t channel = first; channel < first + count; ++channel) {
      metric->inverse(in.target.data() + channel * length, in.pairs.wi[2].data(), length, out.target.data());
      for (std::size_t i = 0; i < length; ++i) values[i] += out.target[i] / static_cast<double>(count);
    }
    metric->transform(values.data(), in.pairs.wi[2].data(), length, out.target.data());
  }
  return data;
}

}  // namespace brdf
