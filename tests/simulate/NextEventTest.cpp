#include "SimulationSupport.h"

#include <brdf/base/Error.h>
#include <brdf/sampling/PathRandom.h>
#include <brdf/simulate/SurfaceKinds.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace brdf {
namespace {

using testing::anisotropicLayout, testing::flatField, testing::isotropicLayout, testing::simulated,
    testing::facetedSurface;
using Q = AxisQuantity;

constexpr double kSigmas = 5;

TransportOptions with(NextEvent nextEvent) {
  TransportOptions options;
  options.nextEvent = nextEvent;
  return options;
}

GridLayout aboutTheMirror(double theta) {
  return {Parametrisation::Specular,
          {GridAxis::cellsDegrees(Q::SpecularTheta, {0, 5, 20, 50, 90, 130, 180}),
           GridAxis::uniformCells(Q::SpecularPhi, 0, kPi, 4), GridAxis::listedDegrees(Q::ThetaI, {theta})},
          {.mirror = true}};
}

TEST(NextEvent, DirectionsOfABinFillItEvenly) {
  GridLayout quarter{Parametrisation::Spherical,
                     {GridAxis::uniformCells(Q::ThetaO, 0, kPi / 2, 6),
                      GridAxis::uniformCells(Q::PhiO, 0, kPi / 2, 3).periodic(kPi / 2),
                      GridAxis::listedDegrees(Q::ThetaI, {40}), GridAxis::listedDegrees(Q::PhiI, {30})}};
  for (const GridLayout& layout : {anisotropicLayout({40}, {30}), isotropicLayout({40}), aboutTheMirror(40), quarter}) {
    const OutgoingBins bins(layout, radians(40.0), layout.find(Q::PhiI) < layout.axes.size() ? radians(30.0) : 0);
    PathRandom random(5);
    double whole = 0;
    for (std::size_t b = 0; b < bins.count(); ++b) {
      constexpr int draws = 2000;
      double sum = 0, squares = 0;
      for (int k = 0; k < draws; ++k) {
        const double u = random.next(), v = random.next(), image = random.next();
        const Direction wo = bins.direction(b, u, v, image);
        EXPECT_NEAR(dot(wo, wo), 1, 1e-12);
        if (!(wo[2] > 0)) continue;
        EXPECT_EQ(bins.find(wo), b) << layout.text();
        sum += wo[2] / draws;
        squares += wo[2] * wo[2] / draws;
      }
      // The mean cosine times the solid angle is the projected one, here within 5 standard errors.
      const double error = std::sqrt(std::max(squares - sum * sum, 0.0) / draws);
      EXPECT_NEAR(sum * bins.solidAngle(b), bins.projectedSolidAngles()[b],
                  (kSigmas * error + 1e-4) * bins.solidAngle(b))
          << layout.text() << " bin " << b;
      whole += bins.solidAngle(b);
    }
    EXPECT_NEAR(whole, layout.parametrisation == Parametrisation::Specular ? 4 * kPi : 2 * kPi, 1e-9);
  }
}

TEST(NextEvent, AFlatLambertianSurfaceHasHardlyAnyNoise) {
  const Microsurface surface = facetedSurface(flatField(), {"lambertian(albedo=0.6 0.3 0)"});
  for (const double theta : {0.0, 70.0}) {
    const auto lobe =
        simulated(surface, anisotropicLayout({theta}, {0}), theta, 0, 2000, 1, with(NextEvent::Automatic));
    ASSERT_TRUE(lobe.connects());
    // Only the cosine within a bin is left to chance: of a light that is the share cos / mean cos, the variance is that
    // of the cosine's, 1/12 of its spread's square at most.
    for (std::size_t b = 0; b < lobe.bins().count(); ++b)
      for (std::size_t c = 0; c < 3; ++c) {
        const double expected = surface.facets[0].albedo[c] / kPi;
        const Estimate value = lobe.value(c, b);
        EXPECT_NEAR(value.value, expected, kSigmas * value.error + 1e-12) << theta << " bin " << b;
        EXPECT_LE(value.error, 0.02 * expected) << theta << " bin " << b;
      }
    const auto plain = simulated(surface, anisotropicLayout({theta}, {0}), theta, 0, 2000, 1, with(NextEvent::Off));
    EXPECT_LT(lobe.noise(), plain.noise() / 100);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_EQ(lobe.balance().reflected[c].value, plain.balance().reflected[c].value) << "paths are not changed";
  }
}

TEST(NextEvent, TheMeansAreThoseOfPaths) {
  const SpherePacking packing{{{{1, 1, 1}, 1}, {{2.5F, 2.4F, 0.4F}, 0.8F}, {{0.2F, 2.5F, 2.2F}, 0.7F}}, 3, 3, true};
  struct Case {
    const char* name;
    Microsurface surface;
  };
  for (const Case& c :
       {Case{"rough", facetedSurface(testing::wavyField(3), {"lambertian(albedo=0.9 0.5 0.1)"})},
        Case{"white spheres on a mirror", facetedSurface(packing, {"lambertian(albedo=0.8)", "mirror"})},
        Case{"mirrors on white", facetedSurface(packing, {"mirror", "lambertian(albedo=0.8)"})},
        Case{"glossy on white",
             facetedSurface(packing, {"scattering(GGX(alpha=0.3, ior=1.5))", "lambertian(albedo=0.8)"})}})
    for (const GridLayout& layout : {isotropicLayout({50}), aboutTheMirror(50)}) {
      const auto plain = simulated(c.surface, layout, 50, 0, 60'000, 1000, with(NextEvent::Off));
      ASSERT_FALSE(plain.connects());
      // Many short runs: what they scatter by is what their errors say, each bin's, and of the sum, in which bins of
      // one run err together, it is what is known of its error.
      constexpr std::size_t runs = 12;
      constexpr std::uint64_t rays = 400;
      const std::vector<double>& measures = plain.bins().projectedSolidAngles();
      const std::size_t entries = c.surface.channels.count() * plain.bins().count();
      std::vector<double> mean(entries), square(entries), reported(entries);
      std::vector<double> totals;
      for (std::size_t run = 0; run < runs; ++run) {
        const auto lobe = simulated(c.surface, layout, 50, 0, rays, run, with(NextEvent::On));
        ASSERT_TRUE(lobe.connects());
        double total = 0;
        for (std::size_t e = 0; e < entries; ++e) {
          const std::size_t b = e % plain.bins().count();
          const Estimate value = lobe.value(e / plain.bins().count(), b);
          if (!(measures[b] > 1e-3)) continue;
          mean[e] += value.value / runs;
          square[e] += value.value * value.value / runs;
          reported[e] += value.error * value.error / runs;
          total += measures[b] * value.value;
        }
        totals.push_back(total);
      }
      double expected = 0, expectedError = 0, ratios = 0, compared = 0;
      for (std::size_t e = 0; e < entries; ++e) {
        const std::size_t b = e % plain.bins().count();
        if (!(measures[b] > 1e-3)) continue;
        const Estimate other = plain.value(e / plain.bins().count(), b);
        EXPECT_NEAR(mean[e], other.value, kSigmas * std::hypot(std::sqrt(reported[e] / runs), other.error))
            << c.name << " entry " << e << " of " << layout.text();
        expected += measures[b] * other.value;
        expectedError = std::hypot(expectedError, measures[b] * other.error);
        if (!(reported[e] > 0)) continue;
        ratios += (square[e] - mean[e] * mean[e]) * runs / (runs - 1) / reported[e];
        ++compared;
      }
      double total = 0, scatter = 0;
      for (const double one : totals) total += one / runs;
      for (const double one : totals) scatter += (one - total) * (one - total) / (runs - 1);
      EXPECT_NEAR(total, expected, kSigmas * std::hypot(std::sqrt(scatter / runs), expectedError)) << c.name;
      // Bins are not independent: not fewer than, say, four of them are.
      EXPECT_NEAR(ratios / compared, 1, kSigmas * std::sqrt(2.0 / (runs - 1) / 4)) << c.name << " " << layout.text();
    }
}

TEST(NextEvent, LessNoiseForAsManyQueries) {
  // Error squared times queries, which is what an error costs; docs/simulation.md has it in seconds.
  Microsurface surface = makeSurface("gaussian(rms=0.4, correlation=2)").surface;
  surface.facets = {parseFacet("lambertian(albedo=0.5)")};
  const GridLayout layout{
      Parametrisation::Spherical,
      {GridAxis::uniformCells(Q::ThetaO, 0, kPi / 2, 18), GridAxis::uniformCells(Q::PhiDifference, 0, kPi, 36),
       GridAxis::listedDegrees(Q::ThetaI, {30})},
      {.mirror = true}};
  const auto cost = [&](NextEvent nextEvent, std::uint64_t rays) {
    const auto lobe = simulated(surface, layout, 30, 0, rays, 1, with(nextEvent));
    return lobe.noise() * lobe.noise() * static_cast<double>(lobe.tally().segments);
  };
  EXPECT_LT(cost(NextEvent::On, 2000), cost(NextEvent::Off, 200'000) / 4);
}

TEST(NextEvent, IsForOpaqueFacets) {
  const Microsurface glass = facetedSurface(flatField(), {"dielectric(eta=1.5)"});
  EXPECT_THROW(makeTransport("cpu", glass, with(NextEvent::On)), Error);
  EXPECT_FALSE(makeTransport("cpu", glass, with(NextEvent::Automatic))->connects());
  const Microsurface mirror = facetedSurface(flatField(), {"mirror"});
  EXPECT_FALSE(makeTransport("cpu", mirror, with(NextEvent::Automatic))->connects());
}

}  // namespace
}  // namespace brdf
