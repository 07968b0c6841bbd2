// The glTF document: read as JSON, evaluated by the formulas of glTF's appendix B and of the extensions used.
#include "Renderer.h"

#include <nlohmann/json.hpp>

namespace brdf::test {
namespace {

using Json = nlohmann::json;

Shading read(const std::string& text) {
  const Json document = Json::parse(text);
  EXPECT_EQ(document.at("asset").at("version"), "2.0");
  const Json& material = document.at("materials").at(0);
  const Json extensions = material.value("extensions", Json::object());
  // Every extension that is used is declared, and the other way round.
  std::set<std::string> used, declared;
  for (const auto& [name, unused] : extensions.items()) used.insert(name);
  for (const Json& name : document.value("extensionsUsed", Json::array())) declared.insert(name);
  EXPECT_EQ(used, declared);
  const auto extension = [&](const char* name, const char* key, double standard) {
    return extensions.contains(name) ? extensions.at(name).at(key).get<double>() : standard;
  };
  const Json& pbr = material.at("pbrMetallicRoughness");
  const std::vector<double> base = pbr.at("baseColorFactor");
  EXPECT_EQ(base.size(), 4u);
  EXPECT_EQ(base[3], 1);
  for (const double b : base) EXPECT_TRUE(b >= 0 && b <= 1);
  const double metallic = pbr.at("metallicFactor"), roughness = pbr.at("roughnessFactor");
  const double ior = extension("KHR_materials_ior", "ior", 1.5);
  const double specular = extension("KHR_materials_specular", "specularFactor", 1);
  const double strength = extension("KHR_materials_anisotropy", "anisotropyStrength", 0);
  return [=](const Direction& l, const Direction& v) {
    const double alpha = roughness * roughness, along = alpha * (1 - strength * strength) + strength * strength;
    const Direction h = halfVector(l, v);
    const double w = std::pow(1 - dot(v, h), 5);
    const double glossy =
        ggx(h, along, alpha) / (1 + lambdaGgx(l, along, alpha) + lambdaGgx(v, along, alpha)) / (4 * l[2] * v[2]);
    const double f0 = std::pow((1 - ior) / (1 + ior), 2) * specular, fr = f0 + (specular - f0) * w;
    Colour result;
    for (std::size_t c = 0; c < 3; ++c) {
      const double metal = glossy * (base[c] + (1 - base[c]) * w);
      result[c] = (1 - metallic) * ((1 - fr) * base[c] / kPi + fr * glossy) + metallic * metal;
    }
    return result;
  };
}

TEST(Gltf, HoldsItsOwnMaterialExactly) {
  const auto material = parseMaterialExpression(
      "GltfMetallicRoughness(baseColor=(0.5,0.2,0.9), metallic=0.3, roughness=0.4, ior=1.8, specular=0.7, "
      "anisotropy=0.6)");
  const ExportResult result = exported("gltf", material);
  EXPECT_TRUE(result.exact) << result.reason;
  expectSame(read(result.text), *material, 1e-9);
}

TEST(Gltf, NeedsNoExtensionForThePlainMaterial) {
  const ExportResult result = exported("gltf", parseMaterialExpression("GltfMetallicRoughness(baseColor=0.5)"));
  EXPECT_EQ(result.text.find("extensionsUsed"), std::string::npos);
}

TEST(Gltf, ApproximatesPlasticAndMetalAndStatesTheError) {
  for (const char* expression : {"(0.3,0.1,0.05)*Lambertian + GGX(alpha=0.2, ior=1.5)",
                                 "GGXConductor(alpha=0.2, eta=(0.2,0.4,1.4), k=(3.9,2.4,1.6))"}) {
    const auto material = parseMaterialExpression(expression);
    const ExportResult result = exported("gltf", material);
    const Shading shading = read(result.text);
    expectSame(shading, *result.evaluated, 1e-9);
    expectStatedError(shading, result, *material, 1e-6);
    EXPECT_LT(result.error.comparison.metrics.at("rms"), 0.1 * result.error.comparison.zeroModel.at("rms"))
        << expression;
  }
}

TEST(Gltf, FindsTheMaterialItCameFrom) {
  // The same numbers in a form that glTF does not have: twice half of it.
  const auto half = "0.5*GltfMetallicRoughness(baseColor=(0.5,0.2,0.9), metallic=1, roughness=0.4)";
  const auto material = parseMaterialExpression(std::string(half) + " + " + half);
  const ExportResult result = exported("gltf", material);
  EXPECT_FALSE(result.exact);
  EXPECT_LT(result.error.comparison.metrics.at("rms"), 1e-3 * result.error.comparison.zeroModel.at("rms"));
}

}  // namespace
}  // namespace brdf::test
