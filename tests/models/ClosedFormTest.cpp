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

TEST(ClosedForm, NeumannsAlbedoTendsToAMirrorsAsItsExponentGrows) {
  // f cos_i is (n + 2)/(2 pi) cos^n alpha min(1, cos_i/cos_o). About the mirror direction cos_i/cos_o is 1 + x tan
  // theta, where x tends to a Gaussian of variance 1/n: the mean of its part below 0 is tan theta/sqrt(2 pi n).
  // Integrated over alpha and the angle psi about the mirror direction.
  constexpr int rings = 4000, spokes = 120;  // midpoints: to 2e-7
  for (const double n : {1e4, 1e6})
    for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
      const Direction wo = fromSpherical(radians(degrees), 0.4), mirror{-wo[0], -wo[1], wo[2]};
      Direction t, b;
      orthonormalBasis(mirror, t, b);
      DirectionPairBuffer<double> pairs;
      std::vector<double> weights;
      const double reach = 9 / std::sqrt(n), step = reach / rings;
      for (int i = 0; i < rings; ++i)
        for (int j = 0; j < spokes; ++j) {
          const double alpha = (i + 0.5) * step, psi = (j + 0.5) * 2 * kPi / spokes;
          const double c = std::cos(alpha), x = std::sin(alpha) * std::cos(psi), y = std::sin(alpha) * std::sin(psi);
          const Direction wi{c * mirror[0] + x * t[0] + y * b[0], c * mirror[1] + x * t[1] + y * b[1],
                             c * mirror[2] + x * t[2] + y * b[2]};
          pairs.push(wi, wo);
          weights.push_back(wi[2] * std::sin(alpha) * step * 2 * kPi / spokes);
        }
      std::vector<double> values(pairs.size());
      parseMaterialExpression("Neumann(n=" + std::to_string(n) + ")")->evaluate(pairs.view(), values.data(), nullptr);
      double sum = 0;
      for (std::size_t k = 0; k < values.size(); ++k) sum += values[k] * weights[k];
      EXPECT_NEAR(sum, 1 - std::tan(radians(degrees)) / std::sqrt(2 * kPi * n), 2 / n) << n << " " << degrees;
    }
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

TEST(ClosedForm, TheExponentialPowerDistributionOfPowerOneIsBeckmann) {
  for (const char* f : {"_Constant", "_Schlick", "_Dielectric", "_Conductor"})
    for (const char* g : {"_Smith", "_VGroove", "_None"})
      expectSame((std::string("Microfacet_EPD") + f + g + "(beta=0.3, beta_y=0.12, p=1)").c_str(),
                 (std::string("Microfacet_Beckmann") + f + g + "(alpha=0.3, alpha_y=0.12)").c_str(), 1e-8);
}

/// Smith's Lambda of an isotropic distribution of slopes at cotangent a, straight from its definition (Heitz 2014,
/// section 5): (1/a) times the integral of (q - a) over all slopes whose component q toward the viewer exceeds a, by
/// midpoints in q and across.
template <class Slopes>
double smithLambda(double a, double reach, const Slopes& density) {
  constexpr int count = 1500;
  const double along = (reach - a) / count, across = reach / count;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double q = a + (i + 0.5) * along;
    double row = 0;
    for (int j = 0; j < count; ++j) row += density(std::hypot(q, (j + 0.5) * across));
    sum += (q - a) * 2 * row;
  }
  return sum * along * across / a;
}

TEST(ClosedForm, SmithsShadowingOfTheAbcDistributionIsItsProjectedArea) {
  // The facets that face a viewer have the projected area cos (1 + Lambda) (Heitz 2014, section 5): here integrated
  // over the half vectors, where the lobe integrates over slopes. Midpoints in log(1 + B (1 - cos)) and phi.
  constexpr int steps = 1500;
  for (const auto& [B, C] : {std::pair{0.5, 0.3}, {20.0, 1.0}, {300.0, 2.0}, {1e5, 1.2}, {1e4, 6.0}})
    for (const double degrees : {30.0, 70.0, 88.0}) {
      const Direction wi = fromSpherical(radians(degrees), 0.4), wo{-wi[0], -wi[1], wi[2]};
      const double length = std::log1p(B), sine = std::hypot(wi[0], wi[1]);
      double norm = 0, area = 0;
      for (int i = 0; i < steps; ++i) {
        const double x = std::expm1((i + 0.5) / steps * length) / B, weight = (1 + B * x) / B * length / steps;
        const double density = std::pow(1 + B * x, -C) * weight, c = 1 - x, t = std::sqrt(x * (2 - x));
        double facing = 0;
        for (int j = 0; j < steps; ++j)
          facing += std::max(0.0, wi[2] * c + sine * t * std::cos((j + 0.5) / steps * kPi)) * 2 * kPi / steps;
        norm += 2 * kPi * density * c;
        area += density * facing;
      }
      const double lambda = area / norm / wi[2] - 1;
      // Mirror pair: 4 cos^2 f/D = G = 1/(1 + 2 Lambda), or 1/(1 + Lambda)^2 where separable; D = 1/norm.
      const auto shadowing = [&](const char* g) {
        const std::string text =
            std::string("Microfacet_ABC_Constant_") + g + "(B=" + std::to_string(B) + ", C=" + std::to_string(C) + ")";
        return parseMaterialExpression(text)->evaluate(wi, wo)[0] * 4 * wi[2] * wi[2] * norm;
      };
      EXPECT_NEAR(shadowing("Smith"), 1 / (1 + 2 * lambda), 1e-4) << B << " " << C << " " << degrees;
      EXPECT_NEAR(shadowing("SmithSeparable"), std::pow(1 + lambda, -2), 1e-4) << B << " " << C << " " << degrees;
    }
}

TEST(ClosedForm, SmithsShadowingOfTheExponentialPowerDistributionIsItsIntegral) {
  for (const double p : {0.45, 0.8, 1.6, 4.0})
    for (const double degrees : {30.0, 60.0, 80.0}) {
      const double beta = 0.5, reach = std::pow(30, 0.5 / p);
      const double a = 1 / (beta * std::tan(radians(degrees)));
      const auto slopes = [&](double r) { return p / (kPi * std::tgamma(1 / p)) * std::exp(-std::pow(r, 2 * p)); };
      const double lambda = a < reach ? smithLambda(a, reach, slopes) : 0;
      // Mirror pair: 4 cos^2 f/D = G = 1/(1 + 2 Lambda) height-correlated; 1/(1 + (1 + c) Lambda) with azimuths pi
      // apart.
      const Direction wi = fromSpherical(radians(degrees), 0.4), wo{-wi[0], -wi[1], wi[2]};
      const double d = p / (kPi * std::tgamma(1 / p) * beta * beta), c = 4.41 * kPi / (4.41 * kPi + 1);
      const auto shadowing = [&](const std::string& text) {
        return parseMaterialExpression(text)->evaluate(wi, wo)[0] * 4 * wi[2] * wi[2] / d;
      };
      const std::string parameters = "(beta=0.5, p=" + std::to_string(p);
      EXPECT_NEAR(shadowing("Microfacet_EPD_Constant_Smith" + parameters + ")"), 1 / (1 + 2 * lambda), 3e-5)
          << p << " " << degrees;
      // The Fresnel factor alone, from a lobe whose other factors are 1/(pi alpha^2) at the mirror direction.
      const double fresnel =
          parseMaterialExpression("Microfacet_GGX_Conductor_None(alpha=0.5, eta=0.2, k=3)")->evaluate(wi, wo)[0] * 4 *
          wi[2] * wi[2] * kPi * 0.25;
      EXPECT_NEAR(shadowing("EPD" + parameters + ", eta=0.2, k=3)"), fresnel / (1 + (1 + c) * lambda), 3e-5)
          << p << " " << degrees;
    }
}

TEST(ClosedForm, TheExponentialPowerDistributionIsNowhereMuchDenserThanWhatIsDrawnForIt) {
  // D cos theta_h/(4 cos theta_d) over the density: the bound that its sampler states; both agree at p = 1.
  for (const double p : {0.2, 0.3, 0.5, 0.8, 1.0, 1.5, 2.5, 5.0}) {
    const auto lobe =
        parseMaterialExpression("Microfacet_EPD_Constant_None(beta=0.4, beta_y=0.1, p=" + std::to_string(p) + ")");
    const Direction wo = fromSpherical(0.3, 0.5);
    double most = 0;
    for (double theta = 0; theta < 1.57; theta += 0.01) {
      const Direction wi = fromSpherical(theta, 2.9), h = normalized({wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]});
      DirectionPairBuffer<double> pair;
      pair.push(wi, wo);
      double density = 0;
      lobe->pdf(pair.view(), &density);
      const double wanted = lobe->evaluate(wi, wo)[0] * wi[2] * wo[2] * h[2] / dot(wo, h);
      if (wanted < 1e-290) continue;
      most = std::max(most, wanted / density);
      if (p == 1) {
        EXPECT_NEAR(wanted / density, 1, 1e-12);
      }
    }
    EXPECT_LE(most, 1.27) << p;
    EXPECT_GE(most, 0.99) << p << ": the bound is tight somewhere";
  }
}

}  // namespace
}  // namespace brdf
