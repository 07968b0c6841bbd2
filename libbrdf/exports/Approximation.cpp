#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/exports/Approximation.h>
#include <brdf/fit/FitData.h>
#include <brdf/fit/LobeRequests.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/SampleSet.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

// About highlights; and over the hemispheres, the larger part, which decides where lobes are wide.
constexpr std::size_t kThetaH = 32, kThetaD = 16, kPhiD = 16, kHighlight = kThetaH * kThetaD * kPhiD;
constexpr std::size_t kCosines = 20, kAzimuths = 40;
constexpr std::size_t kBlock = 4096;
/// A lobe whose largest scale factor is below this part of the sum of all lobes' is left out.
constexpr double kNothing = 1e-9;

double middle(std::size_t index, std::size_t n) { return (static_cast<double>(index) + 0.5) / static_cast<double>(n); }

/// Both directions of a pair are turned by the golden angle from pair to pair, to cover what depends on the tangent.
DirectionPair exportPair(std::size_t i) {
  const double turn = std::remainder(static_cast<double>(i) * kPi * (3 - std::sqrt(5.0)), 2 * kPi);
  if (i < kHighlight) {
    const double t = middle(i / (kThetaD * kPhiD), kThetaH);
    return fromHalfDifference({kPi / 2 * t * t * t * t, turn, kPi / 2 * middle(i / kPhiD % kThetaD, kThetaD),
                               2 * kPi * middle(i % kPhiD, kPhiD) - kPi});
  }
  i -= kHighlight;
  return {fromSpherical(std::acos(middle(i / (kCosines * kAzimuths), kCosines)), turn),
          fromSpherical(std::acos(middle(i / kAzimuths % kCosines, kCosines)),
                        turn + 2 * kPi * middle(i % kAzimuths, kAzimuths))};
}

class ExportPairs : public SampleSet {
 public:
  explicit ExportPairs(BrdfPointer source) : source_(std::move(source)) {}
  std::size_t count() const override { return kHighlight + kCosines * kCosines * kAzimuths; }
  const Channels& channels() const override { return source_->channels(); }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    DirectionPairBuffer<double> made(length);
    std::vector<std::uint8_t> above(length);
    for (std::size_t k = 0; k < length; ++k) {
      const DirectionPair pair = exportPair(first + k);
      made.set(k, pair.wi, pair.wo);
      above[k] = pair.wi[2] > 0 && pair.wo[2] > 0;
    }
    if (values) {
      std::vector<std::uint8_t> known(length);
      source_->evaluate(made.view(), values, known.data());
      for (std::size_t k = 0; k < length; ++k) above[k] = above[k] && known[k];
    }
    if (valid) std::ranges::copy(above, valid);
    if (pairs) *pairs = std::move(made);
  }

 private:
  BrdfPointer source_;
};

/// A BRDF with samples of its own values.
class Sampled : public Brdf {
 public:
  explicit Sampled(BrdfPointer source) : source_(std::move(source)), samples_(source_) {}
  const Channels& channels() const override { return source_->channels(); }
  Symmetry symmetry() const override { return source_->symmetry(); }
  bool reciprocal() const override { return source_->reciprocal(); }
  std::string description() const override { return source_->description(); }
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override {
    source_->evaluate(pairs, values, valid);
  }
  using Brdf::evaluate;
  const SampleSet* samples() const override { return &samples_; }

 private:
  BrdfPointer source_;
  ExportPairs samples_;
};

/// Without lobes that add nothing, and with one value where all channels have the same.
std::shared_ptr<const LobeSum> simplified(const LobeSum& sum) {
  double total = 0;
  for (const Lobe& lobe : sum.lobes()) total += largestScale(lobe);
  std::vector<Lobe> kept;
  for (Lobe lobe : sum.lobes()) {
    if (largestScale(lobe) <= kNothing * total) continue;
    for (std::vector<double>& values : lobe.parameters)
      if (sameInAllChannels(values)) values.resize(1);
    if (sameInAllChannels(lobe.scale)) lobe.scale.resize(1);
    kept.push_back(std::move(lobe));
  }
  if (kept.empty()) kept.push_back(sum.lobes().front());
  return std::make_shared<LobeSum>(std::move(kept), sum.channels());
}

std::vector<LobeRequest> requestsFor(std::string_view lobes, const std::vector<std::string>& hold) {
  std::vector<LobeRequest> requests = parseLobeRequests(lobes);
  for (const std::string& item : hold) holdParameter(requests, item);
  return requests;
}

}  // namespace

BrdfPointer sampledForExport(BrdfPointer material) {
  if (material->samples()) return material;
  return std::make_shared<Sampled>(std::move(material));
}

std::shared_ptr<const LobeSum> fitLobes(const Brdf& target, std::string_view lobes, const FitOptions& options,
                                        const std::vector<std::string>& hold) {
  return simplified(*fit(target, requestsFor(lobes, hold), options).material);
}

std::shared_ptr<const LobeSum> fitColours(const Brdf& target, std::string_view lobes, const FitOptions& options,
                                          const std::vector<std::string>& colours,
                                          const std::vector<std::string>& hold) {
  if (target.channels().count() == 1) return fitLobes(target, lobes, options, hold);
  FitOptions grey = options;
  grey.channels.kind = FitChannels::Kind::Luminance;
  const FitReport first = fit(target, requestsFor(lobes, hold), grey);
  std::vector<LobeRequest> requests = requestsFor(lobes, hold);
  for (std::size_t l = 0; l < requests.size(); ++l) {
    const Model& model = *requests[l].model;
    for (std::size_t p = 0; p < model.parameters().size(); ++p) {
      const std::string& name = model.parameters()[p].name;
      const double value = first.material->lobes()[l].parametersOf(0)[p];
      const bool colour = std::ranges::find(colours, model.name() + "." + name) != colours.end();
      (colour ? requests[l].start : requests[l].fixed).try_emplace(name, value);
    }
  }
  FitOptions each = options;
  each.combination = Combination::PerChannel;
  return simplified(*fit(target, requests, each).material);
}

std::shared_ptr<const LobeSum> nearest(const Brdf& target, const FitOptions& options,
                                       const std::vector<std::shared_ptr<const LobeSum>>& candidates) {
  std::shared_ptr<const LobeSum> best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& candidate : candidates) {
    if (!candidate) continue;
    const double error = compare(*candidate, target, options.maximumTheta, options.metric).metrics.at(options.metric);
    if (!best || error < least) best = candidate, least = error;
  }
  return best;
}

ExportError exportError(const LobeSum& evaluated, const Brdf& material, double maximumTheta) {
  ExportError error;
  error.comparison = compare(evaluated, material, maximumTheta);
  const BrdfPointer sampled = sampledForExport(BrdfPointer(BrdfPointer(), &material));
  const SampleSet& samples = *sampled->samples();
  const std::size_t channels = evaluated.channels().count();
  const double minimum = minimumCosine(maximumTheta);
  for (std::size_t first = 0; first < samples.count(); first += kBlock) {
    const std::size_t length = std::min(kBlock, samples.count() - first);
    DirectionPairBuffer<double> pairs;
    std::vector<double> wanted(channels * length), got(channels * length);
    std::vector<std::uint8_t> valid(length);
    samples.read(first, length, &pairs, wanted.data(), valid.data());
    evaluated.evaluate(pairs.view(), got.data(), nullptr);
    for (std::size_t k = 0; k < length; ++k) {
      if (!valid[k] || pairs.wi[2][k] < minimum || pairs.wo[2][k] < minimum) continue;
      for (std::size_t c = 0; c < channels; ++c) {
        const double a = got[c * length + k], b = wanted[c * length + k];
        if (std::abs(a - b) <= error.worstDifference) continue;
        error.worstDifference = std::abs(a - b);
        error.worstEvaluated = a;
        error.worstMaterial = b;
        error.wi = {pairs.wi[0][k], pairs.wi[1][k], pairs.wi[2][k]};
        error.wo = {pairs.wo[0][k], pairs.wo[1][k], pairs.wo[2][k]};
      }
    }
  }
  return error;
}

double parameterOf(const Lobe& lobe, std::string_view name, std::size_t channel) {
  const std::vector<double>& values = lobe.parameters[lobe.model->parameterIndex(name)];
  return values.size() == 1 ? values[0] : values[channel];
}

bool sameInAllChannels(const std::vector<double>& values) {
  return std::ranges::all_of(values, [&](double v) { return v == values[0]; });
}

double largestScale(const Lobe& lobe) { return *std::ranges::max_element(lobe.scale); }

std::string differsBetweenChannels(const Lobe& lobe, const std::vector<std::string_view>& colours) {
  for (std::size_t p = 0; p < lobe.parameters.size(); ++p) {
    const std::string& name = lobe.model->parameters()[p].name;
    if (!sameInAllChannels(lobe.parameters[p]) && std::ranges::find(colours, name) == colours.end())
      return name + " of " + lobe.model->name() + " differs between the channels";
  }
  return {};
}

std::array<double, 3> colourOf(const std::vector<double>& values) {
  return values.size() == 3 ? std::array<double, 3>{values[0], values[1], values[2]}
                            : std::array<double, 3>{values[0], values[0], values[0]};
}

std::string colourText(const std::array<double, 3>& colour, std::string_view separator) {
  return formatNumber(colour[0]) + std::string(separator) + formatNumber(colour[1]) + std::string(separator) +
         formatNumber(colour[2]);
}

std::shared_ptr<const LobeSum> withScaleAtMost(const LobeSum& sum, std::string_view model, double maximum) {
  std::vector<Lobe> lobes = sum.lobes();
  for (Lobe& lobe : lobes)
    if (lobe.model->name() == model)
      for (double& scale : lobe.scale) scale = std::min(scale, maximum);
  return std::make_shared<LobeSum>(std::move(lobes), sum.channels());
}

}  // namespace brdf
