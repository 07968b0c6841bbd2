#include <brdf/fit/Fit.h>

#include <gtest/gtest.h>

#include "SyntheticTarget.h"

namespace brdf {
namespace {

TEST(Compare, ConstantBrdfsHaveTheDifferencesOfTheDefinition) {
  const auto a = parseMaterialExpression("0.5*Lambertian"), b = parseMaterialExpression("0.2*Lambertian");
  const Comparison comparison = compare(*a, *b);
  EXPECT_NEAR(comparison.metrics.at("rms"), 0.3 / kPi, 1e-13);
  EXPECT_NEAR(comparison.zeroModel.at("rms"), 0.2 / kPi, 1e-13);
  // Mean of cos^2 over a hemisphere of equal solid angles: 1/3 - 1/(12 n^2) with n = 48 midpoints.
  const double meanSquare = 1.0 / 3 - 1.0 / (12 * 48 * 48);
  EXPECT_NEAR(comparison.metrics.at("rms_cos"), 0.3 / kPi * std::sqrt(meanSquare), 1e-12);
  EXPECT_NE(comparison.sampling.find("both hemispheres"), std::string::npos);
}

TEST(Compare, UsesTheSecondsOwnSamplesAndAveragesOverChannels) {
  ScatteredSamples samples;
  samples.channels = Channels::rgb();
  samples.pairs.push(fromSpherical(radians(60), 0), fromSpherical(radians(30), kPi));
  samples.pairs.push(fromSpherical(0, 0), fromSpherical(radians(30), kPi));
  samples.values = {1, 2, 3, 4, 5, 6};  // planar: channel by channel
  const ScatteredBrdf measured(samples, "two samples");
  const auto zero = parseMaterialExpression("(0,0,0)*Lambertian");
  const Comparison comparison = compare(*zero, measured);
  EXPECT_EQ(comparison.samples, 2u);
  EXPECT_EQ(comparison.channels, 3u);
  EXPECT_NEAR(comparison.metrics.at("rms"), std::sqrt((1 + 4 + 9 + 16 + 25 + 36) / 6.0), 1e-14);
  EXPECT_NEAR(comparison.metrics.at("rms_cos"), std::sqrt((0.25 * (1 + 9 + 25) + 4 + 16 + 36) / 6.0), 1e-13);
  double log = 0, cubeRoot = 0;
  for (const double w : {0.5, 2.0, 1.5, 4.0, 2.5, 6.0}) {
    log += std::log(1 + w) * std::log(1 + w);
    cubeRoot += std::pow(w, 2.0 / 3);
  }
  EXPECT_NEAR(comparison.metrics.at("log"), std::sqrt(log / 6), 1e-13);
  EXPECT_NEAR(comparison.metrics.at("cuberoot"), std::sqrt(cubeRoot / 6), 1e-13);
  EXPECT_EQ(comparison.metrics, comparison.zeroModel);
}

TEST(Compare, UsesTheFirstsSamplesWhenTheSecondHasNone) {
  const ScatteredBrdf measured = syntheticTarget("0.3*Lambertian + 0.5*GGX(alpha=0.2, ior=1.5)", 200);
  const auto same = parseMaterialExpression("0.3*Lambertian + 0.5*GGX(alpha=0.2, ior=1.5)");
  const Comparison comparison = compare(measured, *same);
  EXPECT_EQ(comparison.samples, 200u);
  EXPECT_LT(comparison.metrics.at("rms"), 1e-12 * comparison.zeroModel.at("rms"));
}

TEST(Compare, LeavesOutSamplesBeyondTheThetaLimit) {
  ScatteredSamples samples;
  samples.pairs.push(fromSpherical(radians(20), 0), fromSpherical(radians(30), kPi));
  samples.pairs.push(fromSpherical(radians(85), 0), fromSpherical(radians(30), kPi));
  samples.values = {1, 100};
  const ScatteredBrdf measured(samples, "one at grazing");
  const Comparison comparison = compare(*parseMaterialExpression("0*Lambertian"), measured, 80);
  EXPECT_EQ(comparison.samples, 1u);
  EXPECT_DOUBLE_EQ(comparison.zeroModel.at("rms"), 1);
}

TEST(Compare, OneChannelAgainstColourIsTakenAsLuminance) {
  const auto grey = parseMaterialExpression("0.5*Lambertian"),
             colour = parseMaterialExpression("(0.5,0.5,0.5)*Lambertian");
  const Comparison comparison = compare(*grey, *colour);
  EXPECT_EQ(comparison.channels, 1u);
  EXPECT_LT(comparison.metrics.at("rms"), 1e-15);
}

}  // namespace
}  // namespace brdf
