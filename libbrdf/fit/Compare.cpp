#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/fit/Compare.h>
#include <brdf/fit/SpherePicture.h>
#include <brdf/fit/TargetSamples.h>
#include <brdf/material/ChannelView.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// For each metric: weighted sums of squared residuals of a, of 0, and of the weights.
struct MetricSums {
  std::vector<double> difference, zero;
  double weight = 0, solidAngle = 0;  ///< sums of the samples' weights, plain and by solid angle
  std::size_t samples = 0;
};

MetricSums sumBlock(const SampleBlock& block, std::size_t channels, std::size_t firstPlane,
                    const std::vector<MetricPointer>& metrics, bool allWeighted) {
  MetricSums sums;
  sums.samples = block.count;
  // Weights by noise have a plane a channel, of which the mean counts as the sample's.
  const std::size_t planes = block.weights.empty() ? 0 : block.weights.size() / block.stride;
  for (std::size_t plane = 0; plane < planes; ++plane)
    for (std::size_t i = 0; i < block.count; ++i)
      sums.solidAngle += block.weights[plane * block.stride + i] / static_cast<double>(planes);
  if (planes == 0) sums.solidAngle = static_cast<double>(block.count);
  sums.weight = allWeighted ? sums.solidAngle : static_cast<double>(block.count);
  const DirectionPairs<double> pairs = block.view();
  std::vector<double> target(block.count), residual(block.count), none(block.count);
  for (const MetricPointer& metric : metrics) {
    const bool weighted = planes > 0 && (allWeighted || metric->bySolidAngle());
    const auto squared = [&](const double* f, std::size_t channel) {
      const double* weights = weighted ? block.weights.data() + (planes > 1 ? channel * block.stride : 0) : nullptr;
      metric->residual(f, target.data(), pairs, residual.data());
      double sum = 0;
      for (std::size_t i = 0; i < block.count; ++i) sum += (weights ? weights[i] : 1) * residual[i] * residual[i];
      return sum;
    };
    double difference = 0, zero = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      // The planes: the set's own values, a's, b's where it has any; b's values are the last.
      metric->prepare(block.values.data() + (firstPlane + c) * block.stride, pairs, target.data());
      difference += squared(block.values.data() + (channels + c) * block.stride, c);
      zero += squared(none.data(), c);
    }
    sums.difference.push_back(difference);
    sums.zero.push_back(zero);
  }
  return sums;
}

BrdfPointer borrowed(const Brdf& brdf) { return BrdfPointer(BrdfPointer(), &brdf); }

}  // namespace

Comparison compareOn(const SampleSet& samples, const Brdf& a, const Brdf* b, const SampleRule& rule,
                     const MetricPointer& metric) {
  const std::size_t grain = 2048, count = samples.count(), channels = samples.channels().count();
  double unused = 0;
  const bool hasCells = count > 0 && samples.solidAngles(0, 1, &unused);
  std::vector<MetricPointer> metrics;
  for (MetricPointer one : allMetrics()) {
    if (one->bySolidAngle() && (!hasCells || rule.noise)) continue;
    if (metric && metric->name() == one->name()) one = metric;
    if (one->needsScale()) one = one->scaledTo(typicalValue(samples, b, rule.maximumTheta));
    metrics.push_back(std::move(one));
  }
  const auto known = [&](const MetricPointer& one) { return one->name() == metric->name(); };
  if (metric && std::ranges::none_of(metrics, known)) metrics.push_back(metric);

  const SampleWeights weights = rule.noise ? SampleWeights::Noise
                                : hasCells ? SampleWeights::SolidAngle
                                           : SampleWeights::None;
  std::vector<MetricSums> parts((count + grain - 1) / grain);
  parallelFor(count, grain, [&](std::size_t first, std::size_t last) {
    const SampleBlock block = b ? readSamples(samples, first, last - first, rule.maximumTheta, weights, {&a, b})
                                : readSamples(samples, first, last - first, rule.maximumTheta, weights, {&a});
    parts[first / grain] = sumBlock(block, channels, b ? 2 * channels : 0, metrics, rule.solidAngles || rule.noise);
  });
  Comparison comparison;
  comparison.channels = channels;
  double weight = 0, solidAngle = 0;
  for (const MetricSums& part : parts) {
    comparison.samples += part.samples;
    weight += part.weight;
    solidAngle += part.solidAngle;
  }
  if (comparison.samples == 0)
    throw Error(Error::Kind::Value, {"no valid sample to compare on", a.description(), "0", "at least 1"});
  for (std::size_t m = 0; m < metrics.size(); ++m) {
    double difference = 0, zero = 0;
    for (const MetricSums& part : parts) {
      difference += part.difference[m];
      zero += part.zero[m];
    }
    if (metrics[m]->partial() && !std::isfinite(difference + zero))
      throw Error(Error::Kind::Value, {"the metric has no finite value on these samples", metrics[m]->name(), "",
                                       "a formula that is finite at every value of both, as with max(f, 0)"});
    const double total = rule.totalWeight.value_or(metrics[m]->bySolidAngle() ? solidAngle : weight);
    const double n = total * static_cast<double>(channels);
    comparison.metrics[metrics[m]->name()] = std::sqrt(difference / n);
    comparison.zeroModel[metrics[m]->name()] = std::sqrt(zero / n);
    comparison.formulas[metrics[m]->name()] = metrics[m]->formula();
  }
  return comparison;
}

Comparison compare(const Brdf& a, const Brdf& b, double maximumTheta, std::string_view metricText,
                   const SampleChoice& choice) {
  const MetricPointer metric = metricText.empty() ? nullptr : findMetric(metricText);
  const auto onSphere = std::dynamic_pointer_cast<const SphereMetric>(metric);
  BrdfPointer first = borrowed(a), second = borrowed(b);
  if (first->channels() != second->channels()) {
    // The common view: luminance when either has one channel, else colour.
    const bool luminance = first->channels().count() == 1 || second->channels().count() == 1;
    first = luminance ? asLuminance(first) : asRgb(first);
    second = luminance ? asLuminance(second) : asRgb(second);
  }
  const bool onFirst = choice.sampling == Sampling::Automatic && !second->samples() && first->samples();
  const TargetSamples samples = takeSamples(onFirst ? first : second, choice, maximumTheta);
  Comparison comparison =
      compareOn(*samples.set, *first, onFirst ? second.get() : nullptr, samples.rule, onSphere ? nullptr : metric);
  comparison.sampling = samples.sampling;
  if (!samples.made)
    comparison.sampling = onFirst ? "the samples of the first, " + first->description()
                                  : "the samples of the second, " + second->description();
  if (samples.weights != "none") comparison.sampling += ", weighted by " + samples.weights;
  if (onSphere) {
    const SphereErrors errors = sphereErrors(spherePicture(*second, onSphere), *first);
    comparison.metrics[metric->name()] = errors.error;
    comparison.zeroModel[metric->name()] = errors.zeroModel;
    comparison.formulas[metric->name()] = metric->formula();
  }
  return comparison;
}

}  // namespace brdf
