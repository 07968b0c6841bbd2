// The conventions that material/Brdf.h states, pinned by the one BRDF whose value everyone knows.
#include <brdf/check/Cases.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/LobeSum.h>
#include <gtest/gtest.h>

namespace brdf {
namespace {

TEST(Conventions, ALambertianHasTheValueAlbedoOverPiWithoutTheCosine) {
  const auto material = parseMaterialExpression("0.5*Lambertian");
  const CheckPairs set = adversarialPairs(50, 1, true);
  std::vector<double> values(set.size());
  std::vector<std::uint8_t> valid(set.size(), 7);
  material->evaluate(set.pairs.view(), values.data(), valid.data());
  for (std::size_t k = 0; k < set.size(); ++k) {
    EXPECT_DOUBLE_EQ(values[k], 0.5 / kPi) << directionText(set.wi(k), set.wo(k));
    EXPECT_EQ(valid[k], 1);
  }
}

TEST(Conventions, BelowAndOnTheHorizonTheValueIsZeroAndValid) {
  const auto material = parseMaterialExpression("Lambertian + GGX");
  const double horizons[] = {0.0, -0.0, -1e-300, -0.1, -1};
  for (const double z : horizons) {
    const Direction low{std::sqrt(1 - z * z), 0, z}, up{0, 0, 1};
    for (const auto& [wi, wo] : {std::pair{low, up}, std::pair{up, low}, std::pair{low, low}}) {
      EXPECT_EQ(material->evaluate(wi, wo), std::vector<double>{0}) << z;
      DirectionPairBuffer<double> pairs;
      pairs.push(wi, wo);
      double value = -1;
      std::uint8_t valid = 0;
      material->evaluate(pairs.view(), &value, &valid);
      EXPECT_EQ(value, 0);
      EXPECT_EQ(valid, 1);
    }
  }
}

TEST(Conventions, ChannelsArePlanarAndScaledEachByItsOwnFactor) {
  const auto material = parseMaterialExpression("(0.1,0.2,0.4)*Lambertian");
  EXPECT_EQ(material->channels(), Channels::rgb());
  const CheckPairs set = adversarialPairs(3, 2, false);
  const std::size_t count = set.size();
  std::vector<double> values(3 * count);
  material->evaluate(set.pairs.view(), values.data(), nullptr);
  const double albedo[] = {0.1, 0.2, 0.4};
  for (std::size_t channel = 0; channel < 3; ++channel)
    for (std::size_t k = 0; k < count; ++k) EXPECT_DOUBLE_EQ(values[channel * count + k], albedo[channel] / kPi);
}

TEST(Conventions, TheNormalIsZAndTheTangentX) {
  // A lobe stretched along x: half vectors tilted along x are likelier than those tilted along y.
  const auto material = parseMaterialExpression("Ward(ax=0.5, ay=0.05)");
  const Direction up{0, 0, 1}, alongX = fromSpherical(0.3, 0), alongY = fromSpherical(0.3, kPi / 2);
  EXPECT_GT(material->evaluate(alongX, up)[0], 10 * material->evaluate(alongY, up)[0]);
  EXPECT_EQ(material->symmetry(), Symmetry::Anisotropic);
  EXPECT_EQ(parseMaterialExpression("Ward(ax=0.5)")->symmetry(), Symmetry::Isotropic);
}

TEST(Conventions, WiIsTheLightAndWoTheViewerOfSampleAndPdf) {
  // pdf(wi | wo) of a mirror-like lobe is near 0 away from wo's mirror direction and large at it.
  const auto material = parseMaterialExpression("GGX(alpha=0.05)");
  const Direction wo = fromSpherical(0.8, 0.3), mirror{-wo[0], -wo[1], wo[2]};
  DirectionPairBuffer<double> pairs;
  pairs.push(mirror, wo);
  pairs.push(fromSpherical(0.8, 0.3), wo);
  double density[2];
  material->pdf(pairs.view(), density);
  EXPECT_GT(density[0], 1000 * density[1]);
  const double u = 0.5;
  double wi[3];
  material->sample({&wo[0], &wo[1], &wo[2]}, {&u, &u}, {&wi[0], &wi[1], &wi[2]}, 1);
  EXPECT_GT(dot({wi[0], wi[1], wi[2]}, mirror), 0.95);
}

TEST(Conventions, TheDensityOfALambertianIsCosineOverPi) {
  const auto material = parseMaterialExpression("Lambertian");
  const CheckPairs set = adversarialPairs(20, 3, false);
  std::vector<double> density(set.size());
  material->pdf(set.pairs.view(), density.data());
  for (std::size_t k = 0; k < set.size(); ++k) EXPECT_DOUBLE_EQ(density[k], set.wi(k)[2] / kPi);
}

TEST(Conventions, AnglesAreFromZAndX) {
  const Direction w = fromSpherical(kPi / 3, kPi / 6);
  EXPECT_NEAR(w[0], std::sqrt(3) / 2 * std::sqrt(3) / 2, 1e-15);
  EXPECT_NEAR(w[1], std::sqrt(3) / 4, 1e-15);
  EXPECT_NEAR(w[2], 0.5, 1e-15);
  const Spherical back = toSpherical(w);
  EXPECT_NEAR(back.theta, kPi / 3, 1e-15);
  EXPECT_NEAR(back.phi, kPi / 6, 1e-15);
}

}  // namespace
}  // namespace brdf
