#include <brdf/base/Error.h>
#include <brdf/sampling/HemispherePartition.h>
#include <brdf/sampling/SamplerChecks.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <numeric>
#include <random>

namespace brdf {
namespace {

std::vector<Direction> drawn(const DirectionSampler& sampler, const Direction& wo, std::size_t count,
                             std::uint64_t seed) {
  constexpr std::size_t block = 4096;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::vector<double> numbers(8 * block);
  double* column[8];
  for (std::size_t k = 0; k < 8; ++k) column[k] = numbers.data() + k * block;
  for (std::size_t axis = 0; axis < 3; ++axis) std::fill_n(column[axis], block, wo[axis]);
  std::vector<Direction> result;
  result.reserve(count);
  while (result.size() < count) {
    const std::size_t length = std::min(block, count - result.size());
    for (std::size_t i = 0; i < length; ++i) {
      column[3][i] = uniform(random);
      column[4][i] = uniform(random);
    }
    sampler.sample({column[0], column[1], column[2]}, {column[3], column[4]}, {column[5], column[6], column[7]},
                   length);
    for (std::size_t i = 0; i < length; ++i) result.push_back({column[5][i], column[6][i], column[7][i]});
  }
  return result;
}

// Of an integral over the hemisphere at the default tolerance: cosine densities, whose integral is 1, come out within
// 6e-4 (tests/sampling).
constexpr double kQuadratureError = 1e-3;

/// Adds directions from 0.3 to 1e-5 rad off `centre`, evenly in the logarithm, so that a peak there has cells even
/// where the sampler does not draw it.
void surround(const Direction& centre, std::vector<Direction>& directions) {
  Direction t, b;
  orthonormalBasis(centre, t, b);
  constexpr int count = 256;
  for (int k = 0; k < count; ++k) {
    const double angle = 0.3 * std::pow(3e-5, (k + 0.5) / count), turn = 2.39996322972865332 * k;  // the golden angle
    const double p = std::sin(angle) * std::cos(turn), q = std::sin(angle) * std::sin(turn), r = std::cos(angle);
    Direction direction;
    for (std::size_t axis = 0; axis < 3; ++axis) direction[axis] = p * t[axis] + q * b[axis] + r * centre[axis];
    directions.push_back(direction);
  }
}

HemispherePartition partitionFor(const DirectionSampler& sampler, const Direction& wo,
                                 const SamplerTestOptions& options) {
  std::vector<Direction> directions = drawn(sampler, wo, 64 * options.cells, options.seed ^ 0x9e3779b97f4a7c15u);
  surround({-wo[0], -wo[1], wo[2]}, directions);
  surround(wo, directions);
  return {wo, directions, options.cells};
}

bool failedDraw(const Direction& wi) { return wi == Direction{0, 0, 0}; }

}  // namespace

ChiSquare chiSquare(std::span<const double> observed, std::span<const double> expected, double pooling) {
  if (observed.size() != expected.size())
    throw Error(Error::Kind::Value, {"counts of different lengths", "chi-square test", std::to_string(observed.size()),
                                     std::to_string(expected.size())});
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
  const auto term = [](double seen, double awaited) { return (seen - awaited) * (seen - awaited) / awaited; };
  ChiSquare result;
  double poolObserved = 0, poolExpected = 0, worst = -1;
  const auto closePool = [&] {
    if (!(poolObserved > 0 || poolExpected > 0)) return;
    result.statistic += term(poolObserved, std::max(poolExpected, 1.0));
    ++result.cells;
    poolObserved = poolExpected = 0;
  };
  for (const std::size_t cell : order) {
    if (const double own = term(observed[cell], std::max(expected[cell], 1.0)); own > worst) {
      worst = own;
      result.worst = cell;
    }
    // A pool that expects too little still stands alone: draws where next to none belong show.
    if (expected[cell] >= pooling) closePool();
    poolObserved += observed[cell];
    poolExpected += expected[cell];
    if (poolExpected >= pooling) closePool();
  }
  closePool();
  if (result.cells > 1)
    result.probability = boost::math::cdf(
        boost::math::complement(boost::math::chi_squared(static_cast<double>(result.cells - 1)), result.statistic));
  return result;
}

double sidakSignificance(double level, std::size_t tests) {
  return -std::expm1(std::log1p(-level) / static_cast<double>(std::max<std::size_t>(tests, 1)));
}

SamplerTest testSampler(const DirectionSampler& sampler, const Direction& wo, const SamplerTestOptions& options) {
  const HemispherePartition partition = partitionFor(sampler, wo, options);
  std::vector<double> expected = partition.integrate(sampler.pdf, options.quadrature);
  SamplerTest result;
  result.integral = std::accumulate(expected.begin(), expected.end(), 0.0);

  std::vector<double> observed(expected.size());
  DirectionPairBuffer<double> pairs(options.draws);
  std::size_t good = 0, failed = 0;
  for (const Direction& wi : drawn(sampler, wo, options.draws, options.seed)) {
    if (failedDraw(wi)) {
      ++failed;
    } else if (!(wi[2] > 0 && std::fabs(dot(wi, wi) - 1) < 1e-9)) {
      ++result.bad;
    } else {
      ++observed[partition.cellOf(wi)];
      pairs.set(good++, wi, wo);
    }
  }
  std::vector<double> density(good);
  sampler.pdf(pairs.view().slice(0, good), density.data());
  result.uncovered = static_cast<std::size_t>(
      std::count_if(density.begin(), density.end(), [](double value) { return !(value > 0 && std::isfinite(value)); }));
  const auto draws = static_cast<double>(options.draws);
  result.failed = static_cast<double>(failed) / draws;
  const double success = 1 - result.failed;
  result.deviation =
      (result.integral - success) / std::max(std::sqrt(success * result.failed / draws), kQuadratureError);
  // Counts given that a draw does not fail; how many fail is the deviation's matter.
  if (result.integral > 0)
    for (double& count : expected) count *= static_cast<double>(good) / result.integral;
  result.chiSquare = chiSquare(observed, expected, options.pooling);
  const std::size_t worst = result.chiSquare.worst;
  result.worst = partition.centre(partition.cells()[worst]);
  result.worstObserved = observed[worst];
  result.worstExpected = expected[worst];
  return result;
}

double pdfIntegral(const DirectionSampler& sampler, const Direction& wo, const SamplerTestOptions& options) {
  const std::vector<double> shares = partitionFor(sampler, wo, options).integrate(sampler.pdf, options.quadrature);
  return std::accumulate(shares.begin(), shares.end(), 0.0);
}

}  // namespace brdf
