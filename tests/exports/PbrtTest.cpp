// pbrt-v4's named materials: tokens read here, mixes by their mean, the rest as pbrt's book and its BxDFs say.
#include "Renderer.h"

#include <map>
#include <sstream>

namespace brdf::test {
namespace {

struct PbrtMaterial {
  std::map<std::string, std::vector<std::string>> parameters;  ///< "float eta" -> values

  double number(const std::string& name) const { return std::stod(parameters.at("float " + name).at(0)); }
  Colour rgb(const std::string& name) const {
    const auto& v = parameters.at("rgb " + name);
    return {std::stod(v.at(0)), std::stod(v.at(1)), std::stod(v.at(2))};
  }
};

class PbrtReader {
 public:
  explicit PbrtReader(const std::string& text) {
    std::istringstream lines(text);
    std::string line, code;
    while (std::getline(lines, line))
      if (line.empty() || line[0] != '#') code += line + "\n";
    const std::vector<std::string> words = tokens(code);
    for (std::size_t i = 0; i < words.size();) {
      EXPECT_EQ(words[i], "MakeNamedMaterial");
      const std::string name = words.at(i + 1);
      EXPECT_FALSE(materials_.contains(name)) << name << " twice";
      PbrtMaterial& material = materials_[name];
      for (i += 2; i < words.size() && words[i] != "MakeNamedMaterial";) {
        std::vector<std::string>& values = material.parameters[words[i++]];
        if (words.at(i) != "[") {
          values.push_back(words[i++]);
          continue;
        }
        for (++i; words.at(i) != "]"; ++i) values.push_back(words[i]);
        ++i;
      }
      // A mix must name materials that exist already.
      for (const std::string& part : material.parameters["string materials"])
        EXPECT_TRUE(materials_.contains(part)) << part;
    }
  }

  Shading shading(const std::string& name) const {
    const PbrtMaterial& m = materials_.at(name);
    const std::string type = m.parameters.at("string type").at(0);
    if (type == "mix") {
      const Shading a = shading(m.parameters.at("string materials").at(0)),
                    b = shading(m.parameters.at("string materials").at(1));
      const double amount = m.number("amount");
      EXPECT_TRUE(amount >= 0 && amount <= 1) << amount;
      return [=](const Direction& l, const Direction& v) { return (1 - amount) * a(l, v) + amount * b(l, v); };
    }
    const Colour reflectance = type == "conductor" ? Colour{} : m.rgb("reflectance");
    for (const double r : reflectance) EXPECT_TRUE(r >= 0 && r <= 1);
    if (type == "diffuse") return [=](const Direction&, const Direction&) { return 1 / kPi * reflectance; };
    EXPECT_EQ(m.parameters.at("bool remaproughness").at(0), "false");
    const double ax = m.number("uroughness"), ay = m.number("vroughness");
    EXPECT_GE(std::max(ax, ay), 1e-3);
    Colour eta, k{};
    if (type == "conductor") {
      eta = m.rgb("eta");
      k = m.rgb("k");
    } else {
      EXPECT_EQ(type, "coateddiffuse");
      EXPECT_EQ(reflectance, Colour{}) << "only a coat over black has a closed form";
      eta = m.number("eta") * Colour{1, 1, 1};
    }
    return [=](const Direction& l, const Direction& v) {
      const Direction h = halfVector(l, v);
      Colour f;
      for (std::size_t c = 0; c < 3; ++c) f[c] = fresnel(eta[c], k[c], dot(v, h));
      return ggx(h, ax, ay) / (1 + lambdaGgx(l, ax, ay) + lambdaGgx(v, ax, ay)) / (4 * l[2] * v[2]) * f;
    };
  }

 private:
  static std::vector<std::string> tokens(const std::string& code) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < code.size();) {
      if (std::isspace(static_cast<unsigned char>(code[i]))) {
        ++i;
      } else if (code[i] == '"') {
        const std::size_t end = code.find('"', i + 1);
        words.push_back(code.substr(i + 1, end - i - 1));
        i = end + 1;
      } else {
        std::size_t end = i + 1;
        if (code[i] != '[' && code[i] != ']')
          while (end < code.size() && !std::isspace(static_cast<unsigned char>(code[end])) && code[end] != ']') ++end;
        words.push_back(code.substr(i, end - i));
        i = end;
      }
    }
    return words;
  }

  std::map<std::string, PbrtMaterial> materials_;
};

TEST(Pbrt, HoldsItsOwnLobesExactly) {
  const auto material = parseMaterialExpression(
      "(0.3,0.1,0.05)*Lambertian + 0.4*GGX(alpha=0.2, alpha_y=0.1, ior=1.4) + "
      "0.25*GGXConductor(alpha=0.3, eta=(0.2,0.4,1.4), k=(3.9,2.4,1.6))");
  const ExportResult result = exported("pbrt", material);
  EXPECT_TRUE(result.exact) << result.reason;
  expectSame(PbrtReader(result.text).shading("material"), *material, 1e-9);
}

TEST(Pbrt, FillsAMixWithBlack) {
  const auto material = parseMaterialExpression("0.25*GGX(alpha=0.2, ior=1.4)");
  const ExportResult result = exported("pbrt", material);
  EXPECT_TRUE(result.exact) << result.reason;
  expectSame(PbrtReader(result.text).shading("material"), *material, 1e-9);
}

TEST(Pbrt, LeavesAFactorOfZeroOut) {
  const auto material = parseMaterialExpression("0*Lambertian + 0.5*GGX(alpha=0.2, ior=1.4)");
  expectSame(PbrtReader(exported("pbrt", material).text).shading("material"), *material, 1e-9);
}

TEST(Pbrt, ApproximatesAColouredHighlightByAMetalAndStatesTheError) {
  const auto material = parseMaterialExpression("(0.9,0.6,0.3)*GGX(alpha=0.2, ior=20)");
  const ExportResult result = exported("pbrt", material);
  EXPECT_NE(result.reason.find("colour"), std::string::npos) << result.reason;
  const Shading shading = PbrtReader(result.text).shading("material");
  expectSame(shading, *result.evaluated, 1e-9);
  expectStatedError(shading, result, *material, 1e-6);
  // Better by far than the same highlight in grey, which pbrt holds exactly.
  const auto grey = parseMaterialExpression("(0.6,0.6,0.6)*GGX(alpha=0.2, ior=20)");
  EXPECT_LT(result.error.comparison.metrics.at("rms"), 0.5 * compare(*grey, *material, 80).metrics.at("rms"));
}

TEST(Pbrt, RefusesAMirrorAndAnExcess) {
  EXPECT_NE(exported("pbrt", parseMaterialExpression("GGX(alpha=0.0005)")).reason.find("0.001"), std::string::npos);
  EXPECT_NE(exported("pbrt", parseMaterialExpression("0.5*Lambertian + GGX(alpha=0.2)")).reason.find("1.5"),
            std::string::npos);
}

}  // namespace
}  // namespace brdf::test
