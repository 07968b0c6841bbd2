#include "SimulationSupport.h"

#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace brdf {
namespace {

using testing::isotropicLayout, testing::simulated, testing::facetedSurface, testing::wavyField;

constexpr double kSigmas = 5;

/// A case with everything that chance decides: splitting, roulette, colours that part, absorption.
Microsurface colouredGlass() {
  return facetedSurface(wavyField(2), {"dielectric(eta=1.45 1.5 1.6, absorption=0.1 0.5 2)"});
}

TEST(SimulationStatistics, ThreadsChangeNothing) {
  const Microsurface surface = colouredGlass();
  setThreadCount(1);
  const LobeSimulation one = simulated(surface, isotropicLayout({50}), 50, 0, 30'000);
  setThreadCount(4);
  const LobeSimulation four = simulated(surface, isotropicLayout({50}), 50, 0, 30'000);
  setThreadCount(0);
  EXPECT_EQ(one.tally().reflected.sum, four.tally().reflected.sum);
  EXPECT_EQ(one.tally().reflected.square, four.tally().reflected.square);
  EXPECT_EQ(one.tally().outcomes.sum, four.tally().outcomes.sum);
  EXPECT_EQ(one.tally().segments, four.tally().segments);
}

TEST(SimulationStatistics, ARayIsTheSameInWhateverBatch) {
  const Microsurface surface = colouredGlass();
  const LobeSimulation whole = simulated(surface, isotropicLayout({50}), 50, 0, 5000);
  LobeSimulation parts = simulated(surface, isotropicLayout({50}), 50, 0, 1234);
  parts.add(766);
  parts.add(3000);
  EXPECT_EQ(whole.tally().rays, parts.tally().rays);
  for (std::size_t k = 0; k < whole.tally().reflected.sum.size(); ++k)
    EXPECT_NEAR(whole.tally().reflected.sum[k], parts.tally().reflected.sum[k], 1e-9);
}

TEST(SimulationStatistics, SeedsAreIndependentAndTheErrorsAreTheirScatter) {
  // `seeds` estimates of the same figures: their scatter against the errors they state. The sum of squared deviations
  // from their mean, in units of the error, is chi-square of seeds - 1 degrees of freedom; and estimates of
  // neighbouring seeds are not correlated.
  constexpr std::size_t seeds = 100;
  const Microsurface surface = colouredGlass();
  const auto transport = std::shared_ptr<Transport>(makeTransport("cpu", surface));
  const GridLayout layout = isotropicLayout({50});
  std::vector<std::vector<Estimate>> figures;
  for (std::size_t seed = 0; seed < seeds; ++seed) {
    LobeSimulation lobe(transport, surface.channels, layout, radians(50.0), 0, seed);
    lobe.add(4000);
    const EnergyBalance balance = lobe.balance();
    std::vector<Estimate> list = balance.reflected;
    for (const auto* more : {&balance.transmitted, &balance.absorbed, &balance.sum})
      list.insert(list.end(), more->begin(), more->end());
    for (const std::size_t bin : {2, 12, 30, 48}) list.push_back(lobe.value(0, bin));
    figures.push_back(std::move(list));
  }
  for (std::size_t f = 0; f < figures[0].size(); ++f) {
    double mean = 0, chi2 = 0, variance = 0, neighbours = 0;
    for (const auto& list : figures) mean += list[f].value / seeds;
    for (const auto& list : figures) variance += list[f].error * list[f].error / seeds;
    ASSERT_GT(variance, 0) << f;
    for (std::size_t s = 0; s < seeds; ++s) {
      chi2 += std::pow(figures[s][f].value - mean, 2) / variance;
      if (s > 0) neighbours += (figures[s][f].value - mean) * (figures[s - 1][f].value - mean) / variance;
    }
    EXPECT_NEAR(chi2, seeds - 1, kSigmas * std::sqrt(2.0 * (seeds - 1))) << "figure " << f;
    EXPECT_NEAR(neighbours, 0, kSigmas * std::sqrt(double(seeds))) << "figure " << f;
  }
}

TEST(SimulationStatistics, FourTimesTheRaysHalveTheError) {
  const Microsurface surface = facetedSurface(wavyField(1), {"lambertian(albedo=0.7)"});
  const LobeSimulation few = simulated(surface, isotropicLayout({30}), 30, 0, 50'000);
  const LobeSimulation many = simulated(surface, isotropicLayout({30}), 30, 0, 200'000);
  EXPECT_NEAR(few.noise() / many.noise(), 2, 0.05);
  EXPECT_NEAR(few.balance().reflected[0].error / many.balance().reflected[0].error, 2, 0.05);
}

TEST(SimulationStatistics, RaysAreAddedUntilTheToleranceIsMet) {
  const Microsurface surface = facetedSurface(wavyField(1), {"lambertian(albedo=0.7)"});
  GonioreflectometerOptions options;
  options.layout = isotropicLayout({0, 40});
  options.tolerance = 0.02;
  const GonioreflectometerResult bins = simulateBrdf(surface, options);
  EXPECT_TRUE(bins.converged);
  for (const EnergyBalance& balance : bins.balance) {
    EXPECT_LE(balance.noise, 0.02);
    EXPECT_GT(balance.noise, 0.01);  // and not many more than that takes
  }
  options.toleranceOf = ToleranceOf::Albedo;
  options.tolerance = 0.0005;
  const GonioreflectometerResult albedo = simulateBrdf(surface, options);
  EXPECT_TRUE(albedo.converged);
  for (const EnergyBalance& balance : albedo.balance) EXPECT_LE(balance.reflected[0].error, 0.0005);
  options.maximumRays = 20'000;
  const GonioreflectometerResult short_ = simulateBrdf(surface, options);
  EXPECT_TRUE(short_.complete);
  EXPECT_FALSE(short_.converged);
  for (const EnergyBalance& balance : short_.balance) EXPECT_EQ(balance.rays, 20'000);
}

TEST(SimulationStatistics, LightCutByTheBouncesIsLostAndNothingElse) {
  // A white cavity, two bounces: what would bounce more often is lost, and the lost light says that it did not
  // converge.
  const Microsurface surface = facetedSurface(testing::vGrooves(), {"lambertian(albedo=1)"});
  GonioreflectometerOptions options;
  options.layout = isotropicLayout({20});
  options.tolerance = 0.05;
  options.transport.bounces = 2;
  const GonioreflectometerResult cut = simulateBrdf(surface, options);
  EXPECT_FALSE(cut.converged);
  const EnergyBalance& balance = cut.balance[0];
  EXPECT_GT(balance.lost[0].value, 0.05);
  EXPECT_NEAR(balance.lost[0].value + balance.reflected[0].value, 1, 1e-9);
  EXPECT_NEAR(balance.absorbed[0].value, 0, 1e-12);
}

TEST(SimulationStatistics, StoppingKeepsWhatIsDone) {
  const Microsurface surface = facetedSurface(wavyField(1), {"mirror"});
  GonioreflectometerOptions options;
  options.layout = isotropicLayout({0, 20, 40});
  options.progress = [](const GonioreflectometerProgress& progress) { return progress.done < 2; };
  const GonioreflectometerResult result = simulateBrdf(surface, options);
  EXPECT_FALSE(result.complete);
  ASSERT_EQ(result.balance.size(), 2u);
  const GridData& data = result.brdf->data();
  const std::size_t bins = data.layout.cells() / 3;
  for (std::size_t cell = 0; cell < 3 * bins; ++cell)
    EXPECT_EQ(data.states[cell], stateByte(cell < 2 * bins ? CellState::Measured : CellState::Invalid));
}

TEST(SimulationStatistics, OptionsOutOfRangeAreRefused) {
  const Microsurface surface = facetedSurface(testing::flatField(), {"mirror"});
  const auto refused = [&](auto change) {
    GonioreflectometerOptions options;
    options.layout = isotropicLayout({0, 20});
    change(options);
    EXPECT_THROW(simulateBrdf(surface, options), Error);
  };
  refused([](auto& o) { o.layout = isotropicLayout({0, 90}); });
  refused([](auto& o) { o.layout.axes.pop_back(); });
  refused([](auto& o) { o.layout.axes[0] = GridAxis::uniformNodes(AxisQuantity::ThetaO, 0, 1, 5); });
  refused([](auto& o) { o.tolerance = 0; });
  refused([](auto& o) { o.maximumRays = 1; });
  refused([](auto& o) { o.transport.bounces = 0; });
  refused([](auto& o) { o.backend = "abacus"; });
}

}  // namespace
}  // namespace brdf
