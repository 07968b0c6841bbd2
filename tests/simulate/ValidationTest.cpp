#include "SimulationSupport.h"

#include <brdf/simulate/SurfaceKinds.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace brdf {
namespace {

using testing::simulated, testing::facetedSurface;
using Q = AxisQuantity;

constexpr double kSigmas = 5;

/// Beckmann's distribution of slopes of the width `alpha` (rms slope alpha / sqrt 2), with Smith's height-correlated
/// masking and shadowing, of mirror facets: B. Walter, S. Marschner, H. Li and K. Torrance 2007, "Microfacet models for
/// refraction through rough surfaces", eqs. 20 and 25, DOI 10.2312/EGWR/EGSR07/195-206 (here Lambda is from E. Heitz
/// 2014, "Understanding the masking-shadowing function in microfacet-based BRDFs", JCGT 3(2), eqs. 66 and 99).
double beckmannSmith(const Direction& wi, const Direction& wo, double alpha) {
  const Direction h = normalized({wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]});
  const double cos2 = h[2] * h[2], tan2 = (1 - cos2) / cos2;
  const double D = std::exp(-tan2 / (alpha * alpha)) / (kPi * alpha * alpha * cos2 * cos2);
  const auto lambda = [&](const Direction& w) {
    const double sine = std::sqrt(1 - w[2] * w[2]);
    if (sine == 0) return 0.0;
    const double a = w[2] / (alpha * sine);
    return (std::erf(a) - 1) / 2 + std::exp(-a * a) / (2 * a * std::sqrt(kPi));
  };
  return D / (1 + lambda(wi) + lambda(wo)) / (4 * wi[2] * wo[2]);
}

TEST(SimulationValidation, ASmoothGaussianSurfaceIsBeckmannWithSmithShadowing) {
  // A stationary Gaussian surface has Gaussian slopes: Beckmann's. Small slopes and angles: a single reflection, and
  // shadowing that Smith's independence of heights and slopes describes. The mean over each bin is compared.
  const MadeSurface made = makeSurface("gaussian(rms=0.1, correlation=2)");
  Microsurface surface = made.surface;
  surface.facets = {parseFacet("mirror")};
  const auto fact = [&](const std::string& name) {
    return std::ranges::find(made.facts, name, &SurfaceFact::name)->value;
  };
  // The slopes of this very tile, along x and y together, isotropic as the azimuth is random.
  const double alpha = std::sqrt(std::pow(fact("rms slope along x"), 2) + std::pow(fact("rms slope along y"), 2));
  EXPECT_NEAR(alpha, 2 * 0.1 / 2, 0.01);  // sqrt(2) times sqrt(2) rms / correlation, in one direction
  const GridLayout layout{
      Parametrisation::Spherical,
      {GridAxis::uniformCells(Q::ThetaO, 0, kPi / 2, 45), GridAxis::uniformCells(Q::PhiDifference, 0, kPi, 45),
       GridAxis::listedDegrees(Q::ThetaI, {0, 30, 60})},
      {.mirror = true}};
  for (const double theta : {0.0, 30.0, 60.0}) {
    const LobeSimulation lobe = simulated(surface, layout, theta, 0, 400'000);
    const Direction wi = fromSpherical(radians(theta), 0);
    double difference = 0, total = 0, noise = 0;
    for (std::size_t b = 0; b < lobe.bins().count(); ++b) {
      constexpr int steps = 6;
      double sum = 0, weights = 0;
      for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
          const double to = radians(2 * (static_cast<double>(b % 45) + (i + 0.5) / steps));
          const double po = radians(4 * (static_cast<double>(b / 45) + (j + 0.5) / steps));
          const double weight = std::sin(to) * std::cos(to);
          sum += weight * beckmannSmith(wi, fromSpherical(to, po), alpha);
          weights += weight;
        }
      const double measure = lobe.bins().projectedSolidAngles()[b];
      difference += measure * std::abs(lobe.value(0, b).value - sum / weights);
      total += measure * sum / weights;
      noise += measure * lobe.value(0, b).error;
    }
    // So smooth that the model reflects all light once.
    EXPECT_NEAR(total, 1, 1e-3) << theta;
    EXPECT_NEAR(lobe.balance().reflected[0].value, 1, 1e-9);
    // The mean distance, of which sqrt(2 / pi) of the noise is chance; the tile is one realisation of 64 x 64 lengths
    // of correlation, whose distribution of slopes itself differs by about 1 / 64.
    EXPECT_LT(difference, 0.8 * noise + 1.0 / 64) << theta << ": noise " << noise;
  }
}

TEST(SimulationValidation, DiluteMirrorSpheresScatterUniformly) {
  // A mirror sphere far larger than the wavelength scatters light from its cross section uniformly into all directions
  // (H. C. van de Hulst 1957, "Light Scattering by Small Particles", section 12.44). One sphere of radius r in a tile
  // of area A: of light at theta the share pi r^2 / (A cos theta) meets it; what meets a second one is of the second
  // order in that share.
  constexpr double r = 1, side = 60;
  const Microsurface surface = facetedSurface(SpherePacking{{{{5, 7, 3}, 1}}, side, side, false}, {"mirror"});
  // Bins of equal solid angle: cos(theta_o) from 1 to 0.35, below which light may meet another sphere.
  const GridLayout layout{Parametrisation::Spherical,
                          {GridAxis::uniformCells(Q::ThetaO, 0, std::acos(0.35), 5, AxisScale::Cosine),
                           GridAxis::uniformCells(Q::PhiO, 0, 2 * kPi, 8).periodic(),
                           GridAxis::listedDegrees(Q::ThetaI, {0, 50}), GridAxis::listedDegrees(Q::PhiI, {20})}};
  for (const double theta : {0.0, 50.0}) {
    constexpr std::uint64_t rays = 4'000'000;
    const LobeSimulation lobe = simulated(surface, layout, theta, 20, rays);
    const EnergyBalance balance = lobe.balance();
    const double share = kPi * r * r / (side * side * std::cos(radians(theta)));
    EXPECT_NEAR(1 - balance.specularTransmitted[0].value, share, kSigmas * std::sqrt(share / rays)) << theta;
    EXPECT_NEAR(balance.reflected[0].value, share / 2, kSigmas * std::sqrt(share / 2 / rays) + 2 * share * share)
        << theta;
    const double expected = share * rays * (0.65 / 2) / static_cast<double>(lobe.bins().count());
    double chi2 = 0;
    for (const double count : lobe.tally().reflected.sum) chi2 += (count - expected) * (count - expected) / expected;
    const auto freedom = static_cast<double>(lobe.bins().count());
    EXPECT_NEAR(chi2, freedom, kSigmas * std::sqrt(2 * freedom)) << theta;
  }
}

/// Mean of f_r over light and viewer in two patches of 6 degrees by 12, about directions given in degrees; over the
/// light by 8 x 8 midpoints.
Estimate meanBetween(const std::shared_ptr<Transport>& transport, const Microsurface& surface,
                     const std::array<double, 2>& light, const std::array<double, 2>& viewer) {
  constexpr int steps = 8;
  Estimate mean;
  double weights = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double theta = light[0] + 6 * ((i + 0.5) / steps - 0.5), phi = light[1] + 12 * ((j + 0.5) / steps - 0.5);
      const GridLayout layout{Parametrisation::Spherical,
                              {GridAxis::cellsDegrees(Q::ThetaO, {viewer[0] - 3, viewer[0] + 3}),
                               GridAxis::cellsDegrees(Q::PhiO, {viewer[1] - 6, viewer[1] + 6}),
                               GridAxis::listedDegrees(Q::ThetaI, {theta}), GridAxis::listedDegrees(Q::PhiI, {phi})}};
      LobeSimulation lobe(transport, surface.channels, layout, radians(theta), radians(phi), 100 + 8 * i + j);
      lobe.add(3000);
      const double weight = std::sin(2 * radians(theta));
      mean.value += weight * lobe.value(0, 0).value;
      mean.error = std::hypot(mean.error, weight * lobe.value(0, 0).error);
      weights += weight;
    }
  return {mean.value / weights, mean.error / weights};
}

TEST(SimulationValidation, LightAndViewerMayChangePlaces) {
  // f(a, b) = f(b, a), several reflections and refractions included; 1 % is for the midpoints.
  const std::array<std::array<double, 2>, 3> directions{{{20, 0}, {35, 160}, {65, 250}}};
  for (const char* facet : {"lambertian(albedo=0.9)", "conductor(eta=0.2, k=3.9)",
                            "scattering(0.5*Lambertian + GGX(alpha=0.5, ior=1.5))", "dielectric(eta=1.5)"}) {
    const Microsurface surface = facetedSurface(testing::wavyField(0.8, 48), {facet});
    const auto transport = std::shared_ptr<Transport>(makeTransport("cpu", surface));
    for (std::size_t a = 0; a < directions.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        const Estimate forth = meanBetween(transport, surface, directions[a], directions[b]);
        const Estimate back = meanBetween(transport, surface, directions[b], directions[a]);
        EXPECT_GT(forth.value, 0);
        EXPECT_NEAR(forth.value, back.value, kSigmas * std::hypot(forth.error, back.error) + 0.01 * forth.value)
            << facet << " directions " << a << " and " << b << ": " << forth.error << " " << back.error;
      }
  }
}

}  // namespace
}  // namespace brdf
