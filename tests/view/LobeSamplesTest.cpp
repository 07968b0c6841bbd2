#include "SimpleBrdfs.h"

#include <brdf/base/Error.h>
#include <brdf/material/SampleSet.h>
#include <brdf/view/LobeSamples.h>

#include <gtest/gtest.h>

namespace brdf {
namespace {

using test::angleBetween;
using test::constantBrdf;
using test::FunctionBrdf;

/// Samples at pairs given, each with the value 8 times its number, beginning at 1.
class Samples : public SampleSet {
 public:
  explicit Samples(std::vector<DirectionPair> pairs) : pairs_(std::move(pairs)) {}
  std::size_t count() const override { return pairs_.size(); }
  const Channels& channels() const override { return channels_; }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    if (pairs) pairs->resize(length);
    for (std::size_t i = 0; i < length; ++i) {
      const DirectionPair& pair = pairs_[first + i];
      if (pairs) pairs->set(i, pair.wi, pair.wo);
      if (values) values[i] = 8.0 * static_cast<double>(first + i + 1);
      if (valid) valid[i] = 1;
    }
  }

 private:
  std::vector<DirectionPair> pairs_;
  Channels channels_;
};

class Measured : public FunctionBrdf {
 public:
  Measured(std::vector<DirectionPair> pairs, Symmetry symmetry, bool reciprocal)
      : FunctionBrdf([](const Direction&, const Direction&) { return 0.0; }),
        samples_(std::move(pairs)),
        symmetry_(symmetry),
        reciprocal_(reciprocal) {}
  const SampleSet* samples() const override { return &samples_; }
  Symmetry symmetry() const override { return symmetry_; }
  bool reciprocal() const override { return reciprocal_; }

 private:
  Samples samples_;
  Symmetry symmetry_;
  bool reciprocal_;
};

Direction at(double theta, double phi) { return fromSpherical(radians(theta), radians(phi)); }

TEST(LobeSamples, AreTurnedToTheIncidentAzimuth) {
  const Measured brdf({{at(45, 10), at(30, 190)}, {at(46, 200), at(20, 230)}, {at(50, 0), at(10, 0)}},
                      Symmetry::Isotropic, false);
  LobeSampleOptions options;
  options.phiI = radians(100);
  const LobeSamples samples = lobeSamples(brdf, options);
  ASSERT_EQ(samples.directions.size(), 2u);  // the third is 5 degrees away
  EXPECT_EQ(samples.found, 2u);
  EXPECT_LT(angleBetween(samples.directions[0], at(30, 280)), 1e-12);
  EXPECT_LT(angleBetween(samples.directions[1], at(20, 130)), 1e-12);
  EXPECT_EQ(samples.values, (std::vector<double>{8, 16}));
  EXPECT_TRUE(samples.residuals.empty());
  options.thetaI = radians(51.5);
  EXPECT_EQ(lobeSamples(brdf, options).found, 1u);
  options.thetaI = radians(57);
  EXPECT_EQ(lobeSamples(brdf, options).found, 0u);
  EXPECT_NEAR(lobeSamples(brdf, options).nearest, radians(7), 1e-12);
}

TEST(LobeSamples, OfAnAnisotropicBrdfMustHaveTheAzimuthToo) {
  const Measured brdf({{at(45, 10), at(30, 190)}, {at(45, 101), at(20, 230)}}, Symmetry::Anisotropic, false);
  LobeSampleOptions options;
  options.phiI = radians(100);
  const LobeSamples samples = lobeSamples(brdf, options);
  ASSERT_EQ(samples.directions.size(), 1u);
  EXPECT_LT(angleBetween(samples.directions[0], at(20, 230)), 1e-12);
}

TEST(LobeSamples, OfAReciprocalBrdfCountWithLightAndViewerExchanged) {
  const Measured brdf({{at(10, 0), at(45, 180)}}, Symmetry::Isotropic, true);
  const LobeSamples samples = lobeSamples(brdf, {});
  ASSERT_EQ(samples.directions.size(), 1u);
  EXPECT_LT(angleBetween(samples.directions[0], at(10, 180)), 1e-12);
}

TEST(LobeSamples, ResidualsAreModelLessMeasuredInTransformedLength) {
  const Measured brdf({{at(45, 0), at(30, 190)}, {at(45, 0), at(60, 190)}}, Symmetry::Isotropic, false);
  const FunctionBrdf model = constantBrdf(64);
  LobeSampleOptions options;
  options.scale = {LobeTransform::CubeRoot};
  const LobeSamples samples = lobeSamples(brdf, options, &model);
  ASSERT_EQ(samples.residuals.size(), 2u);
  EXPECT_NEAR(samples.residuals[0], 4 - 2, 1e-14);
  EXPECT_NEAR(samples.residuals[1], 4 - std::cbrt(16.0), 1e-14);
}

TEST(LobeSamples, OfManyEvenlySpreadOnesAreKept) {
  std::vector<DirectionPair> pairs;
  for (int k = 0; k < 1000; ++k) pairs.push_back({at(45, 0), at(89.0 * k / 1000, 180)});
  const Measured brdf(pairs, Symmetry::Isotropic, false);
  LobeSampleOptions options;
  options.maximum = 100;
  const LobeSamples samples = lobeSamples(brdf, options);
  EXPECT_EQ(samples.found, 1000u);
  EXPECT_LE(samples.directions.size(), 100u);
  EXPECT_GE(samples.directions.size(), 50u);
  for (std::size_t i = 1; i < samples.values.size(); ++i)
    EXPECT_EQ(samples.values[i] - samples.values[i - 1], samples.values[1] - samples.values[0]);
}

TEST(LobeSamples, RefusesWhatItCannotShow) {
  EXPECT_THROW(lobeSamples(constantBrdf(1), {}), Error);
  const Measured brdf({}, Symmetry::Isotropic, false);
  EXPECT_EQ(lobeSamples(brdf, {}).found, 0u);
  LobeSampleOptions options;
  options.within = -1;
  EXPECT_THROW(lobeSamples(brdf, options), Error);
  const FunctionBrdf colour = constantBrdf(1, Channels::rgb());
  EXPECT_THROW(lobeSamples(brdf, {}, &colour), Error);
}

}  // namespace
}  // namespace brdf
