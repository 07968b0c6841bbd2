#include "SimpleBrdfs.h"

#include <brdf/base/Error.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/view/ChannelChoice.h>
#include <brdf/view/Curve.h>
#include <brdf/view/ValueErrors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

using test::FunctionBrdf;

std::size_t indexOf(const Curve& curve, double angleDegrees) {
  for (std::size_t i = 0; i < curve.count(); ++i)
    if (std::abs(degrees(curve.angle[i]) - angleDegrees) < 1e-9) return i;
  ADD_FAILURE() << "no point at " << angleDegrees;
  return 0;
}

/// f = cos(angle between wo and the mirror direction)^20 where positive: a Phong lobe, maximum 1.
FunctionBrdf phong() {
  return FunctionBrdf([](const Direction& wi, const Direction& wo) {
    return std::pow(std::max(wi[2] * wo[2] - wi[0] * wo[0] - wi[1] * wo[1], 0.0), 20);
  });
}

TEST(Curve, APhongLobeInThePlaneOfIncidenceIsAPowerOfTheCosineFromTheMirrorDirection) {
  CurveOptions options;
  options.thetaI = radians(30);
  options.phiI = radians(77);
  options.intervals = 180;
  const Curve curve = makeCurve(phong(), options);
  EXPECT_DOUBLE_EQ(curve.angle.front(), -kPi / 2);
  EXPECT_DOUBLE_EQ(curve.angle.back(), kPi / 2);
  for (int angle = -89; angle < 90; ++angle) {
    const std::size_t i = indexOf(curve, angle);
    EXPECT_NEAR(curve.values[i], std::pow(std::max(std::cos(radians(angle - 30)), 0.0), 20), 1e-13) << angle;
    EXPECT_EQ(curve.states[i], 1);
  }
  // Across the plane the mirror direction is 30 degrees from the normal of that plane's line.
  options.phi = kPi / 2;
  const Curve across = makeCurve(phong(), options);
  for (const int angle : {-60, 0, 45})
    EXPECT_NEAR(across.values[indexOf(across, angle)], std::pow(std::cos(radians(30)) * std::cos(radians(angle)), 20),
                1e-13);
}

TEST(Curve, OverTheAzimuthAPhongLobeFollowsTheCosineRule) {
  CurveOptions options;
  options.angle = CurveAngle::Phi;
  options.thetaI = radians(50);
  options.thetaO = radians(35);
  options.intervals = 72;
  const Curve curve = makeCurve(phong(), options);
  for (int angle = -180; angle <= 180; angle += 5) {
    const double c = std::cos(radians(50)) * std::cos(radians(35)) -
                     std::sin(radians(50)) * std::sin(radians(35)) * std::cos(radians(angle));
    EXPECT_NEAR(curve.values[indexOf(curve, angle)], std::pow(std::max(c, 0.0), 20), 1e-13) << angle;
  }
}

TEST(Curve, HalfAndDifferenceAnglesAreThoseOfTheDirections) {
  const FunctionBrdf halfAngle([](const Direction& wi, const Direction& wo) {
    return 1 + std::atan2(std::hypot(wi[0] + wo[0], wi[1] + wo[1]), wi[2] + wo[2]);
  });
  const FunctionBrdf differenceAngle(
      [](const Direction& wi, const Direction& wo) { return 1 + test::angleBetween(wi, wo) / 2; });
  CurveOptions options;
  options.intervals = 90;
  for (const double phiD : {0.0, 45.0, 90.0, 200.0}) {
    options.phiD = radians(phiD);
    options.phiH = radians(10 + phiD);
    for (const CurveAngle angle : {CurveAngle::ThetaH, CurveAngle::ThetaD}) {
      options.angle = angle;
      options.thetaH = options.thetaD = radians(25);
      const bool half = angle == CurveAngle::ThetaH;
      const Curve moving = makeCurve(half ? halfAngle : differenceAngle, options);
      const Curve still = makeCurve(half ? differenceAngle : halfAngle, options);
      for (const int at : {1, 20, 40, 60}) {
        const std::size_t i = indexOf(moving, at);
        ASSERT_EQ(moving.states[i], still.states[i]);
        if (moving.states[i] == kBelowHorizon) continue;
        EXPECT_NEAR(moving.values[i], 1 + radians(at), 1e-13);
        EXPECT_NEAR(still.values[i], 1 + radians(25), 1e-13);
      }
    }
  }
}

TEST(Curve, BelowTheHorizonIsSaidAndNotZero) {
  CurveOptions options;
  options.angle = CurveAngle::ThetaH;
  options.thetaD = radians(40);
  options.phiD = 0;  // light and viewer in the plane of the half vector: one sinks at theta_h = 50 degrees
  options.intervals = 90;
  const Curve curve = makeCurve(test::constantBrdf(2), options);
  EXPECT_EQ(curve.states[indexOf(curve, 49)], 1);
  EXPECT_EQ(curve.values[indexOf(curve, 49)], 2);
  EXPECT_EQ(curve.states[indexOf(curve, 51)], kBelowHorizon);
  EXPECT_EQ(curve.states[indexOf(curve, 90)], kBelowHorizon);
  // The horizon itself has the limit.
  const Curve plane = makeCurve(test::constantBrdf(2), {});
  EXPECT_EQ(plane.values.front(), 2);
  EXPECT_EQ(plane.values.back(), 2);
}

TEST(Curve, APeakOfAThousandthOfADegreeIsNotMissed) {
  const FunctionBrdf needle([](const Direction& wi, const Direction& wo) {
    const double angle = test::angleBetween({-wi[0], -wi[1], wi[2]}, wo);
    return 1e-12 + 1e9 * std::exp(-std::pow(angle / radians(0.001), 2));
  });
  CurveOptions options;
  options.thetaI = radians(33.3333);
  const Curve curve = makeCurve(needle, options);
  const auto highest = std::max_element(curve.values.begin(), curve.values.end());
  EXPECT_NEAR(*highest, 1e9, 1);
  EXPECT_NEAR(degrees(curve.angle[static_cast<std::size_t>(highest - curve.values.begin())]), 33.3333, 1e-9);
  EXPECT_NEAR(*std::min_element(curve.values.begin(), curve.values.end()), 1e-12, 1e-24);
  for (std::size_t i = 1; i < curve.count(); ++i) EXPECT_GT(curve.angle[i], curve.angle[i - 1]);
}

TEST(Curve, WithoutAValueIsNotZero) {
  const FunctionBrdf half([](const Direction&, const Direction&) { return 1.0; }, {},
                          [](const Direction&, const Direction& wo) { return wo[0] > 0; });
  CurveOptions options;
  options.phi = 0;
  const Curve curve = makeCurve(half, options);
  EXPECT_EQ(curve.states[indexOf(curve, 30)], 1);
  EXPECT_EQ(curve.states[indexOf(curve, -30)], 0);
}

TEST(Curve, OptionsOutOfRangeAreRefusedByName) {
  CurveOptions options;
  options.thetaI = kPi / 2;
  EXPECT_THROW(makeCurve(phong(), options), Error);
  options = {};
  options.intervals = 0;
  EXPECT_THROW(makeCurve(phong(), options), Error);
  EXPECT_THROW(parseCurveAngle("theta"), Error);
  for (const char* name : {"theta_o", "phi", "theta_h", "theta_d", "phi_d"})
    EXPECT_EQ(curveAngleName(parseCurveAngle(name)), name);
}

/// Samples in the plane of incidence of theta_i = 30 degrees, turned by 10 degrees each; RGB = (1, 2, 4) times the
/// index, with errors of a tenth.
std::shared_ptr<ScatteredBrdf> goniometer() {
  ScatteredSamples samples;
  samples.channels = Channels::rgb();
  const std::vector<double> angles{-60, -20, 0, 20, 50};
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double phi = radians(10.0 * static_cast<double>(k));
    samples.pairs.push(fromSpherical(radians(30), phi), fromSpherical(radians(angles[k]), phi + kPi));
  }
  samples.pairs.push(fromSpherical(radians(30.4), 1), fromSpherical(radians(70), 1 + kPi));  // 0.4 degrees off
  samples.pairs.push(fromSpherical(radians(45), 1), fromSpherical(radians(10), 1 + kPi));
  samples.pairs.push(fromSpherical(radians(30), 1), fromSpherical(radians(40), 1 + kPi / 2));
  for (const double channel : {1.0, 2.0, 4.0})
    for (std::size_t i = 0; i < samples.pairs.size(); ++i) {
      samples.values.push_back(channel * static_cast<double>(i + 1));
      samples.uncertainty.push_back(0.1 * samples.values.back());
    }
  return std::make_shared<ScatteredBrdf>(samples, "goniometer");
}

TEST(CurveSamples, MeasurementsByThePlaneAreFoundHoweverTheSurfaceWasTurned) {
  const auto brdf = goniometer();
  CurveOptions options;
  options.thetaI = radians(30);
  options.phiI = radians(-50);
  const CurveSamples near = samplesByCurve(*brdf, options, radians(0.5));
  ASSERT_EQ(near.count(), 6u);
  const std::vector<double> angles{-60, -20, 0, 20, 50, 70};
  for (std::size_t i = 0; i < near.count(); ++i) {
    const auto k = static_cast<std::size_t>(std::lround(near.values[i])) - 1;
    EXPECT_NEAR(degrees(near.angle[i]), angles[k], 1e-6);
    EXPECT_NEAR(near.standardErrors[i], 0.1 * near.values[i], 1e-15);
    EXPECT_NEAR(degrees(near.distance[i]), k == 5 ? 0.4 : 0, 1e-6);
  }
  EXPECT_EQ(samplesByCurve(*brdf, options, radians(0.3)).count(), 5u);
  const CurveSamples few = samplesByCurve(*brdf, options, radians(0.5), 4);
  EXPECT_EQ(few.count(), 4u);
  EXPECT_EQ(few.leftOut, 2u);
  options.phi = kPi / 2;
  const CurveSamples across = samplesByCurve(*brdf, options, radians(0.5));
  ASSERT_EQ(across.count(), 2u);  // the one at 90 degrees, and the one at the normal
  EXPECT_EQ(samplesByCurve(phong(), options, 1).count(), 0u);
}

TEST(CurveSamples, EveryKindOfCurveFindsASampleThatLiesOnIt) {
  CurveOptions options;
  options.thetaI = radians(35);
  options.phiI = 0.3;
  options.thetaO = radians(55);
  options.phi = radians(140);
  options.thetaH = radians(20);
  options.thetaD = radians(30);
  options.phiH = 0.9;
  options.phiD = radians(50);
  for (const bool isotropic : {true, false})
    for (const CurveAngle angle :
         {CurveAngle::ThetaO, CurveAngle::Phi, CurveAngle::ThetaH, CurveAngle::ThetaD, CurveAngle::PhiD}) {
      options.angle = angle;
      ScatteredSamples samples;
      for (const double at : {12.0, 33.0}) {
        const DirectionPair pair = curveDirections(options, radians(at));
        samples.pairs.push(pair.wi, pair.wo);
        samples.values.push_back(at);
      }
      samples.isotropic = isotropic;
      const CurveSamples near = samplesByCurve(ScatteredBrdf(samples, "two"), options, radians(0.01));
      ASSERT_EQ(near.count(), 2u) << curveAngleName(angle);
      for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(degrees(near.angle[i]), near.values[i], 1e-6);
    }
}

TEST(ValueErrors, OfAWeightedSumAreTheSumOfWeightedErrors) {
  const auto brdf = goniometer();
  const ChannelView view(brdf, Channels::monochrome(), {0.5, -1, 2}, "view");
  const ValueErrors errors(view);
  ASSERT_TRUE(errors.knownOfSamples());
  EXPECT_FALSE(errors.knownOfValues());
  EXPECT_NEAR(errors.ofSample(2, 0), 3 * 0.1 * (0.5 * 1 + 1 * 2 + 2 * 4), 1e-14);

  GridData data;
  data.layout.axes = {GridAxis::listedDegrees(AxisQuantity::ThetaO, {0, 80}),
                      GridAxis::listedDegrees(AxisQuantity::ThetaI, {0, 80})};
  data.channels = Channels::rgb();
  data.values.assign(12, 1);
  data.standardError = {1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, std::nan("")};
  const auto grid = std::make_shared<GridBrdf>(data, "grid");
  const ChannelChoice green = chooseChannels(grid, "1"), luminance = chooseChannels(grid, "luminance");
  CurveOptions options;
  options.thetaI = radians(20);
  options.intervals = 18;
  const Curve curve = makeCurve(*green.brdf, options);
  ASSERT_EQ(curve.standardErrors.size(), curve.count());
  EXPECT_NEAR(curve.standardErrors[indexOf(curve, 40)], 2, 1e-12);
  const Curve all = makeCurve(*luminance.brdf, options);
  EXPECT_TRUE(std::isnan(all.standardErrors[indexOf(all, 40)]));  // one of the cells' is unknown
}

}  // namespace
}  // namespace brdf
