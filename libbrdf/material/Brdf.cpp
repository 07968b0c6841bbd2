#include <brdf/base/Parallel.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>
#include <brdf/material/SampleSet.h>

#include <algorithm>

namespace brdf {

Brdf::~Brdf() = default;
SampleSet::~SampleSet() = default;
bool SampleSet::solidAngles(std::size_t, std::size_t, double*) const { return false; }
bool SampleSet::standardErrors(std::size_t, std::size_t, double*) const { return false; }

void Brdf::evaluate(const DirectionPairs<float>& pairs, float* values, std::uint8_t* valid) const {
  DirectionPairBuffer<double> wide(pairs.count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::copy_n(pairs.wi[axis], pairs.count, wide.wi[axis].data());
    std::copy_n(pairs.wo[axis], pairs.count, wide.wo[axis].data());
  }
  std::vector<double> wideValues(pairs.count * channels().count());
  evaluate(wide.view(), wideValues.data(), valid);
  std::transform(wideValues.begin(), wideValues.end(), values, [](double value) { return static_cast<float>(value); });
}

void Brdf::sample(const std::array<const double*, 3>&, const std::array<const double*, 2>& u,
                  const std::array<double*, 3>& wi, std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i) {
    const double r = std::sqrt(u[0][i]), phi = 2 * kPi * u[1][i];
    wi[0][i] = r * std::cos(phi);
    wi[1][i] = r * std::sin(phi);
    wi[2][i] = std::sqrt(1 - u[0][i]);
  }
}

void Brdf::pdf(const DirectionPairs<double>& pairs, double* density) const {
  for (std::size_t i = 0; i < pairs.count; ++i)
    density[i] = pairs.wo[2][i] > 0 ? std::max(0.0, pairs.wi[2][i]) / kPi : 0.0;
}

std::vector<double> Brdf::evaluate(const std::array<double, 3>& wi, const std::array<double, 3>& wo) const {
  DirectionPairs<double> pair;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    pair.wi[axis] = &wi[axis];
    pair.wo[axis] = &wo[axis];
  }
  pair.count = 1;
  std::vector<double> values(channels().count());
  evaluate(pair, values.data(), nullptr);
  return values;
}

void Brdf::evaluateParallel(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  const std::size_t channelCount = channels().count();
  parallelFor(pairs.count, 8192, [&](std::size_t first, std::size_t last) {
    const std::size_t length = last - first;
    std::vector<double> block(channelCount * length);
    evaluate(pairs.slice(first, length), block.data(), valid ? valid + first : nullptr);
    for (std::size_t channel = 0; channel < channelCount; ++channel)
      std::copy_n(block.data() + channel * length, length, values + channel * pairs.count + first);
  });
}

}  // namespace brdf
