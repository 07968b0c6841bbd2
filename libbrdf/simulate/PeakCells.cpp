#include <brdf/simulate/PeakCells.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace brdf {
namespace {

constexpr double kLeastShare = 0.01;
/// A Gaussian peak passes this where cells are about half its standard deviation: four across its half width.
constexpr double kMostLoss = 0.05;
constexpr double kStandardErrors = 4;

/// What a mean over the cell loses of the integral of the square, as sums over pairs of different rays: unbiased,
/// whatever the number of rays. Of light that is spread evenly, a pair's term has the mean 0 and the variance 2.
bool losesByMean(const AxisLight& light, const std::array<double, 4>& cuts,
                 const std::function<double(double)>& measure) {
  const double whole = measure(cuts[3]) - measure(cuts[0]);
  AxisLight::Sums all;
  double fine = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisLight::Sums part = light.between(cuts[k], cuts[k + 1]);
    const double share = (measure(cuts[k + 1]) - measure(cuts[k])) / whole;
    if (!(share > 0)) return false;
    fine += (part.light * part.light - part.squares) / share;
    all.light += part.light;
    all.squares += part.squares;
  }
  if (!(all.light >= kLeastShare)) return false;
  const double square = all.light * all.light, loss = fine - (square - all.squares);
  return loss > kMostLoss * square && loss > kStandardErrors * 2 * all.squares;
}

}  // namespace

AxisLight::AxisLight(const std::vector<double>& positions, const std::vector<double>& shares)
    : light_(positions.size() + 1), squares_(positions.size() + 1) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::uint32_t k) { return positions[k]; });
  positions_.reserve(positions.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double share = shares[order[k]];
    positions_.push_back(positions[order[k]]);
    light_[k + 1] = light_[k] + share;
    squares_[k + 1] = squares_[k] + share * share;
  }
}

AxisLight::Sums AxisLight::between(double from, double to) const {
  const auto place = [&](double at) {
    return static_cast<std::size_t>(std::ranges::lower_bound(positions_, at) - positions_.begin());
  };
  const std::size_t first = place(from), last = std::max(first, place(to));
  return {light_[last] - light_[first], squares_[last] - squares_[first]};
}

std::vector<double> cutWherePeaked(const std::vector<double>& edges, const std::vector<AxisLight>& lights,
                                   const std::function<double(double)>& measure, double narrowest, bool wraps) {
  const std::size_t cells = edges.size() - 1;
  const auto cutsOf = [&](std::size_t k) {
    const double third = (edges[k + 1] - edges[k]) / 3;
    return std::array<double, 4>{edges[k], edges[k] + third, edges[k + 1] - third, edges[k + 1]};
  };
  std::vector<std::uint8_t> cut(cells, 0);
  for (std::size_t k = 0; k < cells; ++k) {
    if ((edges[k + 1] - edges[k]) / 3 < narrowest) continue;
    const auto cuts = cutsOf(k);
    if (std::ranges::none_of(lights, [&](const AxisLight& light) { return losesByMean(light, cuts, measure); }))
      continue;
    cut[k] = 1;
    if (k > 0 || wraps) cut[k > 0 ? k - 1 : cells - 1] = 1;
    if (k + 1 < cells || wraps) cut[k + 1 < cells ? k + 1 : 0] = 1;
  }
  std::vector<double> finer{edges[0]};
  for (std::size_t k = 0; k < cells; ++k) {
    const auto cuts = cutsOf(k);
    if (cut[k] && cuts[1] - cuts[0] >= narrowest) finer.insert(finer.end(), {cuts[1], cuts[2]});
    finer.push_back(edges[k + 1]);
  }
  return finer;
}

}  // namespace brdf
