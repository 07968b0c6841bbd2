#include <brdf/base/Error.h>
#include <brdf/fit/Fit.h>
#include <brdf/fit/NoiseWeights.h>
#include <brdf/fit/Samples.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/LobeSum.h>
#include <brdf/simulate/SurfaceRandom.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kTruth = "0.3*Lambertian + 0.5*GGX(alpha=0.3)";

GridData exactTable(const char* expression) {
  GridLayout layout;
  layout.symmetry.mirror = true;
  layout.axes = {GridAxis::uniformCells(AxisQuantity::PhiDifference, 0, kPi, 12),
                 GridAxis::uniformCells(AxisQuantity::ThetaO, 0, radians(80), 12),
                 GridAxis::uniformCells(AxisQuantity::ThetaI, 0, radians(80), 6)};
  return GridBrdf::tabulate(*parseMaterialExpression(expression), layout)->data();
}

/// Noise of 2 % of the value in some cells, of 40 % in the others, and the errors that say so.
GridData noisyTable(const GridData& exact, std::uint64_t seed) {
  GridData noisy = exact;
  noisy.standardError.resize(exact.values.size());
  SurfaceRandom random(seed);
  for (std::size_t k = 0; k < exact.values.size(); ++k) {
    noisy.standardError[k] = (k % 3 == 0 ? 0.02 : 0.4) * exact.values[k];
    noisy.values[k] += noisy.standardError[k] * random.normal();
  }
  return noisy;
}

FitReport fitted(const GridData& data, bool noise, const std::string& metric = "rms") {
  const GridBrdf table(data, "synthetic");
  FitOptions options;
  options.metric = metric;
  options.samples.noise = noise;
  options.scan = false;
  return fit(table, {{findModel("Lambertian"), {}, {}, {}}, {findModel("GGX"), {{"ior", 1.5}}, {{"alpha", 0.25}}, {}}},
             options);
}

const FittedParameter& parameter(const FitReport& report, std::size_t lobe, const std::string& name) {
  for (const FittedParameter& one : report.parameters)
    if (one.lobeIndex == lobe && one.name == name) return one;
  throw std::out_of_range(name);
}

TEST(NoiseWeights, PullsAreStandardNormalAndTheCovarianceIsThatOfManyRepeats) {
  // 400 tables of the same truth with other noise. A pull is (fitted - true) / its reported standard error.
  const GridData exact = exactTable(kTruth);
  constexpr std::size_t repeats = 400;
  struct Number {
    std::size_t lobe;
    const char* name;
    double truth;
    std::vector<double> values{}, errors{};
  };
  std::vector<Number> numbers{{0, "scale", 0.3}, {1, "scale", 0.5}, {1, "alpha", 0.3}};
  double unweighted = 0, weighted = 0, chiSquare = 0;
  for (std::size_t seed = 0; seed < repeats; ++seed) {
    const GridData noisy = noisyTable(exact, seed);
    const FitReport report = fitted(noisy, true);
    for (Number& number : numbers) {
      const FittedParameter found = parameter(report, number.lobe, number.name);
      ASSERT_TRUE(found.standardError.has_value());
      number.values.push_back(found.value);
      number.errors.push_back(*found.standardError);
    }
    chiSquare += std::stod(report.notes.back().substr(std::string("reduced chi-square ").size()));
    weighted += std::pow(numbers[2].values.back() - 0.3, 2);
    if (seed % 8 == 0) unweighted += 8 * std::pow(parameter(fitted(noisy, false), 1, "alpha").value - 0.3, 2);
  }
  const double n = repeats;
  for (const Number& number : numbers) {
    SCOPED_TRACE(std::to_string(number.lobe) + " " + number.name);
    double mean = 0, squares = 0, scatter = 0, reported = 0, average = 0;
    std::vector<double> u;
    for (std::size_t k = 0; k < repeats; ++k) {
      const double pull = (number.values[k] - number.truth) / number.errors[k];
      mean += pull / n;
      squares += pull * pull / n;
      average += number.values[k] / n;
      reported += number.errors[k] * number.errors[k] / n;
      u.push_back(0.5 * std::erfc(-pull / std::sqrt(2.0)));
    }
    for (const double value : number.values) scatter += (value - average) * (value - average) / (n - 1);
    // Mean and mean square of n standard normal numbers: 1/sqrt(n) and sqrt(2/n) from 0 and 1.
    EXPECT_LT(std::abs(mean) * std::sqrt(n), 4);
    EXPECT_LT(std::abs(squares - 1) / std::sqrt(2 / n), 4);
    EXPECT_LT(std::abs(scatter / reported - 1) / std::sqrt(2 / n), 4);
    // Anderson-Darling against the standard normal: beyond 3.857 with probability 1 %.
    std::ranges::sort(u);
    double sum = 0;
    for (std::size_t k = 0; k < repeats; ++k)
      sum += static_cast<double>(2 * k + 1) * (std::log(u[k]) + std::log1p(-u[repeats - 1 - k]));
    EXPECT_LT(-n - sum / n, 3.857);
  }
  // The mean of 400 reduced chi-squares of some 860 degrees of freedom: off by sqrt(2 / 860 / 400).
  EXPECT_NEAR(chiSquare / n, 1, 4 * std::sqrt(2.0 / 860 / n));
  EXPECT_LT(weighted, unweighted / 4);
}

TEST(NoiseWeights, CellsOfUnknownErrorAreLeftOut) {
  const GridData exact = exactTable(kTruth);
  GridData noisy = noisyTable(exact, 1);
  for (std::size_t k = 0; k < noisy.values.size(); k += 5) {
    noisy.values[k] = 1e6;  // must not count
    noisy.standardError[k] = kUnknown;
  }
  const FitReport report = fitted(noisy, true);
  EXPECT_NEAR(parameter(report, 1, "alpha").value, 0.3, 0.02);
  EXPECT_EQ(report.weights, "noise");
  std::size_t known = 0;
  for (std::size_t k = 0; k < noisy.values.size(); ++k)
    known += noisy.states[k] == static_cast<std::uint8_t>(CellState::Measured) && k % 5 != 0;
  EXPECT_EQ(report.samples, known);
}

TEST(NoiseWeights, NoScatterCountsAsTheSmallestTwentieth) {
  GridData data = exactTable("0.5*Lambertian");
  data.standardError.assign(data.values.size(), 0.0);
  std::size_t positive = 0;
  for (std::size_t k = 0; k < data.values.size(); k += 2)
    data.standardError[k] = 0.01 * static_cast<double>(++positive);
  const GridBrdf table(data, "synthetic");
  const NoiseWeightedSamples samples(*table.samples());
  const double expected = 0.01 * static_cast<double>(positive / 20 + 1);
  EXPECT_NEAR(samples.leastError(0), expected, 1e-12);
  double errors[2];
  ASSERT_TRUE(samples.standardErrors(0, 2, errors));
  EXPECT_NEAR(errors[0], 0.01, 1e-12);
  EXPECT_NEAR(errors[1], expected, 1e-12);
}

TEST(NoiseWeights, EachChannelHasItsOwn) {
  GridData data = exactTable("(0.1, 0.2, 0.3)*Lambertian");
  const std::size_t cells = data.layout.cells();
  data.standardError.assign(3 * cells, 0.0);
  for (std::size_t c = 0; c < 2; ++c)
    std::fill_n(data.standardError.begin() + static_cast<std::ptrdiff_t>(c * cells), cells,
                0.1 * static_cast<double>(c + 1));
  data.standardError[2 * cells + 5] = kUnknown;
  const GridBrdf table(data, "synthetic");
  const NoiseWeightedSamples samples(*table.samples());
  const SampleBlock block = readSamples(samples, 0, 8, 90, SampleWeights::Noise);
  ASSERT_EQ(block.count, 7u) << "without the sample whose error is not known in one channel";
  for (std::size_t i = 0; i < block.count; ++i) {
    EXPECT_NEAR(block.weights[i], 100, 1e-9);
    EXPECT_NEAR(block.weights[block.stride + i], 25, 1e-9);
    // No scatter in the third channel at all: as the least of the others.
    EXPECT_NEAR(block.weights[2 * block.stride + i], 100, 1e-9);
  }
  // Luminance: never more than the sum of its parts.
  const BrdfPointer seen =
      selectChannels(std::make_shared<GridBrdf>(table.data(), "synthetic"), {FitChannels::Kind::Luminance, {}});
  double error = 0;
  ASSERT_TRUE(seen->samples()->standardErrors(7, 1, &error));
  EXPECT_NEAR(error, 0.2126 * 0.1 + 0.7152 * 0.2, 1e-6);
}

TEST(NoiseWeights, ChannelsOfDifferentNoiseGiveTheVarianceOfTheirInformation) {
  // Three channels of one shape: 2 % noise in a third of the cells of each channel, another third in each, 40 % in the
  // others. Of independent Gaussian noise the best estimate has the variance 1 / (J' W J) with W = 1 / variance, of
  // every value: what the fit reports. With one weight a sample, from the mean variance over channels, all cells would
  // weigh nearly alike, and the estimate scatter more.
  const GridData exact = exactTable("(0.3, 0.4, 0.5)*Lambertian + (0.5, 0.4, 0.3)*GGX(alpha=0.3)");
  const std::size_t cells = exact.layout.cells();
  constexpr std::size_t repeats = 200;
  double scatter = 0, reported = 0, pulls = 0, chiSquare = 0, ofMeans = 0;
  for (std::size_t seed = 0; seed < repeats; ++seed) {
    GridData noisy = exact;
    noisy.standardError.resize(exact.values.size());
    SurfaceRandom random(seed);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < cells; ++k) {
        const std::size_t at = c * cells + k;
        noisy.standardError[at] = (k % 3 == c ? 0.02 : 0.4) * exact.values[at];
        noisy.values[at] += noisy.standardError[at] * random.normal();
      }
    const FitReport report = fitted(noisy, true);
    const FittedParameter& alpha = parameter(report, 1, "alpha");
    ASSERT_TRUE(alpha.standardError.has_value());
    scatter += std::pow(alpha.value - 0.3, 2) / repeats;
    reported += std::pow(*alpha.standardError, 2) / repeats;
    pulls += std::pow((alpha.value - 0.3) / *alpha.standardError, 2) / repeats;
    chiSquare += std::stod(report.notes.back().substr(std::string("reduced chi-square ").size())) / repeats;
    // One weight a sample: the same mean variance in every channel.
    GridData alike = noisy;
    for (std::size_t k = 0; k < cells; ++k) {
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c) sum += std::pow(noisy.standardError[c * cells + k], 2);
      for (std::size_t c = 0; c < 3; ++c) alike.standardError[c * cells + k] = std::sqrt(sum / 3);
    }
    if (seed % 4 == 0) ofMeans += 4 * std::pow(parameter(fitted(alike, true), 1, "alpha").value - 0.3, 2) / repeats;
  }
  EXPECT_LT(std::abs(scatter / reported - 1) / std::sqrt(2.0 / repeats), 4);
  EXPECT_LT(std::abs(pulls - 1) / std::sqrt(2.0 / repeats), 4);
  EXPECT_NEAR(chiSquare, 1, 4 * std::sqrt(2.0 / 2590 / repeats));
  RecordProperty("ratio", std::to_string(ofMeans / scatter));
  EXPECT_GT(ofMeans, 4 * scatter);
}

TEST(NoiseWeights, ReachMetricsThatAreNotQuadraticAndTheComparison) {
  // Channels whose noise differs tenfold: the report's error is that of the weighted residuals, computed here by hand.
  GridData data = exactTable("(0.3, 0.5, 0.6)*Lambertian");
  const std::size_t cells = data.layout.cells();
  data.standardError.resize(data.values.size());
  SurfaceRandom random(3);
  for (std::size_t k = 0; k < data.values.size(); ++k) {
    data.standardError[k] = (k < cells ? 0.001 : 0.01) * (1 + static_cast<double>(k % 4));
    data.values[k] += data.standardError[k] * random.normal();
  }
  const GridBrdf table(data, "synthetic");
  for (const char* metric : {"rms", "cuberoot"}) {
    FitOptions options;
    options.metric = metric;
    options.samples.noise = true;
    options.scan = false;
    const FitReport report = fit(table, {{findModel("Lambertian"), {}, {}, {}}}, options);
    const auto form = [&](double f) { return metric[0] == 'r' ? f : std::cbrt(f); };
    DirectionPairBuffer<double> pairs;
    data.layout.directions(0, cells, pairs);
    const std::vector<double> values = [&] {
      std::vector<double> list(3 * cells);
      report.material->evaluate(pairs.view(), list.data(), nullptr);
      return list;
    }();
    double squared = 0, weights = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (data.states[k % cells] != stateByte(CellState::Measured)) continue;
      const double weight = 1 / (data.standardError[k] * data.standardError[k]);
      const double cosine = metric[0] == 'r' ? 1 : std::cbrt(pairs.view().wi[2][k % cells]);
      squared += weight * std::pow(cosine * (form(values[k]) - form(data.values[k])), 2);
      weights += weight;
    }
    EXPECT_NEAR(report.error / std::sqrt(squared / weights), 1, 1e-6) << metric << ": " << report.error;
  }
}

TEST(NoiseWeights, RefuseWhatHasNoErrors) {
  const GridData exact = exactTable(kTruth);
  EXPECT_THROW(fitted(exact, true), Error);
  EXPECT_THROW(fitted(noisyTable(exact, 1), true, "ngan"), Error);
  FitOptions options;
  options.samples.noise = true;
  EXPECT_THROW(fit(*parseMaterialExpression(kTruth), {{findModel("Lambertian"), {}, {}, {}}}, options), Error);
  GridData zero = exact;
  zero.standardError.assign(zero.values.size(), 0.0);
  EXPECT_THROW(fitted(zero, true), Error);
}

}  // namespace
}  // namespace brdf
