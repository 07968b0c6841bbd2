#include "SimulationSupport.h"

#include <brdf/simulate/Fresnel.h>
#include <gtest/gtest.h>

namespace brdf {
namespace {

using testing::anisotropicLayout, testing::flatField, testing::isotropicLayout, testing::simulated,
    testing::facetedSurface;

// Standard errors allowed a figure: 5 sigma happen once in 1.7 million.
constexpr double kSigmas = 5;

TEST(Transport, AFlatMirrorIsSpecularExactly) {
  for (const double theta : {0.0, 30.0, 60.0, 89.9}) {
    const auto lobe =
        simulated(facetedSurface(flatField(3), {"mirror"}), anisotropicLayout({theta}, {20}), theta, 20, 4096);
    const EnergyBalance balance = lobe.balance();
    EXPECT_EQ(balance.specularReflected[0].value, 1) << theta;
    EXPECT_EQ(balance.reflected[0].value, 1) << theta;
    EXPECT_EQ(balance.reflected[0].error, 0) << theta;
    for (const double sum : lobe.tally().reflected.sum) ASSERT_EQ(sum, 0);
  }
}

TEST(Transport, FlatConductorsAndDielectricsAreFresnel) {
  const Microsurface gold = facetedSurface(flatField(), {"conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2)"});
  const Microsurface glass = facetedSurface(flatField(), {"dielectric(eta=1.5)"});
  for (const double theta : {0.0, 45.0, 80.0, 89.9}) {
    const double c = std::cos(radians(theta));
    const auto metal = simulated(gold, isotropicLayout({theta}), theta, 0, 2048).balance();
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = conductorReflectance(c, gold.facets[0].eta[k], gold.facets[0].k[k]);
      EXPECT_NEAR(metal.specularReflected[k].value, expected, 1e-12) << theta;
      EXPECT_NEAR(metal.absorbed[k].value, 1 - expected, 1e-12) << theta;
    }
    double cosT;
    const double expected = dielectricReflectance(c, 1.5, cosT);
    // Both parts of every ray are followed: no noise.
    const auto clear = simulated(glass, isotropicLayout({theta}), theta, 0, 2048).balance();
    EXPECT_NEAR(clear.specularReflected[0].value, expected, 1e-12) << theta;
    EXPECT_NEAR(clear.specularTransmitted[0].value, 1 - expected, 1e-12) << theta;
  }
}

TEST(Transport, AFlatLambertianSurfaceIsAlbedoOverPi) {
  const Microsurface surface = facetedSurface(flatField(), {"lambertian(albedo=0.6 0.3 0)"});
  for (const double theta : {0.0, 70.0}) {
    constexpr std::uint64_t rays = 500'000;
    const auto lobe = simulated(surface, anisotropicLayout({theta}, {0}), theta, 0, rays);
    const EnergyBalance balance = lobe.balance();
    for (std::size_t c = 0; c < 3; ++c) {
      const double albedo = surface.facets[0].albedo[c];
      EXPECT_NEAR(balance.reflected[c].value, albedo, 1e-12);
      EXPECT_NEAR(balance.absorbed[c].value, 1 - albedo, 1e-12);
      // A bin of the share p of the rays holds a multinomial count: variance albedo^2 p (1 - p) / rays of its light.
      double chi2 = 0;
      for (std::size_t b = 0; b < lobe.bins().count(); ++b) {
        const double measure = lobe.bins().projectedSolidAngles()[b], p = measure / kPi;
        const double sigma = albedo * std::sqrt(p * (1 - p) / rays) / measure;
        const Estimate value = lobe.value(c, b);
        if (albedo == 0) {
          EXPECT_EQ(value.value, 0);
          continue;
        }
        EXPECT_NEAR(value.error / sigma, 1, 0.25) << "the standard error is the count's";
        chi2 += std::pow((value.value - albedo / kPi) / sigma, 2);
      }
      const double freedom = static_cast<double>(lobe.bins().count()) - 1;
      if (albedo == 0) continue;
      EXPECT_NEAR(chi2, freedom, kSigmas * std::sqrt(2 * freedom));
    }
  }
}

TEST(Transport, GroovesOf45DegreesSendLightBack) {
  // Light across the grooves at theta < 45 degrees, t = tan(theta). The wall away from the light gets (1 - t) / 2 of it
  // and sends it down to the other wall, and so back. The wall that faces the light gets (1 + t) / 2; what hits it
  // below (1 - t) / (1 + t) of its height meets the other wall, and comes back; the rest leaves at 90 degrees - theta
  // on the light's side. Back: 1 - t; past the ridge: t.
  for (const double theta : {7.5, 22.5, 42.5}) {
    constexpr std::uint64_t rays = 100'000;
    const auto lobe =
        simulated(facetedSurface(testing::vGrooves(), {"mirror"}), anisotropicLayout({theta}, {0}), theta, 0, rays);
    const double t = std::tan(radians(theta)), sigma = std::sqrt(t * (1 - t) / rays);
    const std::size_t back = lobe.bins().find(fromSpherical(radians(theta), 0));
    const std::size_t past = lobe.bins().find(fromSpherical(radians(90 - theta), 0));
    const auto& sums = lobe.tally().reflected.sum;
    EXPECT_NEAR(sums[back] / rays, 1 - t, kSigmas * sigma) << theta;
    EXPECT_NEAR(sums[past] / rays, t, kSigmas * sigma) << theta;
    // Rays that meet the bottom or a ridge within rounding may go astray.
    EXPECT_NEAR((sums[back] + sums[past]) / rays, 1, 1e-4) << theta;
    EXPECT_NEAR(lobe.balance().sum[0].value, 1, 1e-12);
  }
}

TEST(Transport, LosslessSurfacesKeepAllLight) {
  const SpherePacking packing{{{{1, 1, 1}, 1}, {{2.5F, 2.4F, 0.4F}, 0.8F}, {{0.2F, 2.5F, 2.2F}, 0.7F}}, 3, 3, true};
  struct Case {
    const char* name;
    Microsurface surface;
  };
  for (const Case& c :
       {Case{"mirror", facetedSurface(testing::wavyField(3), {"mirror"})},
        Case{"white", facetedSurface(testing::wavyField(3), {"lambertian(albedo=1)"})},
        Case{"glass", facetedSurface(testing::wavyField(3), {"dielectric(eta=1.5)"})},
        Case{"three glasses", facetedSurface(testing::wavyField(1), {"dielectric(eta=1.4 1.5 1.6)"})},
        Case{"lossless metal", facetedSurface(testing::wavyField(3), {"conductor(eta=0, k=2)"})},
        Case{"glass on mirror", facetedSurface(packing, {"dielectric(eta=1.5)", "mirror"})},
        Case{"mirrors in water", facetedSurface(packing, {"mirror", "dielectric(eta=1.33)"})},
        Case{"glass on water", facetedSurface(packing, {"dielectric(eta=1.5)", "dielectric(eta=1.33)"})}})
    for (const double theta : {0.0, 40.0, 85.0}) {
      const auto balance = simulated(c.surface, isotropicLayout({theta}), theta, 0, 40'000).balance();
      for (std::size_t k = 0; k < balance.sum.size(); ++k) {
        EXPECT_NEAR(balance.sum[k].value, 1, kSigmas * balance.sum[k].error + 1e-12) << c.name << " " << theta;
        EXPECT_NEAR(balance.absorbed[k].value, 0, 1e-12) << c.name;
        EXPECT_LT(balance.lost[k].value, 3e-4) << c.name << " " << theta;
      }
    }
}

TEST(Transport, AbsorptionInsideFollowsBeerAndLambert) {
  // A slab of glass: two flat sheets that face away from each other, 2 micrometres apart. At normal incidence, with the
  // reflectance R of one face and A = exp(-2 a), the slab reflects R + (1 - R)^2 R A^2 / (1 - R^2 A^2) and transmits
  // (1 - R)^2 A / (1 - R^2 A^2).
  TiledMesh slab{{{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                 {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}},
                 {},
                 1,
                 1};
  const double R = 0.04;
  for (const double a : {0.0, 0.05, 1.0}) {
    const auto balance = simulated(facetedSurface(slab, {"dielectric(eta=1.5, absorption=" + std::to_string(a) + ")"}),
                                   isotropicLayout({0}), 0, 0, 200'000)
                             .balance();
    const double A = std::exp(-2 * a), inside = (1 - R) * (1 - R) / (1 - R * R * A * A);
    EXPECT_NEAR(balance.specularReflected[0].value, R + inside * R * A * A,
                kSigmas * balance.specularReflected[0].error + 1e-9);
    EXPECT_NEAR(balance.specularTransmitted[0].value, inside * A,
                kSigmas * balance.specularTransmitted[0].error + 1e-9);
    EXPECT_NEAR(balance.sum[0].value, 1, kSigmas * balance.sum[0].error + 1e-9);
    EXPECT_EQ(balance.lost[0].value, 0);
  }
}

TEST(Transport, AMaterialOnFacetsIsThatMaterial) {
  // A flat surface of a material measures as that material: the mean over each bin, here by midpoints.
  const Microsurface surface = facetedSurface(flatField(), {"scattering(0.3*Lambertian + GGX(alpha=0.3, ior=1.5))"});
  const GridLayout layout = anisotropicLayout({40}, {0});
  const auto lobe = simulated(surface, layout, 40, 0, 1'000'000);
  const Direction wi = fromSpherical(radians(40.0), 0);
  double chi2 = 0;
  for (std::size_t b = 0; b < lobe.bins().count(); ++b) {
    constexpr int steps = 8;
    double sum = 0, weights = 0;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const double theta = radians(5 * (static_cast<double>(b % 18) + (i + 0.5) / steps));
        const double phi = radians(-5 + 10 * (static_cast<double>(b / 18) + (j + 0.5) / steps));
        const double weight = std::sin(theta) * std::cos(theta);
        sum += weight * surface.facets[0].brdf->evaluate(wi, fromSpherical(theta, phi))[0];
        weights += weight;
      }
    const Estimate value = lobe.value(0, b);
    chi2 += std::pow((value.value - sum / weights) / value.error, 2);
  }
  // Bins of few counts estimate their errors roughly: a tenth more.
  const double freedom = static_cast<double>(lobe.bins().count());
  EXPECT_NEAR(chi2, freedom, kSigmas * std::sqrt(2 * freedom) + 0.1 * freedom);
}

}  // namespace
}  // namespace brdf
