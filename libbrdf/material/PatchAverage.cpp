#include <brdf/base/Parallel.h>
#include <brdf/material/Averages.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brdf {
namespace {

constexpr std::size_t kBlock = 1u << 15;  ///< pairs evaluated at once, about

/// Means over pairs of one incident patch and several outgoing ones.
class RowAverager {
 public:
  RowAverager(const Brdf& brdf, const PatchBasis& incident, const PatchBasis& outgoing)
      : brdf_(brdf), incident_(incident), outgoing_(outgoing), channels_(brdf.channels().count()) {}

  /// Means by midpoints of n^4 into means[k * channels + c] for outgoing[k], and whether any was valid.
  void run(std::size_t light, const std::vector<std::size_t>& viewers, int n, std::vector<double>& means,
           std::vector<std::uint8_t>& valid) {
    means.assign(viewers.size() * channels_, 0.0);
    valid.assign(viewers.size(), 0);
    const auto squared = static_cast<std::size_t>(n) * static_cast<std::size_t>(n), each = squared * squared;
    const std::size_t step = std::max<std::size_t>(1, kBlock / each);
    for (std::size_t first = 0; first < viewers.size(); first += step) {
      const std::size_t length = std::min(step, viewers.size() - first);
      place(light, std::span(viewers).subspan(first, length), n);
      brdf_.evaluate(pairs_.view(), values_.data(), flags_.data());
      for (std::size_t k = 0; k < length; ++k) sum(k, each, &means[(first + k) * channels_], valid[first + k]);
    }
  }

 private:
  void place(std::size_t light, std::span<const std::size_t> viewers, int n) {
    const auto squared = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    const auto middle = [n](std::size_t i) { return (static_cast<double>(i) + 0.5) / n; };
    const auto points = [&](const PatchBasis& basis, std::size_t patch) {
      std::vector<Direction> directions;
      for (std::size_t i = 0; i < squared; ++i)
        directions.push_back(
            basis.at(patch, middle(i / static_cast<std::size_t>(n)), middle(i % static_cast<std::size_t>(n))));
      return directions;
    };
    std::vector<Direction> lights = points(incident_, light);
    for (Direction& wi : lights) wi = {-wi[0], -wi[1], wi[2]};
    const std::size_t count = viewers.size() * squared * squared;
    pairs_.resize(count);
    values_.resize(count * channels_);
    flags_.resize(count);
    std::size_t at = 0;
    for (const std::size_t viewer : viewers)
      for (const Direction& wo : points(outgoing_, viewer))
        for (const Direction& wi : lights) pairs_.set(at++, wi, wo);
  }

  void sum(std::size_t k, std::size_t each, double* means, std::uint8_t& valid) const {
    std::size_t used = 0;
    for (std::size_t i = k * each; i < (k + 1) * each; ++i) {
      if (!flags_[i]) continue;
      ++used;
      for (std::size_t c = 0; c < channels_; ++c) means[c] += values_[c * flags_.size() + i];
    }
    valid = used > 0;
    for (std::size_t c = 0; c < channels_ && used > 0; ++c) means[c] /= static_cast<double>(used);
  }

  const Brdf& brdf_;
  const PatchBasis& incident_;
  const PatchBasis& outgoing_;
  std::size_t channels_;
  DirectionPairBuffer<double> pairs_;
  std::vector<double> values_;
  std::vector<std::uint8_t> flags_;
};

}  // namespace

std::shared_ptr<const PatchBrdf> averageOverPatches(const Brdf& brdf, const PatchBasis& incident,
                                                    const PatchBasis& outgoing, const PatchAverageOptions& options,
                                                    AverageReport& report) {
  const std::size_t lights = incident.count(), viewers = outgoing.count(), channels = brdf.channels().count();
  PatchData data{incident, outgoing, brdf.channels(), std::vector<double>(channels * lights * viewers)};
  std::vector<double> errors(lights, 0.0);
  std::vector<std::size_t> invalid(lights, 0);
  parallelFor(lights, 1, [&](std::size_t firstLight, std::size_t lastLight) {
    RowAverager averager(brdf, incident, outgoing);
    for (std::size_t light = firstLight; light < lastLight; ++light) {
      std::vector<std::size_t> open(viewers);
      std::iota(open.begin(), open.end(), std::size_t{0});
      std::vector<double> means, before, finer;
      std::vector<std::uint8_t> valid, finerValid;
      averager.run(light, open, 2, means, valid);
      std::vector<double> change(viewers, 0.0);
      double energy = 0;
      for (int n = 4; n <= std::max(4, options.maximumPoints) && !open.empty(); n *= 2) {
        averager.run(light, open, n, finer, finerValid);
        for (std::size_t k = 0; k < open.size(); ++k) {
          const std::size_t o = open[k];
          change[o] = 0;
          for (std::size_t c = 0; c < channels; ++c) {
            change[o] += std::abs(finer[k * channels + c] - means[o * channels + c]) * outgoing.projectedSolidAngle(o);
            means[o * channels + c] = finer[k * channels + c];
          }
          valid[o] = finerValid[k];
        }
        energy = 0;
        for (std::size_t o = 0; o < viewers; ++o)
          for (std::size_t c = 0; c < channels; ++c)
            energy += std::abs(means[o * channels + c]) * outgoing.projectedSolidAngle(o);
        const double share = options.tolerance * energy / static_cast<double>(viewers);
        std::erase_if(open, [&](std::size_t o) { return change[o] <= share; });
      }
      if (energy > 0) errors[light] = std::accumulate(change.begin(), change.end(), 0.0) / energy;
      for (std::size_t o = 0; o < viewers; ++o) {
        invalid[light] += !valid[o];
        for (std::size_t c = 0; c < channels; ++c)
          data.values[(c * viewers + o) * lights + light] = means[o * channels + c];
      }
    }
  });
  report.pairs = lights * viewers;
  report.error = *std::max_element(errors.begin(), errors.end());
  report.invalid = std::accumulate(invalid.begin(), invalid.end(), std::size_t{0});
  return std::make_shared<const PatchBrdf>(std::move(data), brdf.description());
}

}  // namespace brdf
