#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/base/Text.h>
#include <brdf/fit/NoiseWeights.h>
#include <brdf/fit/TargetSamples.h>
#include <brdf/geometry/Directions.h>
#include <brdf/sampling/SampledBrdf.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr std::size_t kHemisphereSide = 48;        // 48 x 48 x 96 pairs
constexpr std::size_t kImportanceDraws = 100'000;  // a standard error of well under 1 % of the mean square
constexpr std::size_t kMostSamples = 10'000'000;   // a gigabyte with their values

class HemispherePairs : public SampleSet {
 public:
  HemispherePairs(BrdfPointer brdf, std::size_t side, double lowestCosine)
      : brdf_(std::move(brdf)), side_(side), lowestCosine_(lowestCosine) {}
  std::size_t count() const override { return side_ * side_ * 2 * side_; }
  const Channels& channels() const override { return brdf_->channels(); }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    DirectionPairBuffer<double> made(length);
    const auto middle = [](std::size_t index, std::size_t n) {
      return (static_cast<double>(index) + 0.5) / static_cast<double>(n);
    };
    for (std::size_t k = 0; k < length; ++k) {
      const std::size_t i = first + k, azimuths = 2 * side_;
      const double ci = std::lerp(lowestCosine_, 1.0, middle(i / (side_ * azimuths), side_));
      const double co = std::lerp(lowestCosine_, 1.0, middle(i / azimuths % side_, side_));
      const double turn = static_cast<double>(i) * kPi * (3 - std::sqrt(5.0));
      made.set(k, fromSpherical(std::acos(ci), turn),
               fromSpherical(std::acos(co), turn + 2 * kPi * middle(i % azimuths, azimuths)));
    }
    if (values)
      brdf_->evaluate(made.view(), values, valid);
    else if (valid)
      std::fill_n(valid, length, std::uint8_t{1});
    if (pairs) *pairs = std::move(made);
  }
  bool solidAngles(std::size_t, std::size_t length, double* measures) const override {
    std::fill_n(measures, length, 1.0);
    return true;
  }

 private:
  BrdfPointer brdf_;
  std::size_t side_;
  double lowestCosine_;
};

/// Draws, made once.
class DrawnPairs : public SampleSet {
 public:
  DrawnPairs(const BrdfPointer& brdf, std::size_t draws, std::uint64_t seed, double lowestCosine)
      : channels_(brdf->channels()) {
    const BrdfPointer sampled = withSampler(brdf);
    const std::size_t grain = 4096, channels = channels_.count();
    std::vector<Part> parts((draws + grain - 1) / grain);
    parallelFor(draws, grain, [&](std::size_t first, std::size_t last) {
      parts[first / grain] = draw(*sampled, first, last - first, seed, lowestCosine);
    });
    std::size_t count = 0;
    for (const Part& part : parts) count += part.weights.size();
    pairs_.resize(count);
    values_.resize(channels * count);
    totalWeight_ = static_cast<double>(draws);
    std::size_t at = 0;
    for (const Part& part : parts) {
      const std::size_t n = part.weights.size();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::ranges::copy(part.pairs.wi[axis], pairs_.wi[axis].begin() + static_cast<std::ptrdiff_t>(at));
        std::ranges::copy(part.pairs.wo[axis], pairs_.wo[axis].begin() + static_cast<std::ptrdiff_t>(at));
      }
      for (std::size_t c = 0; c < channels; ++c)
        std::copy_n(part.values.data() + c * n, n, values_.data() + c * count + at);
      weights_.insert(weights_.end(), part.weights.begin(), part.weights.end());
      valid_.insert(valid_.end(), part.valid.begin(), part.valid.end());
      // Where the BRDF has no value the mean is over the rest.
      for (std::size_t i = 0; i < n; ++i)
        if (!part.valid[i]) totalWeight_ -= part.weights[i];
      at += n;
    }
  }
  double totalWeight() const { return totalWeight_; }

  std::size_t count() const override { return weights_.size(); }
  const Channels& channels() const override { return channels_; }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    if (pairs) {
      pairs->resize(length);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::copy_n(pairs_.wi[axis].data() + first, length, pairs->wi[axis].data());
        std::copy_n(pairs_.wo[axis].data() + first, length, pairs->wo[axis].data());
      }
    }
    for (std::size_t c = 0; values && c < channels_.count(); ++c)
      std::copy_n(values_.data() + c * count() + first, length, values + c * length);
    if (valid) std::copy_n(valid_.data() + first, length, valid);
  }
  bool solidAngles(std::size_t first, std::size_t length, double* measures) const override {
    std::copy_n(weights_.data() + first, length, measures);
    return true;
  }

 private:
  struct Part {
    DirectionPairBuffer<double> pairs;
    std::vector<double> values, weights;
    std::vector<std::uint8_t> valid;
  };

  static Part draw(const Brdf& brdf, std::size_t first, std::size_t length, std::uint64_t seed, double lowestCosine) {
    const auto random = [&](std::size_t k, std::uint64_t dimension) {
      const std::uint64_t stream = mixedBits(seed) + 8 * (first + k) + dimension;
      return static_cast<double>(mixedBits(stream) >> 11) * 0x1p-53;
    };
    const auto inCap = [&](double u, double v) {
      return fromSpherical(std::acos(std::lerp(lowestCosine, 1.0, u)), 2 * kPi * v);
    };
    DirectionPairBuffer<double> drawn(length);
    std::array<std::vector<double>, 2> u;
    for (std::size_t dimension = 0; dimension < 2; ++dimension)
      for (std::size_t k = 0; k < length; ++k) u[dimension].push_back(random(k, dimension));
    for (std::size_t k = 0; k < length; ++k) drawn.set(k, {}, inCap(random(k, 2), random(k, 3)));
    brdf.sample({drawn.wo[0].data(), drawn.wo[1].data(), drawn.wo[2].data()}, {u[0].data(), u[1].data()},
                {drawn.wi[0].data(), drawn.wi[1].data(), drawn.wi[2].data()}, length);
    Part part;
    for (std::size_t k = 0; k < length; ++k) {
      Direction wi{drawn.wi[0][k], drawn.wi[1][k], drawn.wi[2][k]};
      if (random(k, 4) < 0.5) wi = inCap(u[0][k], u[1][k]);
      if (wi[2] > 0 && wi[2] >= lowestCosine) part.pairs.push(wi, {drawn.wo[0][k], drawn.wo[1][k], drawn.wo[2][k]});
    }
    const std::size_t kept = part.pairs.size();
    part.weights.resize(kept);
    part.valid.resize(kept);
    part.values.resize(brdf.channels().count() * kept);
    brdf.pdf(part.pairs.view(), part.weights.data());
    const double cap = 2 * kPi * (1 - lowestCosine);
    for (double& weight : part.weights) weight = 2 / (1 + cap * weight);
    brdf.evaluate(part.pairs.view(), part.values.data(), part.valid.data());
    return part;
  }

  Channels channels_;
  DirectionPairBuffer<double> pairs_;
  std::vector<double> values_, weights_;
  std::vector<std::uint8_t> valid_;
  double totalWeight_ = 0;
};

}  // namespace

TargetSamples takeSamples(BrdfPointer brdf, const SampleChoice& choice, double maximumTheta) {
  if (!(maximumTheta > 0 && maximumTheta <= 90))
    throw Error(Error::Kind::Value, {"theta limit out of bounds", "maximum theta", formatNumber(maximumTheta),
                                     "above 0, at most 90 degrees"});
  if (choice.count > kMostSamples)
    throw Error(Error::Kind::Value, {"number of samples out of bounds", "samples", std::to_string(choice.count),
                                     "at most " + std::to_string(kMostSamples)});
  TargetSamples samples;
  samples.rule = {maximumTheta, choice.solidAngles, false, {}};
  samples.weights = choice.solidAngles ? "solid-angle" : "none";
  const double lowest = maximumTheta >= 90 ? 0 : std::cos(radians(maximumTheta));
  Sampling kind = choice.sampling;
  if (kind == Sampling::Automatic) kind = brdf->samples() ? Sampling::All : Sampling::Hemisphere;
  if (choice.noise && (kind != Sampling::All || choice.solidAngles))
    throw Error(Error::Kind::Value, {"weights by noise are for the target's own samples", "sampling",
                                     brdf->description(), "all samples, without weights by solid angle"});
  if (kind == Sampling::All) {
    samples.set = brdf->samples();
    if (!samples.set)
      throw Error(Error::Kind::Value, {"the target has no samples of its own", "sampling", brdf->description(),
                                       "hemisphere or importance, or measured data"});
    samples.sampling = "all samples of the target";
    if (choice.noise) {
      samples.made = std::make_shared<NoiseWeightedSamples>(*samples.set);
      samples.rule.noise = true;
      samples.weights = "noise";
      samples.sampling += " whose error is known";
    }
  } else if (kind == Sampling::Hemisphere) {
    const double wanted = choice.count > 0 ? std::cbrt(static_cast<double>(choice.count) / 2) : kHemisphereSide;
    const auto side = static_cast<std::size_t>(std::max(2.0, std::round(wanted)));
    samples.made = std::make_shared<HemispherePairs>(std::move(brdf), side, lowest);
    const std::string n = std::to_string(side);
    samples.sampling = n + " x " + n + " x " + std::to_string(2 * side) +
                       " pairs of directions in equal solid angles of both hemispheres";
  } else {
    const std::size_t draws = choice.count > 0 ? choice.count : kImportanceDraws;
    const auto drawn = std::make_shared<DrawnPairs>(brdf, draws, choice.seed, lowest);
    samples.rule.solidAngles = true;
    samples.rule.totalWeight = drawn->totalWeight();
    samples.made = drawn;
    samples.weights = "importance";
    samples.sampling = std::to_string(draws) + " draws by importance, seed " + std::to_string(choice.seed);
  }
  if (samples.made) samples.set = samples.made.get();
  return samples;
}

}  // namespace brdf
