#pragma once
#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>
#include <brdf/material/SampleSet.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/measured/Format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>

#include "../TestFolder.h"

namespace measuredtest {

/// An RGB BRDF given by a function, isotropic and reciprocal, for tests to tabulate and write.
class FunctionBrdf : public brdf::Brdf {
 public:
  using Function = std::function<double(const brdf::Direction& wi, const brdf::Direction& wo, std::size_t channel)>;
  explicit FunctionBrdf(Function function, brdf::Channels channels = brdf::Channels::rgb())
      : function_(std::move(function)), channels_(std::move(channels)) {}

  const brdf::Channels& channels() const override { return channels_; }
  brdf::Symmetry symmetry() const override { return brdf::Symmetry::Isotropic; }
  bool reciprocal() const override { return true; }
  std::string description() const override { return "test function"; }
  using Brdf::evaluate;
  void evaluate(const brdf::DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const brdf::Direction wi{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
      const brdf::Direction wo{pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
      for (std::size_t channel = 0; channel < channels_.count(); ++channel)
        values[channel * pairs.count + i] = wi[2] > 0 && wo[2] > 0 ? function_(wi, wo, channel) : 0;
      if (valid) valid[i] = 1;
    }
  }

 private:
  Function function_;
  brdf::Channels channels_;
};

/// A smooth glossy function: Lambertian plus a Gaussian lobe about the mirror direction.
inline double glossy(const brdf::Direction& wi, const brdf::Direction& wo, std::size_t channel) {
  const brdf::Direction h = brdf::normalized({wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]});
  const double tangent2 = (h[0] * h[0] + h[1] * h[1]) / (h[2] * h[2]);
  return 0.1 * (static_cast<double>(channel) + 1) + 3 * std::exp(-tangent2 / (0.2 * 0.2));
}

/// The scattered samples behind a BRDF just read.
inline const brdf::ScatteredSamples& dataOf(const brdf::ReadResult& result) {
  return dynamic_cast<const brdf::ScatteredBrdf&>(*result.brdf).data();
}

/// Expects the directions of sample i to a few roundings.
inline void expectPair(const brdf::ScatteredSamples& data, std::size_t i, const brdf::Direction& wi,
                       const brdf::Direction& wo) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(data.pairs.wi[axis][i], wi[axis], 1e-15) << "sample " << i;
    EXPECT_NEAR(data.pairs.wo[axis][i], wo[axis], 1e-15) << "sample " << i;
  }
}

inline std::filesystem::path folder(const std::string& name) { return testFolder(name); }

/// The error that `action` throws, as text; empty when it throws none.
inline std::string errorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const brdf::Error& error) {
    return error.what();
  }
  return {};
}

/// Root mean square of a one-channel BRDF's valid samples, each times cos theta_i ^ power.
inline double rmsOfSamples(const brdf::Brdf& brdf, int power) {
  const brdf::SampleSet& samples = *brdf.samples();
  brdf::DirectionPairBuffer<double> pairs;
  std::vector<double> values(samples.count());
  std::vector<std::uint8_t> valid(samples.count());
  samples.read(0, samples.count(), &pairs, values.data(), valid.data());
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!valid[i]) continue;
    sum += std::pow(values[i] * std::pow(pairs.wi[2][i], power), 2);
    ++count;
  }
  return std::sqrt(sum / static_cast<double>(count));
}

}  // namespace measuredtest
