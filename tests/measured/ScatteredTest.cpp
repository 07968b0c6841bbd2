#include <brdf/material/ChannelView.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/measured/Format.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "MeasuredSupport.h"

namespace {

using brdf::Direction;
using brdf::ScatteredBrdf;
using brdf::ScatteredSamples;
using Function = measuredtest::FunctionBrdf::Function;

Direction random(std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(0, 1);
  return brdf::fromSpherical(std::acos(std::sqrt(0.02 + 0.98 * uniform(engine))), 2 * brdf::kPi * uniform(engine));
}

ScatteredSamples sampled(std::size_t count, bool isotropic, const Function& function, unsigned seed = 1) {
  std::mt19937 engine(seed);
  ScatteredSamples samples;
  samples.isotropic = isotropic;
  for (std::size_t i = 0; i < count; ++i) {
    const Direction wi = random(engine), wo = random(engine);
    samples.pairs.push(wi, wo);
    samples.values.push_back(function(wi, wo, 0));
  }
  return samples;
}

Direction turned(const Direction& w, double angle) {
  return {std::cos(angle) * w[0] - std::sin(angle) * w[1], std::sin(angle) * w[0] + std::cos(angle) * w[1], w[2]};
}

}  // namespace

TEST(ScatteredBrdf, GivesEachSampleItsOwnValueAtItsDirections) {
  for (const bool isotropic : {true, false}) {
    // Values over many decades, zero and negative ones among them.
    const ScatteredSamples samples = sampled(500, isotropic, [](const Direction& wi, const Direction& wo, std::size_t) {
      return std::sinh(20 * wi[0] * wo[1]) + (wi[0] > 0.5 ? 0 : 1e-6);
    });
    const ScatteredBrdf brdf(samples, "test");
    std::vector<double> values(500);
    std::vector<std::uint8_t> valid(500);
    brdf.evaluate(samples.pairs.view(), values.data(), valid.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_NEAR(values[i], samples.values[i], 1e-9 * std::abs(samples.values[i]) + 1e-12) << i;
      EXPECT_EQ(valid[i], 1);
    }
  }
}

TEST(ScatteredBrdf, IsotropicValuesDoNotChangeWhenTurnedOrMirrored) {
  const ScatteredBrdf brdf(sampled(300, true, measuredtest::glossy), "test");
  std::mt19937 engine(7);
  for (int i = 0; i < 50; ++i) {
    const Direction wi = random(engine), wo = random(engine);
    const double value = brdf.evaluate(wi, wo)[0];
    EXPECT_NEAR(brdf.evaluate(turned(wi, 1.1), turned(wo, 1.1))[0], value, 1e-9 * value);
    EXPECT_NEAR(brdf.evaluate({wi[0], -wi[1], wi[2]}, {wo[0], -wo[1], wo[2]})[0], value, 1e-9 * value);
  }
}

TEST(ScatteredBrdf, InterpolationErrorShrinksWithTheSamples) {
  for (const bool isotropic : {true, false}) {
    const ScatteredSamples probes = sampled(500, isotropic, measuredtest::glossy, 99);
    double previous = HUGE_VAL;
    for (const std::size_t count : {200u, 2000u, 20000u}) {
      const ScatteredBrdf brdf(sampled(count, isotropic, measuredtest::glossy), "test");
      std::vector<double> values(500);
      brdf.evaluate(probes.pairs.view(), values.data(), nullptr);
      double sum = 0;
      for (std::size_t i = 0; i < values.size(); ++i) sum += std::pow(values[i] - probes.values[i], 2);
      const double rms = std::sqrt(sum / 500);
      EXPECT_LT(rms, previous / 1.5) << count;
      previous = rms;
    }
    EXPECT_LT(previous, isotropic ? 0.02 : 0.2);  // of a peak of 3
  }
}

TEST(ScatteredBrdf, SamplesComeInTheirOrderBlockByBlock) {
  const ScatteredSamples samples = sampled(10, true, measuredtest::glossy);
  const ScatteredBrdf brdf(samples, "test");
  brdf::DirectionPairBuffer<double> pairs;
  double values[3];
  std::uint8_t valid[3];
  brdf.samples()->read(4, 3, &pairs, values, valid);
  ASSERT_EQ(pairs.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(pairs.wi[0][i], samples.pairs.wi[0][4 + i]);
    EXPECT_EQ(values[i], samples.values[4 + i]);
    EXPECT_EQ(valid[i], 1);
  }
}

TEST(ScatteredBrdf, UnusableSamplesAreInvalidAndDoNotSpreadNan) {
  ScatteredSamples samples = sampled(20, true, measuredtest::glossy);
  samples.values[3] = std::nan("");
  samples.pairs.wo[2][5] = -0.1;
  const ScatteredBrdf brdf(std::move(samples), "test");
  std::vector<std::uint8_t> valid(20);
  brdf.samples()->read(0, 20, nullptr, nullptr, valid.data());
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(valid[i], i != 3 && i != 5) << i;
  std::mt19937 engine(3);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(std::isfinite(brdf.evaluate(random(engine), random(engine))[0]));
}

TEST(ScatteredBrdf, BelowTheHorizonIsZeroAndValid) {
  const ScatteredBrdf brdf(sampled(20, true, measuredtest::glossy), "test");
  brdf::DirectionPairBuffer<double> pairs(1);
  pairs.set(0, {0, 0, 1}, {0.6, 0, -0.8});
  double value = 1;
  std::uint8_t valid = 0;
  brdf.evaluate(pairs.view(), &value, &valid);
  EXPECT_EQ(value, 0);
  EXPECT_EQ(valid, 1);
}

TEST(ScatteredBrdf, FewSamplesAndCoincidentOnesAreEnough) {
  for (const std::size_t count : {1u, 2u, 8u, 9u}) {
    ScatteredSamples samples;
    for (std::size_t i = 0; i < count; ++i) {
      samples.pairs.push({0, 0, 1}, {0.6, 0, 0.8});
      samples.values.push_back(2);
    }
    const ScatteredBrdf brdf(std::move(samples), "test");
    EXPECT_NEAR(brdf.evaluate({0, 0, 1}, {0.6, 0, 0.8})[0], 2, 1e-12);
    EXPECT_NEAR(brdf.evaluate({0, 0.6, 0.8}, {0.8, 0, 0.6})[0], 2, 1e-12);
  }
}

TEST(ScatteredBrdf, WithoutAValidSampleEverythingIsInvalid) {
  ScatteredSamples samples = sampled(1, true, measuredtest::glossy);
  samples.valid = {0};
  const ScatteredBrdf brdf(std::move(samples), "test");
  brdf::DirectionPairBuffer<double> pairs(1);
  pairs.set(0, {0, 0, 1}, {0, 0, 1});
  double value = 1;
  std::uint8_t valid = 1;
  brdf.evaluate(pairs.view(), &value, &valid);
  EXPECT_EQ(value, 0);
  EXPECT_EQ(valid, 0);
}

TEST(ScatteredBrdf, ArraysOfDifferentLengthsAreAnError) {
  ScatteredSamples samples = sampled(5, true, measuredtest::glossy);
  samples.values.pop_back();
  EXPECT_THROW(ScatteredBrdf(std::move(samples), "test"), brdf::Error);
}

namespace {

/// Median of |difference| / value when the samples that `group` gives one number are predicted from all the others.
double heldBackError(const ScatteredSamples& all, const std::vector<int>& group) {
  std::vector<double> errors;
  for (const int held : std::set<int>(group.begin(), group.end())) {
    ScatteredSamples others = all;
    others.valid.assign(all.values.size(), 1);
    for (std::size_t i = 0; i < group.size(); ++i) others.valid[i] = group[i] != held;
    const ScatteredBrdf brdf(std::move(others), "others");
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (group[i] != held) continue;
      double value = 0;
      brdf.evaluate(all.pairs.view().slice(i, 1), &value, nullptr);
      EXPECT_GE(value, 0);
      errors.push_back(std::abs(value / all.values[i] - 1));
    }
  }
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
  return errors[errors.size() / 2];
}

}  // namespace

TEST(ScatteredBrdf, PredictsHeldBackMeasurementsAsWellAsItsDocumentationSays) {
  const struct {
    const char* name;
    double eachFromOthers, fromOtherIncidences;
  } cases[] = {{"garnet_red", 0.0148, 0.031}, {"acryl_blue", 0.0347, 0.089}};
  for (const auto& [name, eachFromOthers, fromOtherIncidences] : cases) {
    const auto path = std::filesystem::path(BRDF_SHARED_DIR) / "data/measured" / (std::string(name) + ".brdf");
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no file " << path;
    const auto luminance = brdf::asLuminance(brdf::readMeasured(path).brdf);
    ScatteredSamples all;
    all.values.resize(luminance->samples()->count());
    luminance->samples()->read(0, all.values.size(), &all.pairs, all.values.data(), nullptr);
    std::vector<int> each(all.values.size()), incidence;
    std::iota(each.begin(), each.end(), 0);
    for (std::size_t i = 0; i < each.size(); ++i)
      incidence.push_back(static_cast<int>(std::lround(std::acos(all.pairs.wi[2][i]) * 180 / brdf::kPi)));
    EXPECT_NEAR(heldBackError(all, each), eachFromOthers, 0.0005) << name;
    EXPECT_NEAR(heldBackError(all, incidence), fromOtherIncidences, 0.0015) << name;
  }
}

TEST(ScatteredBrdf, DoesNotGoNegativeWhereNoSampleIs) {
  // Samples that fall steeply to zero: a linear fit would shoot below.
  const ScatteredBrdf brdf(sampled(400, true,
                                   [](const Direction& wi, const Direction& wo, std::size_t) {
                                     return std::max(0.0, 5 * (wi[2] * wo[2] - 0.4));
                                   }),
                           "test");
  std::mt19937 engine(11);
  for (int i = 0; i < 3000; ++i) EXPECT_GE(brdf.evaluate(random(engine), random(engine))[0], 0);
}
