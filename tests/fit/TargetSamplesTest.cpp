#include <brdf/base/Error.h>
#include <brdf/fit/ConstantModel.h>
#include <brdf/fit/Fit.h>
#include <brdf/fit/TargetSamples.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/PatchBrdf.h>
#include <brdf/material/TableBrdf.h>

#include <gtest/gtest.h>

#include <numeric>

#include "SyntheticTarget.h"

namespace brdf {
namespace {

LobeRequest lobe(const std::string& name) { return {findModel(name), {}, {}, {}}; }

const char* const kGlossy = "0.3*Lambertian + 0.5*GGX(alpha=0.2, ior=1.5)";

/// The weighted mean square of the values, and its standard error, taken from the samples themselves.
struct Mean {
  double value = 0, error = 0;
};
Mean meanSquare(const TargetSamples& samples) {
  const std::size_t count = samples.set->count();
  const SampleBlock block = readSamples(*samples.set, 0, count, samples.rule.maximumTheta, SampleWeights::SolidAngle);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < block.count; ++i) {
    const double term = block.weights[i] * block.values[i] * block.values[i];
    sum += term;
    squares += term * term;
  }
  const double n = samples.rule.totalWeight.value_or(static_cast<double>(block.count)), mean = sum / n;
  return {mean, std::sqrt((squares / n - mean * mean) / n)};
}

TEST(TargetSamples, ImportanceDrawsEstimateTheHemisphereMeanWithoutBias) {
  const BrdfPointer brdf = parseMaterialExpression(kGlossy);
  for (const double limit : {75.0, 50.0}) {  // towards 90 the mean of f^2 grows without bound
    const double exact = meanSquare(takeSamples(brdf, {Sampling::Hemisphere, 500'000, 1, false}, limit)).value;
    double worst = 0, sum = 0;
    const int runs = 8;
    for (int seed = 1; seed <= runs; ++seed) {
      const Mean mean =
          meanSquare(takeSamples(brdf, {Sampling::Importance, 20'000, static_cast<std::uint64_t>(seed), false}, limit));
      worst = std::max(worst, std::abs(mean.value - exact) / mean.error);
      sum += (mean.value - exact) / mean.error;
    }
    EXPECT_LT(worst, 4) << limit;                                    // standard deviations
    EXPECT_LT(std::abs(sum) / std::sqrt(double(runs)), 3) << limit;  // of the mean of the runs
  }
}

TEST(TargetSamples, ImportanceIsSurerThanAsManyUniformDraws) {
  const BrdfPointer brdf = parseMaterialExpression("0.1*Lambertian + 0.5*GGX(alpha=0.05, ior=1.5)");
  const TargetSamples drawn = takeSamples(brdf, {Sampling::Importance, 50'000, 1, false}, 90);
  const SampleBlock block = readSamples(*drawn.set, 0, drawn.set->count(), 90, SampleWeights::SolidAngle);
  // The variance of uniform draws, estimated with the same samples: mean of f^4 less the mean of f^2 squared.
  double fourth = 0, second = 0;
  for (std::size_t i = 0; i < block.count; ++i) {
    const double square = block.values[i] * block.values[i];
    fourth += block.weights[i] * square * square / 50'000;
    second += block.weights[i] * square / 50'000;
  }
  EXPECT_LT(meanSquare(drawn).error, 0.5 * std::sqrt((fourth - second * second) / 50'000));
}

TEST(TargetSamples, SameSeedSameDraws) {
  const BrdfPointer brdf = parseMaterialExpression(kGlossy);
  const auto mean = [&](std::uint64_t seed) {
    return meanSquare(takeSamples(brdf, {Sampling::Importance, 1000, seed, false}, 90)).value;
  };
  EXPECT_EQ(mean(5), mean(5));
  EXPECT_NE(mean(5), mean(6));
}

TEST(TargetSamples, AFormulaIsFittedOnEverySamplingButItsOwn) {
  const auto target = parseMaterialExpression(kGlossy);
  FitOptions options;
  options.tolerance = 1e-12;
  for (const Sampling sampling : {Sampling::Automatic, Sampling::Hemisphere, Sampling::Importance}) {
    options.samples = {sampling, 5000, 1, false};
    const FitReport report = fit(*target, {lobe("Lambertian"), lobe("GGX")}, options);
    EXPECT_LT(report.error, 1e-8) << report.sampling;
    EXPECT_NEAR(report.material->lobes()[1].parameters[0][0], 0.2, 1e-6);
  }
  options.samples = {Sampling::All, 0, 1, false};
  EXPECT_THROW(fit(*target, {lobe("Lambertian")}, options), Error);
}

TEST(TargetSamples, AMeasuredTargetMayBeFittedAwayFromItsSamples) {
  const auto table = TableBrdf::tabulate(*parseMaterialExpression(kGlossy), {.phiD = 36, .thetaD = 18, .thetaH = 18});
  FitOptions options;
  options.maximumTheta = 75;
  options.samples = {Sampling::Hemisphere, 20'000, 1, false};
  const FitReport report = fit(*table, {lobe("Lambertian"), lobe("GGX")}, options);
  EXPECT_NE(report.sampling.find("equal solid angles"), std::string::npos);
  EXPECT_EQ(report.samples, report.offered);
  EXPECT_EQ(report.maximumTheta, 75);
  EXPECT_NEAR(report.material->lobes()[0].scale[0], 0.3, 0.02);  // interpolation is not exact
}

TEST(TargetSamples, CellsOfTheWholeHemisphereAddUpToItsMeasure) {
  // d omega_i d omega_o over both hemispheres is (2 pi)^2; cells of a half-difference table reach below the horizon and
  // add up to the integral of 4 cos(theta_d) d omega_h d omega_d, which is 4 (2 pi)(pi) = 8 pi^2.
  const auto total = [](const SampleSet& set) {
    std::vector<double> measures(set.count());
    EXPECT_TRUE(set.solidAngles(0, set.count(), measures.data()));
    return std::accumulate(measures.begin(), measures.end(), 0.0);
  };
  const auto material = parseMaterialExpression("0.5*Lambertian");
  const auto table = TableBrdf::tabulate(*material, {.phiD = 12, .thetaD = 9, .thetaH = 7, .reciprocal = false});
  EXPECT_NEAR(2 * kPi * total(*table->samples()), 8 * kPi * kPi, 1e-12);  // phi_h is not among the axes

  GridLayout layout;
  layout.axes = {GridAxis::uniformNodes(AxisQuantity::ThetaI, 0, kPi / 2, 7),
                 GridAxis::uniformCells(AxisQuantity::ThetaO, 0, kPi / 2, 5, AxisScale::Cosine),
                 GridAxis::uniformNodes(AxisQuantity::PhiDifference, 0, 1.75 * kPi, 8).periodic()};
  const auto grid = GridBrdf::tabulate(*material, layout);
  EXPECT_NEAR(2 * kPi * total(*grid->samples()), 4 * kPi * kPi, 1e-12);

  PatchData patches;
  patches.values.assign(patches.incident.count() * patches.outgoing.count(), 0.1);
  EXPECT_NEAR(total(*PatchBrdf(patches, "").samples()), 4 * kPi * kPi, 1e-10);
}

TEST(TargetSamples, CellsOfAHalfDifferenceTableMeasureDirectionPairs) {
  // Among pairs uniform in both hemispheres, the share that falls in a cell is its measure, where it lies above the
  // horizon: counted for a block of cells near the normal, against its solid angle over (2 pi)^2.
  const TableLayout layout{.phiD = 4, .thetaD = 6, .thetaH = 6, .reciprocal = false};
  const auto table = TableBrdf::tabulate(*parseMaterialExpression("0.5*Lambertian"), layout);
  std::vector<double> measures(layout.cells()), counts(layout.cells());
  table->samples()->solidAngles(0, layout.cells(), measures.data());
  std::mt19937_64 random(7);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const int draws = 400'000;
  for (int k = 0; k < draws; ++k) {
    const auto wi = fromSpherical(std::acos(uniform()), 2 * kPi * uniform());
    const auto wo = fromSpherical(std::acos(uniform()), 2 * kPi * uniform());
    const HalfDifference angles = toHalfDifference(wi, wo);
    const auto h = static_cast<std::size_t>(6 * std::sqrt(angles.thetaH / (kPi / 2)));
    const auto d = static_cast<std::size_t>(6 * angles.thetaD / (kPi / 2));
    const auto p = static_cast<std::size_t>((angles.phiD < 0 ? angles.phiD + 2 * kPi : angles.phiD) / (kPi / 2));
    counts[std::min<std::size_t>(p, 3) + 4 * (std::min<std::size_t>(d, 5) + 6 * std::min<std::size_t>(h, 5))] += 1;
  }
  for (std::size_t h = 0; h < 4; ++h)      // theta_h up to 40 degrees
    for (std::size_t d = 0; d < 3; ++d) {  // theta_d up to 45 degrees: all above the horizon
      const std::size_t cell = 4 * (d + 6 * h);
      const double expected = draws * 2 * kPi * measures[cell] / (4 * kPi * kPi);
      EXPECT_LT(std::abs(counts[cell] - expected), 4.5 * std::sqrt(expected)) << h << " " << d;
    }
}

TEST(ConstantModel, IsTheWeightedMeanForQuadraticMetricsAndBruteForceForOthers) {
  const ScatteredBrdf target = syntheticTarget(kGlossy, 700);
  std::vector<double> values(700);
  DirectionPairBuffer<double> pairs;
  target.samples()->read(0, 700, &pairs, values.data(), nullptr);
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < 700; ++i) {
    const double weight = pairs.wi[2][i] * pairs.wi[2][i];
    sum += weight * values[i];
    weights += weight;
  }
  const ConstantModel cosine = bestConstant(FitData::read(*target.samples(), findMetric("rms_cos"), {}));
  EXPECT_NEAR(cosine.values.at(0), sum / weights, 1e-12);

  const auto error = [&](double constant) {
    double squared = 0;
    for (std::size_t i = 0; i < 700; ++i) {
      const double difference = std::cbrt(constant * pairs.wi[2][i]) - std::cbrt(values[i] * pairs.wi[2][i]);
      squared += difference * difference;
    }
    return std::sqrt(squared / 700);
  };
  double best = 0;
  for (double constant = 0; constant < 1; constant += 1e-4)
    if (error(constant) < error(best)) best = constant;
  const ConstantModel root = bestConstant(FitData::read(*target.samples(), findMetric("cuberoot"), {}));
  EXPECT_NEAR(root.values.at(0), best, 2e-4);
  EXPECT_NEAR(root.error, error(best), 1e-6 * error(best));
}

TEST(Fit, SaysWhatOfTheTargetItUsed) {
  const ScatteredBrdf target = syntheticTarget("(0.3,0.2,0.1)*Lambertian + 0.5*GGX(alpha=0.2, ior=1.5)", 300);
  FitOptions options;
  options.maximumTheta = 60;
  options.channels = {FitChannels::Kind::List, {1}};
  const FitReport report = fit(target, {lobe("Lambertian"), lobe("GGX")}, options);
  EXPECT_EQ(report.offered, 300u);
  EXPECT_LT(report.samples, 300u);
  EXPECT_EQ(report.channelNames, "1");
  EXPECT_EQ(report.weights, "none");
  EXPECT_EQ(report.constantModel.size(), 1u);
  EXPECT_LT(report.constantError, report.zeroModel.at("rms"));
  EXPECT_GT(report.constantError, report.error);
}

TEST(Fit, WeightsBySolidAngleAreThoseOfEveryMetric) {
  const auto table = TableBrdf::tabulate(*parseMaterialExpression(kGlossy), {.phiD = 12, .thetaD = 9, .thetaH = 12});
  FitOptions options;
  options.metric = "rms_cos";
  options.samples.solidAngles = true;
  const FitReport weighted = fit(*table, {lobe("Lambertian")}, options);
  options.metric = "ngan";
  options.samples.solidAngles = false;
  const FitReport ngan = fit(*table, {lobe("Lambertian")}, options);
  EXPECT_EQ(weighted.weights, "solid-angle");
  EXPECT_NEAR(weighted.parameters[0].value, ngan.parameters[0].value, 1e-13);
  EXPECT_NEAR(weighted.error, ngan.error, 1e-13);
  EXPECT_NEAR(weighted.metrics.at("rms_cos"), weighted.metrics.at("ngan"), 1e-14);
}

}  // namespace
}  // namespace brdf
