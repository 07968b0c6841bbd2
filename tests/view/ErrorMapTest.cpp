#include "SimpleBrdfs.h"

#include <brdf/base/Error.h>
#include <brdf/material/SampleSet.h>
#include <brdf/view/ErrorMap.h>

#include <gtest/gtest.h>

namespace brdf {
namespace {

using test::constantBrdf;
using test::FunctionBrdf;

/// Three samples of value 1 in two channels, the last one invalid.
class ThreeSamples : public SampleSet {
 public:
  std::size_t count() const override { return 3; }
  const Channels& channels() const override { return channels_; }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    const std::array<std::array<double, 2>, 3> degreesOf{{{30, 60}, {32, 58}, {70, 10}}};
    if (pairs) pairs->resize(length);
    for (std::size_t i = 0; i < length; ++i) {
      const auto [thetaI, thetaO] = degreesOf[first + i];
      if (pairs) pairs->set(i, fromSpherical(radians(thetaI), 1), fromSpherical(radians(thetaO), 3));
      if (valid) valid[i] = first + i < 2;
      for (std::size_t c = 0; values && c < 2; ++c) values[c * length + i] = first + i < 2 ? 1 : 0;
    }
  }

 private:
  Channels channels_ = Channels::spectral({500, 600});
};

class MeasuredBrdf : public FunctionBrdf {
 public:
  MeasuredBrdf()
      : FunctionBrdf([](const Direction&, const Direction&) { return 77.0; }, Channels::spectral({500, 600})) {}
  const SampleSet* samples() const override { return &samples_; }

 private:
  ThreeSamples samples_;
};

TEST(ErrorMap, ConstantBrdfsGiveTheClosedFormOfEveryMeasure) {
  const FunctionBrdf a = constantBrdf(0.5, Channels::rgb()), b = constantBrdf(0.2, Channels::rgb());
  ErrorMapOptions options;
  options.intervals = 9;
  options.azimuths = 4;
  const auto node = [&](ErrorMeasure measure, std::size_t x, std::size_t y) {
    options.measure = measure;
    const ErrorMap map = makeErrorMap(a, b, options);
    EXPECT_EQ(map.nodes(), 10u);
    EXPECT_EQ(map.count[y * 10 + x], 12u);  // 4 azimuths, 3 channels
    return map.mean[y * 10 + x];
  };
  const double c = std::cos(radians(60));  // node 6 of 9
  EXPECT_NEAR(node(ErrorMeasure::Difference, 6, 2), 0.3, 1e-15);
  EXPECT_NEAR(node(ErrorMeasure::Absolute, 2, 6), 0.3, 1e-15);
  EXPECT_NEAR(node(ErrorMeasure::Relative, 0, 9), 1.5, 1e-14);
  EXPECT_NEAR(node(ErrorMeasure::Log, 6, 3), std::log(1 + 0.5 * c) - std::log(1 + 0.2 * c), 1e-15);
  EXPECT_NEAR(node(ErrorMeasure::CubeRoot, 6, 3), std::cbrt(0.5 * c) - std::cbrt(0.2 * c), 1e-15);
}

TEST(ErrorMap, SignedDifferenceTurnsWithItsOperands) {
  const FunctionBrdf a([](const Direction& wi, const Direction&) { return wi[2]; });
  const FunctionBrdf b([](const Direction&, const Direction& wo) { return wo[2] * wo[2]; });
  ErrorMapOptions options;
  options.measure = ErrorMeasure::Difference;
  options.intervals = 12;
  const ErrorMap ab = makeErrorMap(a, b, options), ba = makeErrorMap(b, a, options);
  for (std::size_t i = 0; i < ab.mean.size(); ++i) EXPECT_EQ(ab.mean[i], -ba.mean[i]);
  EXPECT_EQ(ab.overallMean, -ba.overallMean);
  EXPECT_EQ(ab.largest, ba.largest);
  EXPECT_EQ(makeErrorMap(a, a, options).largest, 0);
}

TEST(ErrorMap, ComparesAtTheSamplesOfTheMeasuredOne) {
  const FunctionBrdf a = constantBrdf(1.25, Channels::spectral({500, 600}));
  const MeasuredBrdf b;
  ErrorMapOptions options;
  options.measure = ErrorMeasure::Difference;
  EXPECT_EQ(automaticIntervals(a, b, true), 9u);
  EXPECT_EQ(automaticIntervals(a, b, false), 90u);
  const ErrorMap map = makeErrorMap(a, b, options);
  std::uint64_t counted = 0;
  for (std::uint64_t count : map.count) counted += count;
  EXPECT_EQ(counted, 4u);                 // two valid samples, two channels
  EXPECT_EQ(map.count[6 * 10 + 3], 4u);   // theta_i 30 and 32, theta_o 60 and 58: the node at (30, 60)
  EXPECT_EQ(map.mean[6 * 10 + 3], 0.25);  // to the samples' values, not to the interpolated 77
  EXPECT_EQ(map.overallMean, 0.25);
  EXPECT_EQ(map.sampling, "at the samples of B");
  EXPECT_EQ(makeErrorMap(b, a, options).sampling, "at the samples of A");
  EXPECT_EQ(makeErrorMap(b, a, options).mean[6 * 10 + 3], -0.25);
}

TEST(ErrorMap, HalfDifferenceCornerIsBelowTheHorizon) {
  const FunctionBrdf a = constantBrdf(1), b = constantBrdf(2);
  ErrorMapOptions options;
  options.axes = ErrorAxes::HalfDifference;
  options.intervals = 9;
  const ErrorMap map = makeErrorMap(a, b, options);
  EXPECT_EQ(map.count.back(), 0u);
  EXPECT_EQ(map.mean.back(), 0);
  for (std::size_t d = 0; d < 9; ++d) EXPECT_EQ(map.count[d * 10], 36u);  // theta_h near 0: every phi_d
  EXPECT_EQ(map.largest, 1);
}

TEST(ErrorMap, LeavesOutWhatIsUnknownOrHasNoRelativeError) {
  const FunctionBrdf a = constantBrdf(1);
  const FunctionBrdf unknown([](const Direction&, const Direction&) { return 1.0; }, {},
                             [](const Direction& wi, const Direction&) { return wi[2] > 0.5; });
  ErrorMapOptions options;
  options.intervals = 9;
  const ErrorMap map = makeErrorMap(a, unknown, options);
  EXPECT_EQ(map.count[7], 0u);  // theta_i = 70 degrees
  EXPECT_GT(map.count[5], 0u);
  options.measure = ErrorMeasure::Relative;
  for (std::uint64_t count : makeErrorMap(a, constantBrdf(0), options).count) EXPECT_EQ(count, 0u);
}

TEST(ErrorMap, RefusesWhatItCannotCompare) {
  EXPECT_THROW(makeErrorMap(constantBrdf(1), constantBrdf(1, Channels::rgb()), {}), Error);
  ErrorMapOptions options;
  options.intervals = 1001;
  EXPECT_THROW(makeErrorMap(constantBrdf(1), constantBrdf(1), options), Error);
  options = {};
  options.azimuths = 0;
  EXPECT_THROW(makeErrorMap(constantBrdf(1), constantBrdf(1), options), Error);
  EXPECT_THROW(parseErrorMeasure("l2"), Error);
  EXPECT_THROW(parseErrorAxes("theta_i"), Error);
}

}  // namespace
}  // namespace brdf
