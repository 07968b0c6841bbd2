#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/fit/Samples.h>
#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr std::size_t kRuns = 1024, kRunLength = 64;  // of typicalValue

/// Keeps of `length` samples those marked valid with both cosines at least `minimum` (and > 0), closing the gaps.
std::size_t packValid(SampleBlock& block, std::size_t planes, const std::uint8_t* valid, double minimum) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < block.stride; ++i) {
    const double ci = block.pairs.wi[2][i], co = block.pairs.wo[2][i];
    if (!valid[i] || !(ci > 0 && co > 0 && ci >= minimum && co >= minimum)) continue;
    if (kept != i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        block.pairs.wi[axis][kept] = block.pairs.wi[axis][i];
        block.pairs.wo[axis][kept] = block.pairs.wo[axis][i];
      }
      for (std::size_t plane = 0; plane < planes; ++plane)
        block.values[plane * block.stride + kept] = block.values[plane * block.stride + i];
      for (std::size_t plane = 0; plane < block.weights.size(); plane += block.stride)
        block.weights[plane + kept] = block.weights[plane + i];
    }
    ++kept;
  }
  return kept;
}

}  // namespace

std::uint64_t mixedBits(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double minimumCosine(double maximumTheta) { return maximumTheta >= 90 ? 0 : std::cos(radians(maximumTheta)) - 1e-12; }

SampleBlock readSamples(const SampleSet& set, std::size_t first, std::size_t length, double maximumTheta,
                        SampleWeights weights, std::initializer_list<const Brdf*> others) {
  const std::size_t channels = set.channels().count();
  SampleBlock block;
  block.stride = length;
  block.pairs.resize(length);
  block.values.resize((1 + others.size()) * channels * length);
  std::vector<std::uint8_t> valid(length), otherValid(others.size() > 0 ? length : 0);
  set.read(first, length, &block.pairs, block.values.data(), valid.data());
  std::size_t plane = channels;
  for (const Brdf* other : others) {
    other->evaluate(block.pairs.view(), block.values.data() + plane * length, otherValid.data());
    for (std::size_t i = 0; i < length; ++i) valid[i] = valid[i] && otherValid[i];
    plane += channels;
  }
  if (weights == SampleWeights::Noise) {
    block.weights.resize(channels * length);
    if (!set.standardErrors(first, length, block.weights.data()))
      throw Error(Error::Kind::Value, {"samples without standard errors cannot be weighted by noise", "samples", "",
                                       "a table with standard errors, such as a simulated one"});
    // Where no error is known the set calls the sample invalid.
    for (double& weight : block.weights) weight = weight > 0 ? 1 / (weight * weight) : 0;
  } else if (weights == SampleWeights::SolidAngle) {
    block.weights.resize(length);
    if (!set.solidAngles(first, length, block.weights.data()))
      throw Error(Error::Kind::Value, {"scattered samples have no cells, so no solid angles to weight them by",
                                       "samples", "", "a table or grid, or samples of a hemisphere quadrature"});
  }
  block.count = packValid(block, plane, valid.data(), minimumCosine(maximumTheta));
  return block;
}

double typicalValue(const SampleSet& set, const Brdf* b, double maximumTheta) {
  const std::size_t count = set.count(), channels = set.channels().count();
  const std::size_t runs = std::min(kRuns, (count + kRunLength - 1) / kRunLength);
  std::vector<std::vector<double>> parts(runs);
  parallelFor(runs, 16, [&](std::size_t firstRun, std::size_t lastRun) {
    for (std::size_t k = firstRun; k < lastRun; ++k) {
      const std::size_t begin = k * count / runs, end = (k + 1) * count / runs;
      const std::size_t length = std::min(kRunLength, end - begin);
      const std::size_t first = begin + mixedBits(k) % (end - begin - length + 1);
      SampleBlock block = b ? readSamples(set, first, length, maximumTheta, SampleWeights::None, {b})
                            : readSamples(set, first, length, maximumTheta, SampleWeights::None);
      for (std::size_t c = 0; c < channels; ++c) {
        const double* values = block.values.data() + (c + (b ? channels : 0)) * block.stride;
        for (std::size_t i = 0; i < block.count; ++i) parts[k].push_back(std::abs(values[i]));
      }
    }
  });
  std::vector<double> values;
  for (const std::vector<double>& part : parts) values.insert(values.end(), part.begin(), part.end());
  if (values.empty()) return 1;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (*middle > 0) return *middle;
  double sum = 0;
  for (const double value : values) sum += value;
  return sum > 0 ? sum / static_cast<double>(values.size()) : 1;
}

}  // namespace brdf
