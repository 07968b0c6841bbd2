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
  departures.insert(departures.end(), other.departures.begin(), other.departures.end());
}

}  // namespace brdf
