#include "SimpleBrdfs.h"

#include <brdf/base/Error.h>
#include <brdf/fit/Fit.h>
#include <brdf/material/SampleSet.h>
#include <brdf/view/ErrorMap.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

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

ErrorMapOptions options(std::string_view measure, std::size_t intervals, ErrorAxes axes = ErrorAxes::IncidentOutgoing) {
  ErrorMapOptions options;
  options.measure = parseErrorMeasure(measure);
  options.grid = {.axes = axes, .intervals = intervals};
  return options;
}

TEST(ErrorMap, ConstantBrdfsGiveTheClosedFormOfEveryMetric) {
  const FunctionBrdf a = constantBrdf(0.5, Channels::rgb()), b = constantBrdf(0.2, Channels::rgb());
  const double c = std::cos(radians(60));  // node 6 of 9
  const std::map<std::string, double> expected{
      {"difference", 0.3},
      {"absolute", 0.3},
      {"rms", 0.3},
      {"rms_cos", 0.3 * c},
      {"ngan", 0.3 * c},
      {"log", std::log(1 + 0.5 * c) - std::log(1 + 0.2 * c)},
      {"cuberoot", std::cbrt(0.5 * c) - std::cbrt(0.2 * c)},
      {"relative", 1.5},
      {"relative:0.6", 0.5},
      {"huber", std::sqrt(2 * 0.2 * 0.3 - 0.2 * 0.2)},  // scale: the median, 0.2
      {"huber:0.1", std::sqrt(2 * 0.1 * 0.3 - 0.1 * 0.1)},
      {"formula:f^2", 0.25 - 0.04}};
  for (const std::string& name : metricNames()) EXPECT_EQ(expected.count(name), 1u) << name;
  for (const auto& [measure, value] : expected)
    for (const char* average : {"automatic", "rms", "absolute", "signed"}) {
      ErrorMapOptions wanted = options(measure, 9);
      wanted.measure = parseErrorMeasure(measure, average);
      wanted.azimuths = 4;
      const ErrorMap map = makeErrorMap(a, b, wanted);
      SCOPED_TRACE(measure + " " + average);
      EXPECT_EQ(map.count[3 * 10 + 6], 12u);  // 4 azimuths, 3 channels
      EXPECT_NEAR(map.mean[3 * 10 + 6], value, 1e-12);
      for (std::size_t channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(map.channelMean[channel * 100 + 3 * 10 + 6], value, 1e-12);
    }
}

TEST(ErrorMap, ErrorOfLambertiansIsConstantOverEveryKindOfAxes) {
  const FunctionBrdf a = constantBrdf(0.9 / kPi), b = constantBrdf(0.4 / kPi);
  for (const std::string& axes : errorAxesNames())
    for (const std::string& projection : diskProjectionNames()) {
      ErrorMapOptions wanted = options("difference", 24, parseErrorAxes(axes));
      wanted.grid.projection = parseDiskProjection(projection);
      const ErrorMap map = makeErrorMap(a, b, wanted);
      std::size_t counted = 0;
      for (std::size_t node = 0; node < map.mean.size(); ++node) {
        if (map.count[node] == 0) continue;
        ++counted;
        ASSERT_NEAR(map.mean[node], 0.5 / kPi, 1e-15) << axes;
      }
      EXPECT_GT(counted, map.mean.size() / 2);
      EXPECT_NEAR(map.overallMean, 0.5 / kPi, 1e-14);
      EXPECT_EQ(map.errors.size(), map.weights.size());
      for (double error : map.errors) ASSERT_NEAR(error, 0.5 / kPi, 1e-15);
    }
}

TEST(ErrorMap, OverallIsWhatCompareSays) {
  // At directions chosen: to quadrature.
  const FunctionBrdf a([](const Direction& wi, const Direction& wo) { return 0.2 + wi[2] * wo[2]; });
  const FunctionBrdf b([](const Direction& wi, const Direction& wo) { return 0.5 + 0.3 * dot(wi, wo) + wo[2]; });
  const Comparison comparison = compare(a, b);
  for (const auto& [name, value] : comparison.metrics)
    for (ErrorAxes axes : {ErrorAxes::IncidentOutgoing, ErrorAxes::HalfDifference, ErrorAxes::DifferenceAzimuth})
      EXPECT_NEAR(makeErrorMap(a, b, options(name, 60, axes)).overallMean / value, 1, 0.01) << name;
}

TEST(ErrorMap, SignedDifferenceTurnsWithItsOperands) {
  const FunctionBrdf a([](const Direction& wi, const Direction&) { return wi[2]; });
  const FunctionBrdf b([](const Direction&, const Direction& wo) { return wo[2] * wo[2]; });
  const ErrorMapOptions wanted = options("difference", 12);
  const ErrorMap ab = makeErrorMap(a, b, wanted), ba = makeErrorMap(b, a, wanted);
  for (std::size_t i = 0; i < ab.mean.size(); ++i) EXPECT_EQ(ab.mean[i], -ba.mean[i]);
  EXPECT_EQ(ab.overallMean, -ba.overallMean);
  EXPECT_EQ(ab.largest, ba.largest);
  EXPECT_EQ(makeErrorMap(a, a, wanted).largest, 0);
  EXPECT_TRUE(makeErrorMap(a, a, wanted).worst.empty());
}

/// A table of 12 x 12 x 12 cells of two angles and the azimuth between, with solid angles, of value 1 + cos(theta_i).
class Cells : public SampleSet {
 public:
  std::size_t count() const override { return 12 * 12 * 12; }
  const Channels& channels() const override { return channels_; }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    if (pairs) pairs->resize(length);
    for (std::size_t i = 0; i < length; ++i) {
      const auto [thetaI, thetaO, phi] = anglesOf(first + i);
      if (pairs) pairs->set(i, fromSpherical(thetaI, 0), fromSpherical(thetaO, phi));
      if (values) values[i] = 1 + std::cos(thetaI);
      if (valid) valid[i] = 1;
    }
  }
  bool solidAngles(std::size_t first, std::size_t length, double* measures) const override {
    for (std::size_t i = 0; i < length; ++i) {
      const auto [thetaI, thetaO, phi] = anglesOf(first + i);
      measures[i] = std::sin(thetaI) * std::sin(thetaO);
    }
    return true;
  }

 private:
  static std::array<double, 3> anglesOf(std::size_t cell) {
    const auto angle = [](std::size_t k) { return (static_cast<double>(k) + 0.5) * kPi / 24; };
    return {angle(cell % 12), angle(cell / 12 % 12), 2 * angle(cell / 144)};
  }
  Channels channels_;
};

class Measured : public FunctionBrdf {
 public:
  Measured() : FunctionBrdf([](const Direction& wi, const Direction&) { return 1 + wi[2]; }) {}
  const SampleSet* samples() const override { return &samples_; }

 private:
  Cells samples_;
};

TEST(ErrorMap, ComparesAtTheSamplesOfTheMeasuredOne) {
  const FunctionBrdf a = constantBrdf(1.25, Channels::spectral({500, 600}));
  const MeasuredBrdf b;
  const ErrorAxes axes = ErrorAxes::IncidentOutgoing;
  EXPECT_EQ(automaticIntervals(a, b, axes, ErrorDirections::Automatic), 9u);
  EXPECT_EQ(automaticIntervals(a, b, axes, ErrorDirections::Chosen), 90u);
  EXPECT_EQ(automaticIntervals(a, b, ErrorAxes::Hemisphere, ErrorDirections::Automatic), 180u);
  const ErrorMapOptions wanted = options("difference", 0);
  const ErrorMap map = makeErrorMap(a, b, wanted);
  std::uint64_t counted = 0;
  for (std::uint64_t count : map.count) counted += count;
  EXPECT_EQ(counted, 4u);                 // two valid samples, two channels
  EXPECT_EQ(map.count[6 * 10 + 3], 4u);   // theta_i 30 and 32, theta_o 60 and 58: the node at (30, 60)
  EXPECT_EQ(map.mean[6 * 10 + 3], 0.25);  // to the samples' values, not to the interpolated 77
  EXPECT_EQ(map.overallMean, 0.25);
  EXPECT_EQ(map.sampling, "at the samples of B");
  EXPECT_EQ(map.errors, (std::vector<double>{0.25, 0.25}));
  EXPECT_TRUE(map.weights.empty());
  EXPECT_EQ(map.leftOut, 1u);
  EXPECT_EQ(makeErrorMap(b, a, wanted).sampling, "at the samples of A");
  EXPECT_EQ(makeErrorMap(b, a, wanted).mean[6 * 10 + 3], -0.25);
  EXPECT_THROW(makeErrorMap(a, b, options("ngan", 0)), Error);  // scattered: no cells
  ErrorMapOptions onDisk = options("rms", 8, ErrorAxes::Hemisphere);
  onDisk.grid.thetaI = radians(31);
  onDisk.directions = ErrorDirections::Samples;
  EXPECT_EQ(makeErrorMap(a, b, onDisk).errors.size(), 2u);
  onDisk.grid.thetaI = radians(34);
  EXPECT_EQ(makeErrorMap(a, b, onDisk).errors.size(), 1u);
}

TEST(ErrorMap, OnCellsOfATableOverallIsExactlyWhatCompareSays) {
  const Measured table;
  const FunctionBrdf a([](const Direction& wi, const Direction& wo) { return 0.4 + wi[2] * wo[2] * wo[2]; });
  const Comparison comparison = compare(a, table);
  EXPECT_EQ(comparison.metrics.count("ngan"), 1u);
  for (const auto& [name, value] : comparison.metrics) {
    const ErrorMap map = makeErrorMap(a, table, options(name, 7));
    EXPECT_NEAR(map.overallMean, value, 1e-13 * value) << name;
    EXPECT_EQ(map.errors.size(), comparison.samples);
  }
}

TEST(ErrorMap, ListsTheWorstPairOfEachNode) {
  const FunctionBrdf a([](const Direction& wi, const Direction& wo) {
    return std::exp(-std::pow(test::angleBetween({-wi[0], -wi[1], wi[2]}, wo) / 0.3, 2));
  });
  const FunctionBrdf b = constantBrdf(0.25);
  ErrorMapOptions wanted = options("difference", 18);
  wanted.worst = 25;
  const ErrorMap map = makeErrorMap(a, b, wanted);
  ASSERT_EQ(map.worst.size(), 25u);
  std::map<std::size_t, double> worst;  // by brute force
  map.grid.visit(wanted.azimuths, Symmetry::Isotropic, [&](const DirectionPair& pair, double) {
    double& of = worst[map.grid.nodeOf(pair.wi, pair.wo, Symmetry::Isotropic)];
    of = std::max(of, std::abs(a.evaluate(pair.wi, pair.wo)[0] - 0.25));
  });
  std::vector<double> sorted;
  for (const auto& [node, error] : worst) sorted.push_back(error);
  std::sort(sorted.rbegin(), sorted.rend());
  for (std::size_t k = 0; k < 25; ++k) {
    const WorstPair& one = map.worst[k];
    EXPECT_NEAR(std::abs(one.error), sorted[k], 1e-15);
    EXPECT_EQ(one.a[0], a.evaluate(one.pair.wi, one.pair.wo)[0]);
    EXPECT_EQ(one.error, one.a[0] - one.b[0]);
    EXPECT_EQ(one.node, map.grid.nodeOf(one.pair.wi, one.pair.wo, Symmetry::Isotropic));
  }
  EXPECT_EQ(std::accumulate(map.count.begin(), map.count.end(), std::uint64_t{0}), map.errors.size());

  wanted.grid.intervals = 90;  // nodes of a degree: 5 apart along x or y
  wanted.azimuths = 4;
  const ErrorMap fine = makeErrorMap(a, b, wanted);
  EXPECT_EQ(fine.worst.size(), 25u);
  for (std::size_t i = 0; i < fine.worst.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const int x = static_cast<int>(fine.worst[i].node % 91) - static_cast<int>(fine.worst[k].node % 91);
      const int y = static_cast<int>(fine.worst[i].node / 91) - static_cast<int>(fine.worst[k].node / 91);
      EXPECT_GE(std::max(std::abs(x), std::abs(y)), 5);
    }
}

TEST(ErrorMap, WhatIsNotFiniteIsLeftOut) {
  const FunctionBrdf broken([](const Direction& wi, const Direction&) { return wi[2] > 0.5 ? 1.0 : std::nan(""); });
  const ErrorMap map = makeErrorMap(broken, constantBrdf(0.5), options("absolute", 9));
  EXPECT_GT(map.leftOut, 0u);
  EXPECT_EQ(map.overallMean, 0.5);
  for (double error : map.errors) ASSERT_EQ(error, 0.5);
  const ErrorMap none = makeErrorMap(constantBrdf(HUGE_VAL), constantBrdf(0.5), options("absolute", 9));
  EXPECT_TRUE(none.errors.empty());
  EXPECT_EQ(none.overallMean, 0);
  EXPECT_THROW(makeErrorMap(constantBrdf(0), constantBrdf(0.5), options("formula:log(f)", 9)), Error);
}

TEST(ErrorMap, HalfDifferenceCornerIsBelowTheHorizon) {
  const ErrorMap map =
      makeErrorMap(constantBrdf(1), constantBrdf(2), options("absolute", 9, ErrorAxes::HalfDifference));
  EXPECT_EQ(map.count.back(), 0u);
  EXPECT_EQ(map.mean.back(), 0);
  for (std::size_t d = 0; d < 9; ++d) EXPECT_EQ(map.count[d * 10], 36u);  // theta_h near 0: every phi_d
  EXPECT_EQ(map.largest, 1);
}

TEST(ErrorMap, LeavesOutWhatIsUnknown) {
  const FunctionBrdf unknown([](const Direction&, const Direction&) { return 1.0; }, {},
                             [](const Direction& wi, const Direction&) { return wi[2] > 0.5; });
  const ErrorMap map = makeErrorMap(constantBrdf(1), unknown, options("absolute", 9));
  EXPECT_EQ(map.count[7], 0u);  // theta_i = 70 degrees
  EXPECT_GT(map.count[5], 0u);
}

TEST(ErrorMap, RefusesWhatItCannotCompare) {
  EXPECT_THROW(makeErrorMap(constantBrdf(1), constantBrdf(1, Channels::rgb()), {}), Error);
  EXPECT_THROW(makeErrorMap(constantBrdf(1, Channels::spectral({400, 500})),
                            constantBrdf(1, Channels::spectral({400, 600})), {}),
               Error);
  const auto refused = [](auto change) {
    ErrorMapOptions wanted;
    change(wanted);
    EXPECT_THROW(makeErrorMap(constantBrdf(1), constantBrdf(1), wanted), Error);
  };
  refused([](ErrorMapOptions& o) { o.grid.intervals = 1001; });
  refused([](ErrorMapOptions& o) { o.azimuths = 0; });
  refused([](ErrorMapOptions& o) { o.grid.intervals = 1000, o.azimuths = 10'000; });
  refused([](ErrorMapOptions& o) { o.worst = 10'001; });
  refused([](ErrorMapOptions& o) { o.directions = ErrorDirections::Samples; });
  refused([](ErrorMapOptions& o) { o.grid.thetaI = kPi / 2; });
  refused([](ErrorMapOptions& o) { o.grid.within = -1; });
  EXPECT_THROW(parseErrorMeasure("l2"), Error);
  EXPECT_THROW(parseErrorMeasure("sphere"), Error);
  EXPECT_THROW(parseErrorMeasure("rms", "median"), Error);
  EXPECT_THROW(parseErrorDirections("all"), Error);
}

TEST(ErrorMeasure, LabelsNameBothMaterialsAndTheUnit) {
  EXPECT_EQ(errorMeasureLabel(parseErrorMeasure("absolute")), "mean of |f_A - f_B| (1/sr)");
  EXPECT_EQ(errorMeasureLabel(parseErrorMeasure("difference")), "mean of f_A - f_B (1/sr)");
  EXPECT_EQ(errorMeasureLabel(parseErrorMeasure("cuberoot")),
            "rms of cbrt(f_A cos(theta_i)) - cbrt(f_B cos(theta_i)) (sr^-1/3)");
  EXPECT_EQ(errorTermLabel(parseErrorMeasure("log", "signed")), "ln(1 + f_A cos(theta_i)) - ln(1 + f_B cos(theta_i))");
}

}  // namespace
}  // namespace brdf
