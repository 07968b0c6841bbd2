#include <brdf/base/Error.h>
#include <brdf/view/Histogram.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brdf {
namespace {

constexpr double kWideRatio = 20;
constexpr double kDecades = 8;

}  // namespace

Distribution::Distribution(std::span<const double> values, std::span<const double> weights) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  values_.reserve(values.size());
  shares_.reserve(values.size());
  double sum = 0;
  for (std::size_t i : order) {
    values_.push_back(values[i]);
    shares_.push_back(sum += weights.empty() ? 1 : weights[i]);
  }
  for (double& share : shares_) share /= sum;
}

double Distribution::quantile(double share) const {
  if (values_.empty()) return 0;
  const auto found = std::lower_bound(shares_.begin(), shares_.end(), share * (1 - 1e-12));
  return values_[std::min<std::size_t>(found - shares_.begin(), values_.size() - 1)];
}

Histogram makeHistogram(std::span<const double> values, std::span<const double> weights, std::size_t bins) {
  if (bins < 1 || bins > 10'000)
    throw Error(Error::Kind::Value, {"out of range", "histogram bins", std::to_string(bins), "1 to 10000"});
  Histogram histogram;
  if (values.empty()) return histogram;
  const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
  double low = *smallest, high = *largest;
  if (low == high) {
    bins = 1;
  } else if (low >= 0 && high > kWideRatio * Distribution(values, weights).quantile(0.5)) {
    double positive = high;
    for (double value : values)
      if (value > 0) positive = std::min(positive, value);
    low = std::max(positive, high * std::pow(10, -kDecades));
    histogram.logarithmic = low < high;
    if (!histogram.logarithmic) low = 0;  // zeros and one other number
  } else if (low >= 0) {
    low = 0;
  }
  for (std::size_t k = 0; k <= bins; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(bins);
    histogram.edges.push_back(histogram.logarithmic ? low * std::pow(high / low, t) : low + t * (high - low));
  }
  histogram.edges.back() = high;
  histogram.count.assign(bins, 0);
  histogram.share.assign(bins, 0);
  double total = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto above = std::upper_bound(histogram.edges.begin(), histogram.edges.end(), values[i]);
    const auto index =
        std::clamp<std::ptrdiff_t>(above - histogram.edges.begin() - 1, 0, static_cast<std::ptrdiff_t>(bins) - 1);
    ++histogram.count[static_cast<std::size_t>(index)];
    histogram.share[static_cast<std::size_t>(index)] += weights.empty() ? 1 : weights[i];
    total += weights.empty() ? 1 : weights[i];
  }
  for (double& share : histogram.share) share = total > 0 ? share / total : 0;
  return histogram;
}

}  // namespace brdf
