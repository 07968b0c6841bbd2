#include <brdf/base/Error.h>
#include <brdf/fit/NoiseWeights.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace brdf {

NoiseWeightedSamples::NoiseWeightedSamples(const SampleSet& source) : source_(source) {
  constexpr std::size_t block = 65536;
  std::vector<double> found(std::min(block, source.count())), positive;
  std::vector<std::uint8_t> valid(found.size());
  for (std::size_t first = 0; first < source.count(); first += block) {
    const std::size_t length = std::min(block, source.count() - first);
    errors(first, length, found.data());
    source.read(first, length, nullptr, nullptr, valid.data());
    for (std::size_t i = 0; i < length; ++i)
      if (valid[i] && found[i] > 0) positive.push_back(found[i]);
  }
  if (positive.empty())
    throw Error(Error::Kind::Value, {"the target has no standard errors above 0 to weigh by",
                                     "weights",
                                     {},
                                     "a table with standard errors, such as a simulated one, or other weights"});
  const auto place = positive.begin() + static_cast<std::ptrdiff_t>(positive.size() / 20);
  std::ranges::nth_element(positive, place);
  leastError_ = *place;
}

void NoiseWeightedSamples::errors(std::size_t first, std::size_t length, double* errors) const {
  const std::size_t channels = source_.channels().count();
  std::vector<double> planar(channels * length);
  if (!source_.standardErrors(first, length, planar.data())) {
    std::fill_n(errors, length, -1.0);
    return;
  }
  for (std::size_t i = 0; i < length; ++i) {
    double sum = 0;
    bool known = true;
    for (std::size_t c = 0; c < channels; ++c) {
      const double error = planar[c * length + i];
      known = known && std::isfinite(error) && error >= 0;
      sum += error * error;
    }
    errors[i] = known ? std::sqrt(sum / static_cast<double>(channels)) : -1;
  }
}

void NoiseWeightedSamples::read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs,
                                double* values, std::uint8_t* valid) const {
  source_.read(first, length, pairs, values, valid);
  if (!values && !valid) return;
  std::vector<double> found(length);
  errors(first, length, found.data());
  const std::size_t channels = values ? source_.channels().count() : 0;
  for (std::size_t i = 0; i < length; ++i) {
    if (found[i] >= 0) continue;
    if (valid) valid[i] = 0;
    for (std::size_t c = 0; c < channels; ++c) values[c * length + i] = 0;
  }
}

bool NoiseWeightedSamples::solidAngles(std::size_t first, std::size_t length, double* measures) const {
  errors(first, length, measures);
  for (std::size_t i = 0; i < length; ++i) {
    const double error = measures[i] == 0 ? leastError_ : measures[i];
    measures[i] = error > 0 ? 1 / (error * error) : 0;
  }
  return true;
}

}  // namespace brdf
