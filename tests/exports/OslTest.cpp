// The OSL shader: its sum of closures read line by line, evaluated as OSL's testrender does.
#include "Renderer.h"

#include <regex>
#include <sstream>

namespace brdf::test {
namespace {

Shading read(const std::string& text) {
  EXPECT_NE(text.find("surface material()"), std::string::npos);
  const std::regex term(R"(\s*Ci \+= color\(([^)]*)\) \* (\w+)\(([^)]*)\);)");
  std::vector<Shading> terms;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (line.find("Ci +=") == std::string::npos) continue;
    if (!std::regex_match(line, match, term)) {
      ADD_FAILURE() << line;
      continue;
    }
    Colour weight{};
    EXPECT_EQ(std::sscanf(match[1].str().c_str(), "%lf, %lf, %lf", &weight[0], &weight[1], &weight[2]), 3);
    const std::string closure = match[2], arguments = match[3];
    if (closure == "diffuse") {
      EXPECT_EQ(arguments, "N");
      terms.push_back([=](const Direction&, const Direction&) { return 1 / kPi * weight; });
    } else if (closure == "oren_nayar") {
      double sigma = -1;
      EXPECT_EQ(std::sscanf(arguments.c_str(), "N, %lf", &sigma), 1);
      terms.push_back([=](const Direction& l, const Direction& v) {
        const double s2 = sigma * sigma, s = l[0] * v[0] + l[1] * v[1];
        return (1 - 0.5 * s2 / (s2 + 0.33) + 0.45 * s2 / (s2 + 0.09) * (s > 0 ? s / std::max(l[2], v[2]) : 0)) / kPi *
               weight;
      });
    } else {
      EXPECT_EQ(closure, "microfacet");
      char distribution[32] = "";
      double ax = 0, ay = 0, eta = 0;
      int refract = -1;
      EXPECT_EQ(std::sscanf(arguments.c_str(), "\"%31[a-z]\", N, T, %lf, %lf, %lf, %d", distribution, &ax, &ay, &eta,
                            &refract),
                5);
      EXPECT_EQ(refract, 0);
      const bool isGgx = std::string_view(distribution) == "ggx";
      EXPECT_STREQ(distribution, isGgx ? "ggx" : "beckmann");
      terms.push_back([=](const Direction& l, const Direction& v) {
        const Direction m = halfVector(l, v);
        const auto lambda = [&](const Direction& w) {
          return isGgx ? lambdaGgx(w, ax, ay) : 1 / g1Walter(w, ax, ay) - 1;
        };
        return (isGgx ? ggx(m, ax, ay) : beckmann(m, ax, ay)) / (1 + lambda(l) + lambda(v)) *
               fresnel(eta, 0, dot(v, m)) / (4 * l[2] * v[2]) * weight;
      });
    }
  }
  return [terms](const Direction& l, const Direction& v) {
    Colour sum{};
    for (const Shading& shade : terms) sum = sum + shade(l, v);
    return sum;
  };
}

TEST(Osl, HoldsItsOwnLobesExactly) {
  const auto material = parseMaterialExpression(
      "(0.3,0.1,0.05)*OrenNayar(sigma=0.4) + 0.1*Lambertian + (1.5,1,0.5)*GGX(alpha=0.2, alpha_y=0.1, ior=1.4) + "
      "0.3*CookTorranceHeitz(alpha=0.3, ior=(1.5,2,3))");
  const ExportResult result = exported("osl", material);
  EXPECT_TRUE(result.exact) << result.reason;
  expectSame(read(result.text), *material, 1e-9);
}

TEST(Osl, ApproximatesAMetalAndStatesTheError) {
  const auto material = parseMaterialExpression("GGXConductor(alpha=0.2, eta=(0.2,0.4,1.4), k=(3.9,2.4,1.6))");
  const ExportResult result = exported("osl", material);
  const Shading shading = read(result.text);
  expectSame(shading, *result.evaluated, 1e-9);
  expectStatedError(shading, result, *material, 1e-6);
  EXPECT_LT(result.error.comparison.metrics.at("rms"), 0.1 * result.error.comparison.zeroModel.at("rms"));
}

}  // namespace
}  // namespace brdf::test
