// Models whose constants are their authors' own, restated plainly from other sources than our records; microfacet terms
// in every combination.
#include <brdf/check/Cases.h>
#include <brdf/material/LobeSum.h>
#include <brdf/models/Microfacet.h>
#include <gtest/gtest.h>

#include <cmath>

namespace brdf {
namespace {

/// Compares a material of one channel with a function of the two directions.
template <class Formula>
void expectFormula(const std::string& material, double relative, const Formula& formula) {
  const CheckPairs set = adversarialPairs(60, 61, false);
  std::vector<double> values(set.size());
  parseMaterialExpression(material)->evaluate(set.pairs.view(), values.data(), nullptr);
  for (std::size_t k = 0; k < set.size(); ++k) {
    const double expected = formula(set.wi(k), set.wo(k));
    ASSERT_NEAR(values[k], expected, relative * std::fabs(expected) + 1e-12)
        << material << ", " << directionText(set.wi(k), set.wo(k));
  }
}

double square(double x) { return x * x; }

TEST(EmpiricalModels, OrenAndNayarsFullModelHasTheConstantsOfAnotherProgram) {
  // As a public shader in the format of Disney's BRDF Explorer has it, in degrees there; the clamp is ours.
  for (const double sigma : {0.1, 0.5, 1.2})
    for (const double rho : {0.3, 1.0})
      expectFormula(
          "OrenNayarFull(rho=" + std::to_string(rho) + ", sigma=" + std::to_string(sigma) + ")", 1e-6,
          [&](const Direction& u, const Direction& v) {
            const double ti = std::acos(u[2]), to = std::acos(v[2]), a = std::max(ti, to), b = std::min(ti, to);
            const double sines = std::hypot(u[0], u[1]) * std::hypot(v[0], v[1]);
            const double c = sines > 1e-12 ? (u[0] * v[0] + u[1] * v[1]) / sines : 0, s2 = sigma * sigma;
            const double c1 = 1 - 0.5 * s2 / (s2 + 0.33);
            const double c2 = 0.45 * s2 / (s2 + 0.09) * (c >= 0 ? std::sin(a) : std::sin(a) - std::pow(2 * b / kPi, 3));
            const double c3 = 0.125 * s2 / (s2 + 0.09) * square(4 * a * b / (kPi * kPi));
            const double once =
                rho / kPi * (c1 + c * c2 * std::tan(b) + (1 - std::fabs(c)) * c3 * std::tan(0.5 * (a + b)));
            const double twice = 0.17 * rho * rho / kPi * s2 / (s2 + 0.13) * (1 - c * square(2 * b / kPi));
            return std::max(0.0, once + twice);
          });
}

TEST(EmpiricalModels, StraussHasTheConstantsOfOtherPrograms) {
  // Strauss' F and G with kf = 1.12, ks = 1.01 and kj = 0.1, as several public shaders have them (some give F the
  // cosine for the angle over 90 degrees); divided by pi cos_i, as our page says.
  const auto f = [](double x) {
    const auto raw = [](double y) { return 1 / square(y - 1.12); };
    return (raw(x) - raw(0)) / (raw(1) - raw(0));
  };
  const auto g = [](double x) {
    const auto raw = [](double y) { return 1 / square(y - 1.01); };
    return (raw(1) - raw(x)) / (raw(1) - raw(0));
  };
  for (const double s : {0.2, 0.8})
    for (const double m : {0.0, 0.6, 1.0}) {
      const double colour = 0.4;
      expectFormula("Strauss(smoothness=" + std::to_string(s) + ", metalness=" + std::to_string(m) + ", colour=0.4)",
                    1e-6, [&](const Direction& u, const Direction& v) {
                      const double a = std::acos(u[2]) / (kPi / 2), b = std::acos(v[2]) / (kPi / 2);
                      const double rd = 1 - s * s * s, rn = 1 - rd, j = f(a) * g(a) * g(b);
                      const double rj = std::min(1.0, rn + (rn + 0.1) * j);
                      const double mirror = std::max(0.0, u[2] * v[2] - u[0] * v[0] - u[1] * v[1]);
                      const double tint = 1 + m * (1 - f(a)) * (colour - 1);
                      return (u[2] * (1 - m * s) * rd * colour + std::pow(mirror, 3 / (1 - s)) * rj * tint) /
                             (kPi * u[2]);
                    });
    }
}

TEST(EmpiricalModels, TheSheensFittedShadowingIsSmithsIntegralWithinItsError) {
  // Lambda = (integral of max(0, wo.m) D(m))/cos - 1 over all normals, D integrates to 1 over its cosine. The fit is
  // within 16 % (at r = 1, 3 %); at a mirror pair f = D/(4 cos^2 (1 + 2 Lambda)) with D from two equal cosines.
  for (const auto& [r, allowed] : {std::pair{0.1, 0.16}, {0.25, 0.16}, {0.5, 0.16}, {1.0, 0.05}}) {
    double total = 0;
    constexpr int count = 20'000;
    const auto distribution = [&](double theta) { return (2 + 1 / r) * std::pow(std::sin(theta), 1 / r) / (2 * kPi); };
    for (int k = 0; k < count; ++k) {
      const double theta = (k + 0.5) * kPi / 2 / count;
      total += distribution(theta) * std::cos(theta) * std::sin(theta) * 2 * kPi * kPi / 2 / count;
    }
    EXPECT_NEAR(total, 1, 1e-6) << r;
    for (const double degrees : {40.0, 60.0, 80.0}) {
      const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
      double seen = 0;
      for (int k = 0; k < count; ++k) {
        const double theta = (k + 0.5) * kPi / 2 / count, a = c * std::cos(theta), b = s * std::sin(theta);
        const double edge = a >= b ? kPi : std::acos(-a / b);
        seen += distribution(theta) * 2 * (a * edge + (a >= b ? 0 : b * std::sin(edge))) * std::sin(theta) * kPi / 2 /
                count;
      }
      const double lambda = seen / c - 1;
      // Equal angles, azimuths 90 degrees apart, so that the half vector is off the normal.
      const Direction wi = fromSpherical(radians(degrees), 0), wo = fromSpherical(radians(degrees), kPi / 2);
      const double hz = 2 * c / std::hypot(wi[0] + wo[0], wi[1] + wo[1], 2 * c);
      const double value = parseMaterialExpression("SheenCharlie(r=" + std::to_string(r) + ")")->evaluate(wi, wo)[0];
      const double fitted = 0.5 * (distribution(std::acos(hz)) / (4 * c * c * value) - 1);
      EXPECT_NEAR(fitted, lambda, allowed * lambda + 0.02) << r << " at " << degrees;
    }
  }
}

TEST(Microfacets, ComposeAsProductsOfTheirTerms) {
  // f(D, F, G) f(D, Constant, None) = f(D, F, None) f(D, Constant, G), and f(D, F, None)/f(D, Constant, None) is the
  // Fresnel term whatever D is.
  const CheckPairs set = adversarialPairs(12, 62, false);
  const auto value = [&](const std::string& d, const std::string& f, const std::string& g) {
    const ModelPointer model = composeMicrofacet(d, f, g);
    std::vector<double> values(set.size());
    model->evaluate(set.pairs.view(), model->defaults(), values.data());
    for (std::size_t k = 0; k < set.size(); ++k)
      EXPECT_TRUE(std::isfinite(values[k]) && values[k] >= 0) << model->name();
    return values;
  };
  const MicrofacetTerms& terms = microfacetTerms();
  EXPECT_GE(terms.distributions.size() * terms.fresnels.size() * terms.shadowings.size(), 120u);
  for (const std::string& f : terms.fresnels) {
    const auto reference = value("GGX", f, "None"), plain = value("GGX", "Constant", "None");
    for (const std::string& d : terms.distributions) {
      const auto bare = value(d, "Constant", "None"), fresnel = value(d, f, "None");
      for (std::size_t k = 0; k < set.size(); ++k)
        ASSERT_NEAR(fresnel[k] * plain[k], reference[k] * bare[k], 1e-11 * reference[k] * bare[k]) << d << " " << f;
      for (const std::string& g : terms.shadowings) {
        const auto all = value(d, f, g), shadowed = value(d, "Constant", g);
        for (std::size_t k = 0; k < set.size(); ++k)
          ASSERT_NEAR(all[k] * bare[k], fresnel[k] * shadowed[k], 1e-11 * fresnel[k] * shadowed[k])
              << d << " " << f << " " << g;
      }
    }
  }
}

TEST(Microfacets, TurnWithTheirTangent) {
  // Anisotropic: roughnesses exchanged and both directions turned by 90 degrees give the same value.
  const CheckPairs set = adversarialPairs(12, 63, false);
  CheckPairs turned;
  for (std::size_t k = 0; k < set.size(); ++k) {
    const Direction u = set.wi(k), v = set.wo(k);
    turned.pairs.push({-u[1], u[0], u[2]}, {-v[1], v[0], v[2]});
  }
  for (const std::string& d : microfacetTerms().distributions)
    for (const std::string& g : microfacetTerms().shadowings) {
      const ModelPointer model = composeMicrofacet(d, "Conductor", g);
      std::vector<double> here = model->defaults(), there = here;
      bool anisotropic = false;
      for (std::size_t k = 0; k < here.size(); ++k)
        if (const Parameter& p = model->parameters()[k]; !p.follows.empty()) {
          const std::size_t along = model->parameterIndex(p.follows);
          here[along] = there[k] = 0.5;
          here[k] = there[along] = 0.15;
          anisotropic = true;
        }
      EXPECT_EQ(anisotropic, !model->isotropic()) << model->name();
      std::vector<double> a(set.size()), b(set.size());
      model->evaluate(set.pairs.view(), here, a.data());
      model->evaluate(turned.pairs.view(), there, b.data());
      for (std::size_t k = 0; k < set.size(); ++k) ASSERT_NEAR(a[k], b[k], 1e-11 * a[k] + 1e-280) << model->name();
    }
}

}  // namespace
}  // namespace brdf
