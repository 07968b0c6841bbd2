#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/material/SampleSet.h>
#include <brdf/view/LobeSamples.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr std::size_t kBlock = 65'536;

Direction turned(const Direction& w, double phi) {
  const double c = std::cos(phi), s = std::sin(phi);
  return {c * w[0] - s * w[1], s * w[0] + c * w[1], w[2]};
}

struct Found {
  DirectionPair pair;
  double value = 0;  // shown
};

/// Keeps every n-th of what it is given, n a power of two that grows so that there are never more than twice the
/// maximum.
class Thinned {
 public:
  explicit Thinned(std::size_t maximum) : maximum_(maximum) {}
  void add(const Found& one) {
    if (found_++ % step_ != 0) return;
    kept_.push_back(one);
    if (kept_.size() < 2 * maximum_) return;
    for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i];
    kept_.resize((kept_.size() + 1) / 2);
    step_ *= 2;
  }
  std::size_t found() const { return found_; }
  std::vector<Found> take() {
    while (kept_.size() > maximum_) {
      for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i];
      kept_.resize((kept_.size() + 1) / 2);
    }
    return std::move(kept_);
  }

 private:
  std::size_t maximum_, found_ = 0, step_ = 1;
  std::vector<Found> kept_;
};

double shown(const std::vector<double>& weights, const double* values, std::size_t stride) {
  double sum = 0;
  for (std::size_t c = 0; c < weights.size(); ++c) sum += weights[c] * values[c * stride];
  return sum;
}

void require(bool condition, const char* field, double found, const char* allowed) {
  if (!condition) throw Error(Error::Kind::Value, {"out of range", field, formatNumber(found), allowed});
}

}  // namespace

LobeSamples lobeSamples(const Brdf& measured, const LobeSampleOptions& options, const Brdf* model) {
  const std::size_t channels = measured.channels().count();
  require(options.thetaI >= 0 && options.thetaI < kPi / 2, "theta_i", degrees(options.thetaI), "[0, 90) degrees");
  require(std::isfinite(options.phiI), "phi_i", degrees(options.phiI), "a finite number of degrees");
  require(options.within >= 0 && options.within <= kPi, "angle around the incident direction", degrees(options.within),
          "0 to 180 degrees");
  require(options.maximum >= 1, "samples on a lobe", 0, "1 or more");
  require(options.scale.floor > 0 && std::isfinite(options.scale.floor), "floor", options.scale.floor,
          "more than 0/sr");
  require(options.weights.empty() || options.weights.size() == channels, "number of channel weights",
          static_cast<double>(options.weights.size()), "none, or one a channel");
  require(!model || model->channels().count() == channels, "channels of the model",
          model ? static_cast<double>(model->channels().count()) : 0, "as many as of the samples");
  const SampleSet* samples = measured.samples();
  if (!samples)
    throw Error(Error::Kind::Value, {"no measured samples to show", "lobe", measured.description(), "a measured BRDF"});
  std::vector<double> weights = options.weights;
  if (weights.empty()) weights.assign(channels, 1.0 / static_cast<double>(channels));

  const Direction incident = fromSpherical(options.thetaI, options.phiI);
  const bool turns = measured.symmetry() != Symmetry::Anisotropic;
  double nearest = kPi;
  Thinned kept(options.maximum);
  DirectionPairBuffer<double> pairs;
  std::vector<double> values(kBlock * channels);
  std::vector<std::uint8_t> valid(kBlock);
  for (std::size_t first = 0; first < samples->count(); first += kBlock) {
    const std::size_t length = std::min(kBlock, samples->count() - first);
    samples->read(first, length, &pairs, values.data(), valid.data());
    for (std::size_t i = 0; i < length; ++i) {
      if (!valid[i]) continue;
      Direction light{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
      Direction view{pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
      for (int exchanged = 0; exchanged <= (measured.reciprocal() ? 1 : 0); ++exchanged, std::swap(light, view)) {
        const double turn = turns ? options.phiI - toSpherical(light).phi : 0;
        const Direction wi = turned(light, turn), across = cross(wi, incident);
        const double angle = std::atan2(std::sqrt(dot(across, across)), dot(wi, incident));
        nearest = std::min(nearest, angle);
        if (angle > options.within) continue;
        kept.add({{wi, turned(view, turn)}, shown(weights, values.data() + i, length)});
      }
    }
  }

  LobeSamples result;
  result.found = kept.found();
  result.nearest = nearest;
  const std::vector<Found> all = kept.take();
  for (const Found& one : all) {
    result.directions.push_back(one.pair.wo);
    result.values.push_back(one.value);
    result.lengths.push_back(transformed(options.scale, one.value));
  }
  if (model && !all.empty()) {
    DirectionPairBuffer<double> at(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) at.set(i, all[i].pair.wi, all[i].pair.wo);
    std::vector<double> modelled(all.size() * channels);
    std::vector<std::uint8_t> known(all.size());
    model->evaluateParallel(at.view(), modelled.data(), known.data());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double value = shown(weights, modelled.data() + i, all.size());
      result.residuals.push_back(
          known[i] && std::isfinite(value) ? transformed(options.scale, value) - result.lengths[i] : 0);
    }
  }
  return result;
}

}  // namespace brdf
