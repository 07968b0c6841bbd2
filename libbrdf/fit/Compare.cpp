#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/fit/Compare.h>
#include <brdf/fit/FitData.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/SampleSet.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// Pairs of directions over both hemispheres, in equal solid angles: midpoints in cos theta and in azimuth. Anisotropic
/// ones are covered by turning the incident azimuth by the golden angle from pair to pair.
class HemispherePairs : public SampleSet {
 public:
  explicit HemispherePairs(Channels channels) : channels_(std::move(channels)) {}
  std::size_t count() const override { return kCosines * kCosines * kAzimuths; }
  const Channels& channels() const override { return channels_; }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    if (pairs) pairs->resize(length);
    for (std::size_t k = 0; k < length; ++k) {
      const std::size_t i = first + k;
      const auto middle = [](std::size_t index, std::size_t n) {
        return (static_cast<double>(index) + 0.5) / static_cast<double>(n);
      };
      const double ci = middle(i / (kCosines * kAzimuths), kCosines), co = middle(i / kAzimuths % kCosines, kCosines);
      const double turn = static_cast<double>(i) * kPi * (3 - std::sqrt(5.0));
      if (pairs)
        pairs->set(k, fromSpherical(std::acos(ci), turn),
                   fromSpherical(std::acos(co), turn + 2 * kPi * middle(i % kAzimuths, kAzimuths)));
      if (valid) valid[k] = 1;
    }
    if (values) std::fill_n(values, channels_.count() * length, 0.0);
  }
  static constexpr std::size_t kCosines = 48, kAzimuths = 96;

 private:
  Channels channels_;
};

/// For each metric: sum of squares of g(a) - g(b), and of g(b).
struct MetricSums {
  std::vector<double> difference, zero;
  std::size_t samples = 0;
};

MetricSums sumBlock(const SampleSet& samples, std::size_t first, std::size_t last, const Brdf& a, const Brdf* b,
                    double minimum) {
  const std::size_t channels = samples.channels().count();
  std::size_t length = last - first;
  DirectionPairBuffer<double> pairs;
  std::vector<double> valuesB(channels * length), valuesA(channels * length);
  std::vector<std::uint8_t> valid(length), validEvaluated(length);
  samples.read(first, length, &pairs, valuesB.data(), valid.data());
  const auto alsoValid = [&] {
    for (std::size_t i = 0; i < length; ++i) valid[i] = valid[i] && validEvaluated[i];
  };
  a.evaluate(pairs.view(), valuesA.data(), validEvaluated.data());
  alsoValid();
  if (b) {
    b->evaluate(pairs.view(), valuesB.data(), validEvaluated.data());
    alsoValid();
  }
  // Both sets of values are packed together, as planes of one array.
  std::vector<double> both(2 * channels * length);
  std::ranges::copy(valuesA, both.begin());
  std::ranges::copy(valuesB, both.begin() + static_cast<std::ptrdiff_t>(channels * length));
  const std::size_t kept = packValid(pairs, both.data(), 2 * channels, valid.data(), minimum);

  MetricSums sums;
  sums.samples = kept;
  std::vector<double> ga(kept), gb(kept);
  for (const Metric& metric : allMetrics()) {
    double difference = 0, zero = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      metric.transform(both.data() + c * length, pairs.wi[2].data(), kept, ga.data());
      metric.transform(both.data() + (channels + c) * length, pairs.wi[2].data(), kept, gb.data());
      for (std::size_t i = 0; i < kept; ++i) {
        difference += (ga[i] - gb[i]) * (ga[i] - gb[i]);
        zero += gb[i] * gb[i];
      }
    }
    sums.difference.push_back(difference);
    sums.zero.push_back(zero);
  }
  return sums;
}

BrdfPointer borrowed(const Brdf& brdf) { return BrdfPointer(BrdfPointer(), &brdf); }

}  // namespace

Comparison compareOn(const SampleSet& samples, const Brdf& a, const Brdf* b, double maximumTheta) {
  const std::size_t grain = 2048, count = samples.count();
  const double minimum = minimumCosine(maximumTheta);
  std::vector<MetricSums> parts((count + grain - 1) / grain);
  parallelFor(count, grain, [&](std::size_t first, std::size_t last) {
    parts[first / grain] = sumBlock(samples, first, last, a, b, minimum);
  });
  Comparison comparison;
  comparison.channels = samples.channels().count();
  for (const MetricSums& part : parts) comparison.samples += part.samples;
  if (comparison.samples == 0)
    throw Error(Error::Kind::Value, {"no valid sample to compare on", a.description(), "0", "at least 1"});
  const double n = static_cast<double>(comparison.samples) * static_cast<double>(comparison.channels);
  for (std::size_t m = 0; m < allMetrics().size(); ++m) {
    double difference = 0, zero = 0;
    for (const MetricSums& part : parts) {
      difference += part.difference[m];
      zero += part.zero[m];
    }
    const std::string name(allMetrics()[m].name);
    comparison.metrics[name] = std::sqrt(difference / n);
    comparison.zeroModel[name] = std::sqrt(zero / n);
  }
  return comparison;
}

Comparison compare(const Brdf& a, const Brdf& b, double maximumTheta) {
  BrdfPointer first = borrowed(a), second = borrowed(b);
  if (first->channels() != second->channels()) {
    // The common view: luminance when either has one channel, else colour.
    const bool luminance = first->channels().count() == 1 || second->channels().count() == 1;
    first = luminance ? asLuminance(first) : asRgb(first);
    second = luminance ? asLuminance(second) : asRgb(second);
  }
  if (const SampleSet* samples = second->samples()) {
    Comparison comparison = compareOn(*samples, *first, nullptr, maximumTheta);
    comparison.sampling = "the samples of the second, " + second->description();
    return comparison;
  }
  if (const SampleSet* samples = first->samples()) {
    Comparison comparison = compareOn(*samples, *first, second.get(), maximumTheta);
    comparison.sampling = "the samples of the first, " + first->description();
    return comparison;
  }
  const HemispherePairs pairs(first->channels());
  Comparison comparison = compareOn(pairs, *first, second.get(), maximumTheta);
  comparison.sampling = std::to_string(HemispherePairs::kCosines) + " x " + std::to_string(HemispherePairs::kCosines) +
                        " x " + std::to_string(HemispherePairs::kAzimuths) +
                        " pairs of directions in equal solid angles of both hemispheres";
  return comparison;
}

}  // namespace brdf
