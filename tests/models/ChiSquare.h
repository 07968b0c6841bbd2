#pragma once
// Pearson's chi-square test of observed counts against expected ones.
#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace brdf::test {

struct ChiSquare {
  double statistic = 0;
  std::size_t cells = 0;   ///< after pooling
  double probability = 1;  ///< of a statistic as large by chance, were the counts drawn as expected
};

/// Cells that expect fewer than `pooling` draws are pooled, smallest first, until the pool expects that many
/// (Cochran's rule); the counts must sum to about what is expected.
inline ChiSquare chiSquare(const std::vector<double>& observed, const std::vector<double>& expected,
                           double pooling = 10) {
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
  ChiSquare result;
  double poolObserved = 0, poolExpected = 0;
  for (const std::size_t cell : order) {
    poolObserved += observed[cell];
    poolExpected += expected[cell];
    if (poolExpected < pooling) continue;
    result.statistic += (poolObserved - poolExpected) * (poolObserved - poolExpected) / poolExpected;
    ++result.cells;
    poolObserved = poolExpected = 0;
  }
  // What is left over expects less than `pooling`: draws where next to none belong show as a large term of their own.
  if (poolObserved > 0 || poolExpected > 0) {
    const double floor = std::max(poolExpected, 1.0);
    result.statistic += (poolObserved - poolExpected) * (poolObserved - poolExpected) / floor;
    ++result.cells;
  }
  if (result.cells > 1)
    result.probability = boost::math::cdf(
        boost::math::complement(boost::math::chi_squared(static_cast<double>(result.cells - 1)), result.statistic));
  return result;
}

}  // namespace brdf::test
