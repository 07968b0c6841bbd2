// Models where the literature or the algebra says what they must be.
#include <brdf/check/Cases.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/LobeSum.h>
#include <gtest/gtest.h>

#include <cmath>

namespace brdf {
namespace {

/// Directional albedo by midpoints in theta_i and phi_i: smooth lobes only.
double albedo(const LobeSum& material, double degrees) {
  constexpr std::size_t polar = 1000, azimuthal = 512;
  const Direction wo = fromSpherical(radians(degrees), 0.3);
  DirectionPairBuffer<double> pairs;
  for (std::size_t i = 0; i < polar; ++i)
    for (std::size_t j = 0; j < azimuthal; ++j)
      pairs.push(fromSpherical((static_cast<double>(i) + 0.5) * kPi / 2 / polar,
                               (static_cast<double>(j) + 0.5) * 2 * kPi / azimuthal),
                 wo);
  std::vector<double> values(pairs.size());
  material.evaluate(pairs.view(), values.data(), nullptr);
  double sum = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double cosine = pairs.wi[2][k];
    sum += values[k] * cosine * std::sqrt(1 - cosine * cosine);
  }
  return sum * (kPi / 2 / polar) * (2 * kPi / azimuthal);
}

void expectSame(const char* a, const char* b, double relative) {
  const CheckPairs set = adversarialPairs(100, 41, false);
  std::vector<double> left(set.size()), right(set.size());
  parseMaterialExpression(a)->evaluate(set.pairs.view(), left.data(), nullptr);
  parseMaterialExpression(b)->evaluate(set.pairs.view(), right.data(), nullptr);
  for (std::size_t k = 0; k < set.size(); ++k)
    ASSERT_NEAR(left[k], right[k], relative * std::fabs(right[k]))
        << a << " and " << b << ", " << directionText(set.wi(k), set.wo(k));
}

TEST(ClosedForm, SmoothRoughDiffuseModelsAreLambertian) {
  for (const char* model :
       {"OrenNayar(sigma=0)", "OrenNayarFull(rho=1, sigma=0)", "Fujii(r=0)", "EON(rho=1, r=0)", "Minnaert(k=1)"})
    expectSame(model, "Lambertian", 1e-14);
}

TEST(ClosedForm, EonReflectsEverythingAtAlbedoOne) {
  for (const double angle : {0.0, 30.0, 60.0, 80.0, 89.0})
    for (const char* model : {"EON(rho=1, r=0.2)", "EON(rho=1, r=0.6)", "EON(rho=1, r=1)"})
      EXPECT_NEAR(albedo(*parseMaterialExpression(model), angle), 1, 2e-5) << model << " at " << angle << " degrees";
}

TEST(ClosedForm, CosineLobesReflectEverythingAtNormalIncidence) {
  for (const char* model : {"Phong(n=1)", "Phong(n=12)", "Neumann(n=12)", "LafortuneNgan(Cxy=-1, Cz=1, n=12)"})
    EXPECT_NEAR(albedo(*parseMaterialExpression(model), 0), 1, 1e-5) << model;
}

TEST(ClosedForm, MinnaertsAlbedoIsAPowerOfTheCosine) {
  // The integral of (ci co)^(k-1) ci/pi is 2 co^(k-1)/(k+1).
  for (const double angle : {0.0, 40.0, 70.0})
    EXPECT_NEAR(albedo(*parseMaterialExpression("Minnaert(k=1.7)"), angle),
                2 * std::pow(std::cos(radians(angle)), 0.7) / 2.7, 1e-6);
}

TEST(ClosedForm, StudentTIsGgxAtGammaTwoAsCloselyAsItsShadowingIsFitted) {
  expectSame("StudentT(alpha=0.3, gamma=2)", "GGXWalter(alpha=0.3)", 0.02);
}

TEST(ClosedForm, LafortuneIsPhongForMirrorLikeWeights) {
  expectSame("Lafortune(Cx=-1, Cz=1, n=30)", "0.19634954084936207*Phong(n=30)", 1e-12);  // 2 pi/(n + 2)
}

TEST(ClosedForm, AshikhminAndShirleysTermsAddUp) {
  expectSame("AshikhminShirleyFull(nu=20, F0=0.1, Rd=0.4)",
             "AshikhminShirley(nu=20, F0=0.1) + 0.4*AshikhminShirleyDiffuse(F0=0.1)", 1e-12);
}

TEST(ClosedForm, DisneysMetalIsItsHighlightAlone) {
  // Shadowing aside, GGX of alpha = roughness^2 with Schlick's Fresnel term: equal at normal incidence and view.
  const double value =
      parseMaterialExpression("Disney(baseColor=0.7, metallic=1, roughness=0.5)")->evaluate({0, 0, 1}, {0, 0, 1})[0];
  EXPECT_NEAR(value, 0.7 / (4 * kPi * 0.0625), 1e-12);
}

TEST(ClosedForm, SchlicksZenithFactorIsGgxOfTheSquareRoot) {
  // r = alpha^2; at normal incidence and view every other factor is 1.
  const double schlick = parseMaterialExpression("Schlick(r=0.04, F0=1)")->evaluate({0, 0, 1}, {0, 0, 1})[0];
  EXPECT_NEAR(schlick, 1 / (4 * kPi * 0.04), 1e-12);
}

}  // namespace
}  // namespace brdf
