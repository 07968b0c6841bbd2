// Means and standard errors from replicates, against sums worked out by hand and against what is known of the noise.
#include <brdf/base/Error.h>
#include <brdf/render/ReplicateFilm.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace {

using brdf::ReplicateFilm;
constexpr std::size_t kReplicates = ReplicateFilm::kReplicates;

}  // namespace

TEST(ReplicateFilm, MeanAndStandardErrorAreThoseOfTheReplicates) {
  // One pixel; replicate r has the mean r in red, 2 r in green and 3 in blue, in two frames of 1 and 3 points.
  ReplicateFilm film(1, 1);
  for (std::size_t r = 0; r < kReplicates; ++r) {
    const auto value = static_cast<float>(r);
    film.add(r, std::vector<float>{value + 3, 2 * value, 3, 1}, 1);
    film.add(r, std::vector<float>{value - 1, 2 * value, 3, 1}, 3);
  }
  EXPECT_EQ(film.points(), 4 * kReplicates);
  EXPECT_EQ(film.mean().values, (std::vector<float>{3.5f, 7, 3, 1}));
  // Variance of 0, 1, ... 7 with 7 degrees of freedom is 6.
  const auto error = film.standardError().values;
  EXPECT_FLOAT_EQ(error[0], static_cast<float>(std::sqrt(6.0 / 8)));
  EXPECT_FLOAT_EQ(error[1], static_cast<float>(2 * std::sqrt(6.0 / 8)));
  EXPECT_EQ(error[2], 0);
  const double luminance = 0.2126 * 3.5 + 0.7152 * 7 + 0.0722 * 3;
  EXPECT_NEAR(film.relativeError(), (0.2126 + 2 * 0.7152) * std::sqrt(6.0 / 8) / luminance, 1e-12);
}

TEST(ReplicateFilm, TheStandardErrorIsThatOfKnownNoise) {
  // Numbers of mean 5 and deviation 2: the mean of n replicates of m points is off by 2 / sqrt(n m).
  constexpr std::size_t side = 64, frames = 16;
  ReplicateFilm film(side, side);
  std::mt19937 engine(7);
  std::normal_distribution<float> noise(5, 2);
  std::vector<float> frame(4 * side * side);
  for (std::size_t f = 0; f < frames * kReplicates; ++f) {
    for (float& value : frame) value = noise(engine);
    film.add(f % kReplicates, frame, 1);
  }
  const double expected = 2 / std::sqrt(double(frames * kReplicates));
  double claimed = 0, made = 0;
  const auto mean = film.mean().values, error = film.standardError().values;
  for (std::size_t i = 0; i < error.size(); ++i) {
    claimed += double(error[i]) * double(error[i]);
    made += std::pow(double(mean[4 * (i / 3) + i % 3]) - 5, 2);
  }
  const double count = 3 * side * side;
  // Chi-square of 7 * 12288 and 12288 degrees of freedom: relative deviations of the roots 0.24 % and 0.64 %.
  EXPECT_NEAR(std::sqrt(claimed / count), expected, 0.01 * expected);
  EXPECT_NEAR(std::sqrt(made / count), expected, 0.026 * expected);
  const double weights = std::sqrt(0.2126 * 0.2126 + 0.7152 * 0.7152 + 0.0722 * 0.0722);
  EXPECT_NEAR(film.relativeError(), weights * expected / 5, 0.02 * weights * expected / 5);
}

TEST(ReplicateFilm, ManyFramesLoseNothing) {
  // 0.1f is not a sum of few powers of 2: adding it 100,000 times in float would be off by 1e-4.
  ReplicateFilm film(1, 1);
  const std::vector<float> frame{0.1f, 0.1f, 1e7f, 1};
  for (int f = 0; f < 100000; ++f) film.add(static_cast<std::size_t>(f) % kReplicates, frame, 3);
  EXPECT_EQ(film.mean().values[0], 0.1f);
  EXPECT_EQ(film.mean().values[2], 1e7f);
  EXPECT_LT(film.standardError().values[0], 1e-12);
}

TEST(ReplicateFilm, WhatIsNotFiniteIsCountedAndBlackIsConverged) {
  ReplicateFilm film(1, 1);
  for (std::size_t r = 0; r < kReplicates; ++r) film.add(r, std::vector<float>{0, 0, 0, 1}, 1);
  EXPECT_EQ(film.relativeError(), 0);
  const float infinite = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  film.add(0, std::vector<float>{infinite, nan, 1, 1}, 1);
  EXPECT_EQ(film.notFinite(), 2u);
  EXPECT_TRUE(std::isfinite(film.mean().values[0]));
}

TEST(ReplicateFilm, ASizeThatDoesNotFitIsAnError) {
  EXPECT_THROW(ReplicateFilm(0, 5), brdf::Error);
  EXPECT_THROW(ReplicateFilm(4097, 4096), brdf::Error);
  EXPECT_THROW(ReplicateFilm(std::size_t{1} << 40, std::size_t{1} << 40), brdf::Error);
  ReplicateFilm film(2, 2);
  EXPECT_THROW(film.add(0, std::vector<float>(12), 1), brdf::Error);
  EXPECT_THROW(film.add(kReplicates, std::vector<float>(16), 1), brdf::Error);
}
