#include <brdf/base/Parallel.h>
#include <brdf/fit/DataStart.h>
#include <brdf/fit/StartSearch.h>
#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

constexpr std::size_t kMeasuredSamples = 2048;
// Bins of theta_h, uniform in its square root, as measured tables are: narrow lobes get many.
constexpr std::size_t kBins = 64;
// The level that values without a lobe have: this quantile of the data.
constexpr double kFloorQuantile = 0.2;
constexpr double kNearNormal = 30, kGrazing = 50;  // degrees of theta_d

struct HalfVector {
  double x, y, z, cosDifference;
};

HalfVector halfVector(const DirectionPairs<double>& pairs, std::size_t i) {
  const double x = pairs.wi[0][i] + pairs.wo[0][i], y = pairs.wi[1][i] + pairs.wo[1][i],
               z = pairs.wi[2][i] + pairs.wo[2][i];
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length, 0.5 * length};
}

double distance(const LobeMeasures& a, const LobeMeasures& b) {
  const auto squared = [](double d) { return d * d; };
  return squared(a.median - b.median) + squared(a.wide - b.wide) + 0.25 * squared(a.grazing - b.grazing) +
         squared(a.stretched - b.stretched);
}

/// The tan theta_h within which `part` of the projected area lies.
double quantile(const std::array<double, kBins>& mass, double part) {
  double total = 0, sum = 0;
  for (const double m : mass) total += m;
  for (std::size_t b = 0; b < kBins; ++b) {
    if (mass[b] > 0 && sum + mass[b] >= part * total) {
      const double inside = (part * total - sum) / mass[b];
      const double root = (static_cast<double>(b) + inside) / kBins;
      return std::tan(std::min(root * root, 0.999) * kPi / 2);
    }
    sum += mass[b];
  }
  return 1;
}

}  // namespace

std::optional<LobeMeasures> measureLobe(const DirectionPairs<double>& pairs, const double* values) {
  std::array<double, kBins> sum{}, mass{};
  std::array<std::size_t, kBins> samples{};
  std::vector<std::size_t> bin(pairs.count);
  const auto projected = [&](std::size_t i) { return values[i] * pairs.wi[2][i] * pairs.wo[2][i]; };
  double alongX = 0, alongY = 0;
  for (std::size_t i = 0; i < pairs.count; ++i) {
    const HalfVector h = halfVector(pairs, i);
    const double theta = std::atan2(std::hypot(h.x, h.y), h.z);
    bin[i] = std::min(kBins - 1, static_cast<std::size_t>(std::sqrt(theta / (kPi / 2)) * kBins));
    sum[bin[i]] += projected(i);
    ++samples[bin[i]];
    alongX += projected(i) * std::abs(h.x) / h.z;
    alongY += projected(i) * std::abs(h.y) / h.z;
  }
  // D by bins, those without samples filled from the one before, and the area that it gives each.
  std::size_t filled = 0;
  double last = 0;
  for (std::size_t b = 0; b < kBins; ++b) {
    if (samples[b] > 0) last = std::max(0.0, sum[b] / static_cast<double>(samples[b]));
    if (samples[b] > 0 && sum[b] > 0) ++filled;
    const double low = static_cast<double>(b) / kBins, high = static_cast<double>(b + 1) / kBins;
    const double first = std::sin(low * low * kPi / 2), second = std::sin(high * high * kPi / 2);
    mass[b] = last * 0.5 * (second * second - first * first);
  }
  if (filled < 2) return {};
  LobeMeasures measures;
  measures.median = std::log(quantile(mass, 0.5));
  measures.wide = std::log(quantile(mass, 0.9));
  if (alongX > 0 && alongY > 0) measures.stretched = std::log(alongX / alongY);
  double steep = 0, steepWanted = 0, grazing = 0, grazingWanted = 0;
  for (std::size_t i = 0; i < pairs.count; ++i) {
    const double cosine = halfVector(pairs, i).cosDifference;
    const double expected = sum[bin[i]] / static_cast<double>(samples[bin[i]]);
    if (cosine > std::cos(radians(kNearNormal))) {
      steep += projected(i);
      steepWanted += expected;
    } else if (cosine < std::cos(radians(kGrazing))) {
      grazing += projected(i);
      grazingWanted += expected;
    }
  }
  if (steep > 0 && grazing > 0 && steepWanted > 0 && grazingWanted > 0)
    measures.grazing = std::log(grazing / grazingWanted) - std::log(steep / steepWanted);
  return measures;
}

std::vector<double> shapeFromData(const FitProblem& problem, const FitData& all) {
  const FitData data = all.samples > kMeasuredSamples ? all.subset(kMeasuredSamples) : all;
  const FitChunk& chunk = data.chunks.front();
  const ResidualBlock block = data.block(chunk, 0);
  const DirectionPairs<double> pairs = block.pairs;
  const std::size_t count = pairs.count, lobes = problem.lobeCount();
  std::vector<double> target(count), left(count), sorted;
  block.values(target.data());
  sorted = target;
  const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(kFloorQuantile * static_cast<double>(count));
  std::nth_element(sorted.begin(), place, sorted.end());
  for (std::size_t i = 0; i < count; ++i) left[i] = target[i] - std::max(0.0, *place);

  std::vector<double> x = problem.start();
  std::vector<std::vector<double>> values(lobes, std::vector<double>(count));
  std::vector<std::size_t> done;
  for (std::size_t l = 0; l < lobes; ++l) {
    problem.model(l).evaluate(pairs, problem.parameters(x)[l], values[l].data());
    if (coordinatesOf(problem, l).empty()) done.push_back(l);
  }
  for (std::size_t lobe = 0; lobe < lobes; ++lobe) {
    if (coordinatesOf(problem, lobe).empty()) continue;
    const std::optional<LobeMeasures> wanted = measureLobe(pairs, left.data());
    if (!wanted) break;
    std::vector<std::vector<double>> shapes = lowDiscrepancyShapes(problem, lobe, x);
    std::vector<double> distances(shapes.size(), std::numeric_limits<double>::infinity());
    parallelFor(shapes.size(), 4, [&](std::size_t first, std::size_t last) {
      std::vector<double> own(count);
      for (std::size_t k = first; k < last; ++k) {
        problem.model(lobe).evaluate(pairs, problem.parameters(shapes[k])[lobe], own.data());
        if (const std::optional<LobeMeasures> measures = measureLobe(pairs, own.data()))
          distances[k] = distance(*measures, *wanted);
      }
    });
    const auto nearest = std::ranges::min_element(distances);
    if (!std::isfinite(*nearest)) continue;
    x = shapes[static_cast<std::size_t>(nearest - distances.begin())];
    for (std::size_t l = 0; l < lobes; ++l)  // other lobes may be tied to this one
      problem.model(l).evaluate(pairs, problem.parameters(x)[l], values[l].data());
    done.push_back(lobe);

    std::vector<const double*> columns;
    std::vector<bool> held;
    std::vector<double> scales;
    for (const std::size_t l : done) {
      columns.push_back(values[l].data());
      held.push_back(problem.fixedScale(l).has_value());
      scales.push_back(problem.fixedScale(l).value_or(0));
    }
    solveScales(block, columns, held, scales);
    left = target;
    for (std::size_t k = 0; k < done.size(); ++k)
      for (std::size_t i = 0; i < count; ++i) left[i] -= scales[k] * columns[k][i];
  }
  return x;
}

}  // namespace brdf
