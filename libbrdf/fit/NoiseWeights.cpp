#include <brdf/base/Error.h>
#include <brdf/fit/NoiseWeights.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace brdf {

NoiseWeightedSamples::NoiseWeightedSamples(const SampleSet& source) : source_(source) {
  constexpr std::size_t block = 65536;
  const std::size_t channels = source.channels().count();
  std::vector<std::uint8_t> valid(std::min(block, source.count()));
  std::vector<double> found(channels * valid.size());
  std::vector<std::vector<double>> positive(channels);
  // Until they are known, what counts as the least is what errors are.
  leastErrors_.assign(channels, 0.0);
  for (std::size_t first = 0; first < source.count(); first += block) {
    const std::size_t length = std::min(block, source.count() - first);
    if (!standardErrors(first, length, found.data())) break;
    source.read(first, length, nullptr, nullptr, valid.data());
    for (std::size_t c = 0; c < channels; ++c)
      for (std::size_t i = 0; i < length; ++i)
        if (valid[i] && found[c * length + i] > 0) positive[c].push_back(found[c * length + i]);
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < channels; ++c) {
    if (positive[c].empty()) continue;
    const auto place = positive[c].begin() + static_cast<std::ptrdiff_t>(positive[c].size() / 20);
    std::ranges::nth_element(positive[c], place);
    leastErrors_[c] = *place;
    least = std::min(least, *place);
  }
  if (!std::isfinite(least))
    throw Error(Error::Kind::Value, {"the target has no standard errors above 0 to weigh by",
                                     "weights",
                                     {},
                                     "a table with standard errors, such as a simulated one, or other weights"});
  for (double& error : leastErrors_)
    if (error == 0) error = least;
}

bool NoiseWeightedSamples::standardErrors(std::size_t first, std::size_t length, double* errors) const {
  if (!source_.standardErrors(first, length, errors)) return false;
  const std::size_t channels = leastErrors_.size();
  for (std::size_t i = 0; i < length; ++i) {
    bool known = true;
    for (std::size_t c = 0; c < channels; ++c)
      known = known && std::isfinite(errors[c * length + i]) && errors[c * length + i] >= 0;
    for (std::size_t c = 0; c < channels; ++c) {
      double& error = errors[c * length + i];
      if (!known)
        error = std::numeric_limits<double>::quiet_NaN();
      else if (error == 0)
        error = leastErrors_[c];
    }
  }
  return true;
}

void NoiseWeightedSamples::read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs,
                                double* values, std::uint8_t* valid) const {
  source_.read(first, length, pairs, values, valid);
  if (!values && !valid) return;
  const std::size_t channels = leastErrors_.size();
  std::vector<double> errors(channels * length);
  const bool any = standardErrors(first, length, errors.data());
  for (std::size_t i = 0; i < length; ++i) {
    if (any && !std::isnan(errors[i])) continue;
    if (valid) valid[i] = 0;
    for (std::size_t c = 0; values && c < channels; ++c) values[c * length + i] = 0;
  }
}

}  // namespace brdf
