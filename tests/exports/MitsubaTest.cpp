// Mitsuba 3's <bsdf>: read by pugixml, evaluated as the documentation of its plug-ins says.
#include "Renderer.h"

#include <pugixml.hpp>
#include <sstream>

namespace brdf::test {
namespace {

class MitsubaReader {
 public:
  explicit MitsubaReader(const std::string& text) {
    EXPECT_TRUE(document_.load_string(text.c_str()));
    root_ = document_.child("bsdf");
    EXPECT_TRUE(root_);
  }
  Shading shading() const { return read(root_); }
  pugi::xml_node root() const { return root_; }

 private:
  static pugi::xml_node property(pugi::xml_node bsdf, const char* name) {
    return bsdf.find_child_by_attribute("name", name);
  }
  static double number(pugi::xml_node bsdf, const char* name) {
    return property(bsdf, name).attribute("value").as_double(-1);
  }
  static Colour colour(pugi::xml_node bsdf, const char* name) {
    const pugi::xml_node node = property(bsdf, name);
    const std::string value = node.attribute("value").value();
    if (std::string_view(node.name()) == "spectrum") return std::stod(value) * Colour{1, 1, 1};
    EXPECT_STREQ(node.name(), "rgb");
    Colour result{};
    EXPECT_EQ(std::sscanf(value.c_str(), "%lf, %lf, %lf", &result[0], &result[1], &result[2]), 3) << value;
    return result;
  }

  static Shading read(pugi::xml_node bsdf) {
    const std::string type = bsdf.attribute("type").value();
    if (type == "blendbsdf") {
      const double w = number(bsdf, "weight");
      EXPECT_GE(w, 0);
      EXPECT_LE(w, 1);
      const Shading first = read(bsdf.child("bsdf")), second = read(bsdf.child("bsdf").next_sibling("bsdf"));
      return [=](const Direction& l, const Direction& v) { return (1 - w) * first(l, v) + w * second(l, v); };
    }
    if (type == "diffuse") {
      const Colour reflectance = colour(bsdf, "reflectance");
      for (const double r : reflectance) EXPECT_TRUE(r >= 0 && r <= 1) << "Mitsuba refuses a reflectance of " << r;
      return [=](const Direction&, const Direction&) { return 1 / kPi * reflectance; };
    }
    const bool metal = type == "roughconductor";
    EXPECT_TRUE(metal || type == "roughdielectric") << type;
    const bool isGgx = std::string_view(property(bsdf, "distribution").attribute("value").value()) == "ggx";
    const double ax = number(bsdf, "alpha_u"), ay = number(bsdf, "alpha_v");
    const Colour factor = colour(bsdf, "specular_reflectance");
    Colour eta, k{};
    if (metal) {
      eta = colour(bsdf, "eta");
      k = colour(bsdf, "k");
    } else {
      eta = number(bsdf, "int_ior") / number(bsdf, "ext_ior") * Colour{1, 1, 1};
      EXPECT_EQ(colour(bsdf, "specular_transmittance"), Colour{});
    }
    return [=](const Direction& l, const Direction& v) {
      const Direction m = halfVector(l, v);
      const double d = isGgx ? ggx(m, ax, ay) : beckmann(m, ax, ay);
      const auto g1 = [&](const Direction& w) { return isGgx ? 1 / (1 + lambdaGgx(w, ax, ay)) : g1Walter(w, ax, ay); };
      Colour f;
      for (std::size_t c = 0; c < 3; ++c) f[c] = factor[c] * fresnel(eta[c], k[c], dot(v, m));
      return d * g1(l) * g1(v) / (4 * l[2] * v[2]) * f;
    };
  }

  pugi::xml_document document_;
  pugi::xml_node root_;
};

TEST(Mitsuba, HoldsItsOwnLobesExactly) {
  const auto material = parseMaterialExpression(
      "(0.3,0.1,0.05)*Lambertian + 1.5*GGXWalter(alpha=0.2, alpha_y=0.1, ior=1.4) + "
      "(0.2,0.3,0.1)*Microfacet(D=Beckmann(alpha=0.3), F=Conductor(eta=(0.2,0.4,1.4), k=(3.9,2.4,1.6)), "
      "G=SmithSeparable)");
  const ExportResult result = exported("mitsuba", material);
  EXPECT_TRUE(result.exact) << result.reason;
  expectSame(MitsubaReader(result.text).shading(), *material, 1e-9);
}

TEST(Mitsuba, HoldsOneLobeWithoutABlend) {
  const auto material = parseMaterialExpression("1*GGXWalter(alpha=0.2, ior=1.5)");
  const ExportResult result = exported("mitsuba", material);
  const MitsubaReader reader(result.text);
  EXPECT_STREQ(reader.root().attribute("type").value(), "roughdielectric");
  EXPECT_STREQ(reader.root().attribute("id").value(), "material");
  expectSame(reader.shading(), *material, 1e-9);
}

TEST(Mitsuba, ApproximatesTheCorrelatedShadowingItLacksAndStatesTheError) {
  const auto material = parseMaterialExpression("(0.3,0.1,0.05)*Lambertian + GGX(alpha=0.2, ior=1.5)");
  const ExportResult result = exported("mitsuba", material);
  EXPECT_NE(result.reason.find("GGX"), std::string::npos);
  const Shading shading = MitsubaReader(result.text).shading();
  expectSame(shading, *result.evaluated, 1e-9);
  expectStatedError(shading, result, *material, 1e-6);
  EXPECT_LT(result.error.comparison.metrics.at("rms"), 0.02 * result.error.comparison.zeroModel.at("rms"));
}

TEST(Mitsuba, RefusesFactorsThatNoBlendHolds) {
  const ExportResult result = exported(
      "mitsuba", parseMaterialExpression("(0.7,0.1,0.1)*Lambertian + (0.1,0.5,0.5)*GGXWalter(alpha=0.2, ior=1.5)"));
  EXPECT_FALSE(result.exact);
  EXPECT_NE(result.reason.find("sum to 1.2"), std::string::npos) << result.reason;
}

}  // namespace
}  // namespace brdf::test
