#include "FunctionBrdf.h"

#include <brdf/geometry/Directions.h>
#include <brdf/material/LobeSum.h>
#include <brdf/sampling/DirectionalAlbedo.h>

#include <gtest/gtest.h>

#include <cmath>

namespace brdf {
namespace {

using test::FunctionBrdf;

void expectWithin(const Albedo& albedo, double truth, double worst) {
  EXPECT_LT(albedo.error[0], worst);
  EXPECT_NEAR(albedo.value[0], truth, 5 * albedo.error[0] + 1e-12);
}

TEST(DirectionalAlbedo, OfLambertIsTheSameFromEverywhere) {
  const FunctionBrdf lambert([](const Direction&, const Direction&) { return 0.6 / kPi; });
  for (const double theta : {0.0, 30.0, 89.0})
    expectWithin(directionalAlbedo(lambert, radians(theta), 512), 0.6, 1e-12);
  expectWithin(bihemisphericalAlbedo(lambert, 512), 0.6, 1e-12);
}

TEST(DirectionalAlbedo, OfLommelSeeligerIsTheClosedForm) {
  // f = 1 / (4 pi (mu_i + mu_o)): the single-scattering albedo 1 of Chandrasekhar 1960, "Radiative Transfer", III.47
  // integrates to a(mu) = (1 - mu ln((1 + mu) / mu)) / 2, and that over mu to 2 (1 - ln 2) / 3.
  const FunctionBrdf lommel([](const Direction& wi, const Direction& wo) { return 1 / (4 * kPi * (wi[2] + wo[2])); });
  for (const double theta : {0.0, 45.0, 80.0, 89.5}) {
    const double mu = std::cos(radians(theta));
    expectWithin(directionalAlbedo(lommel, radians(theta), 4096), (1 - mu * std::log((1 + mu) / mu)) / 2, 1e-3);
  }
  expectWithin(bihemisphericalAlbedo(lommel, 4096), 2 * (1 - std::log(2)) / 3, 1e-3);
}

TEST(DirectionalAlbedo, OfAPhongLobeAtNormalIncidenceIsItsNormalisation) {
  const double n = 40;
  const FunctionBrdf phong([n](const Direction& wi, const Direction& wo) {
    return (n + 2) / (2 * kPi) * std::pow(std::max(wi[2] * wo[2] - wi[0] * wo[0] - wi[1] * wo[1], 0.0), n);
  });
  expectWithin(directionalAlbedo(phong, 0, 8192), 1, 5e-3);
}

TEST(DirectionalAlbedo, OfAnAnisotropicSurfaceDependsOnTheAzimuthAndTheMeanTakesAll) {
  const FunctionBrdf striped(
      [](const Direction& wi, const Direction&) { return (1 + std::cos(2 * toSpherical(wi).phi)) / (2 * kPi); },
      Symmetry::Anisotropic);
  expectWithin(directionalAlbedo(striped, 1, 512), 1, 1e-12);
  expectWithin(directionalAlbedo(striped, 1, 512, radians(60)), 0.25, 1e-12);
  expectWithin(bihemisphericalAlbedo(striped, 4096), 0.5, 1e-3);
}

TEST(DirectionalAlbedo, TheBihemisphericalOneIsTheWeightedMeanOfTheDirectionalOnes) {
  const auto brdf = parseMaterialExpression("(0.3,0.1,0.05)*Lambertian + 0.5*GGX(alpha=0.2)");
  const Albedo all = bihemisphericalAlbedo(*brdf, 8192);
  // The midpoint rule in sin^2 theta, in which the weight cos(theta) is even.
  const std::size_t steps = 64;
  for (std::size_t c = 0; c < 3; ++c) {
    double mean = 0;
    for (std::size_t k = 0; k < steps; ++k) {
      const double theta = std::asin(std::sqrt((static_cast<double>(k) + 0.5) / steps));
      mean += directionalAlbedo(*brdf, theta, 2048).value[c] / steps;
    }
    EXPECT_NEAR(all.value[c], mean, 5 * all.error[c] + 5e-4);
    EXPECT_LT(all.error[c], 1e-3);
  }
}

}  // namespace
}  // namespace brdf
