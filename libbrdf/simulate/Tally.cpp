#include <brdf/simulate/Tally.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {

void RaySums::add(const RaySums& other) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += other.sum[k];
  for (std::size_t k = 0; k < square.size(); ++k) square[k] += other.square[k];
}

Estimate RaySums::mean(std::size_t entry, std::uint64_t rays) const {
  if (rays == 0) return {0, std::numeric_limits<double>::infinity()};
  const auto n = static_cast<double>(rays);
  const double mean = sum[entry] / n;
  if (rays < 2) return {mean, std::numeric_limits<double>::infinity()};
  const double variance = std::max(square[entry] / n - mean * mean, 0.0);
  // What is the same for every ray differs by rounding only.
  if (variance < 1e-12 * mean * mean) return {mean, 0};
  return {mean, std::sqrt(variance / (n - 1))};
}

void Tally::add(const Tally& other) {
  rays += other.rays;
  segments += other.segments;
  reflected.add(other.reflected);
  transmitted.add(other.transmitted);
  outcomes.add(other.outcomes);
  if (!other.excessTimesReflected.empty()) {
    prepareExcess();
    excess.add(other.excess);
    for (std::size_t k = 0; k < excessTimesReflected.size(); ++k)
      excessTimesReflected[k] += other.excessTimesReflected[k];
  }
  departures.insert(departures.end(), other.departures.begin(), other.departures.end());
}

void Tally::prepareExcess() {
  if (!excessTimesReflected.empty()) return;
  excess = RaySums(channels);
  excessTimesReflected.assign(reflected.sum.size(), 0.0);
}

RaySums Tally::balanced() const {
  RaySums sums = reflected;
  if (excessTimesReflected.empty()) return sums;
  for (std::size_t c = 0; c < channels; ++c) {
    double all = 0, product = 0;
    for (std::size_t e = c * bins; e < (c + 1) * bins; ++e) {
      all += reflected.sum[e];
      product += excessTimesReflected[e];
    }
    if (!(all > 0 && excess.square[c] > 0)) continue;
    // What makes the sum of the bins least uncertain; at most the whole excess, so that no bin becomes negative.
    const double part = std::clamp(-product / excess.square[c], 0.0, 1.0);
    for (std::size_t e = c * bins; e < (c + 1) * bins; ++e) {
      const double share = part * reflected.sum[e] / all;
      sums.sum[e] += share * excess.sum[c];
      sums.square[e] += share * (2 * excessTimesReflected[e] + share * excess.square[c]);
    }
  }
  return sums;
}

}  // namespace brdf
