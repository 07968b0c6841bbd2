// MaterialX documents: the graph read by pugixml and evaluated as the specification of its nodes says; directional
// albedos by quadrature here.
#include "Renderer.h"

#include <algorithm>
#include <map>
#include <pugixml.hpp>

namespace brdf::test {
namespace {

/// Integral of D G2/(4 cos cos) F(cos_d) cos over the lights for a viewer at polar angle of cosine mu: in slopes of the
/// half vector, t = tan(theta_m) = alpha tan(pi u/2) so that GGX's tail is even.
double albedo(double mu, double alpha, const std::function<double(double)>& f) {
  const Direction v{std::sqrt(1 - mu * mu), 0, mu};
  constexpr int n = 400, turns = 200;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < turns; ++j) {
      const double angle = kPi / 2 * (i + 0.5) / n, phi = 2 * kPi * (j + 0.5) / turns;
      const double t = alpha * std::tan(angle), cosine = 1 / std::sqrt(1 + t * t), sine = t * cosine;
      const Direction m{sine * std::cos(phi), sine * std::sin(phi), cosine};
      const double d = dot(v, m);
      const Direction l{2 * d * m[0] - v[0], 2 * d * m[1] - v[1], 2 * d * m[2] - v[2]};
      if (d <= 0 || l[2] <= 0) continue;
      const double value = ggx(m, alpha, alpha) / (1 + lambdaGgx(l, alpha, alpha) + lambdaGgx(v, alpha, alpha)) /
                           (4 * l[2] * v[2]) * f(d);
      // d omega_l = 4 d d omega_m, d omega_m = sin dtheta dphi, dtheta = alpha/cos^2(angle) cos^2 dangle.
      const double jacobian = 4 * d * sine * alpha / std::pow(std::cos(angle), 2) * cosine * cosine;
      sum += value * l[2] * jacobian * (kPi / 2 / n) * (2 * kPi / turns);
    }
  return sum;
}

double meanFresnel(const std::function<double(double)>& f) {
  double sum = 0;
  for (int i = 0; i < 2000; ++i) {
    const double c = (i + 0.5) / 2000;
    sum += 2 * c * f(c) / 2000;
  }
  return sum;
}

/// E(mu, alpha) is slow: kept.
double cachedAlbedo(double mu, double alpha) {
  static std::map<std::pair<double, double>, double> known;
  const auto [it, fresh] = known.try_emplace({mu, alpha}, 0);
  if (fresh) it->second = albedo(mu, alpha, [](double) { return 1.0; });
  return it->second;
}

/// The same with Schlick's Fresnel term.
double cachedAlbedo(double mu, double alpha, double f0) {
  static std::map<std::array<double, 3>, double> known;
  const auto [it, fresh] = known.try_emplace({mu, alpha, f0}, 0);
  if (fresh) it->second = albedo(mu, alpha, [f0](double x) { return schlick(f0, x); });
  return it->second;
}

/// A microfacet node with Fresnel terms for three channels.
Shading microfacet(double ax, double ay, const std::array<std::function<double(double)>, 3>& f) {
  Colour mean;
  for (std::size_t c = 0; c < 3; ++c) mean[c] = meanFresnel(f[c]);
  return [=](const Direction& l, const Direction& v) {
    const Direction h = halfVector(l, v);
    const double a = std::sqrt(ax * ay), e = cachedAlbedo(v[2], a);
    const auto share = [&](double c) { return std::sqrt(a * a + (1 - a * a) * c * c); };
    const double g2 = 2 * l[2] * v[2] / (share(v[2]) * l[2] + share(l[2]) * v[2]);
    Colour result;
    for (std::size_t c = 0; c < 3; ++c)
      result[c] = ggx(h, ax, ay) * g2 / (4 * l[2] * v[2]) * f[c](dot(v, h)) * (1 + mean[c] * (1 - e) / e);
    return result;
  };
}

/// Directional albedo of Fujii's model by quadrature.
double fujii(const Direction& l, const Direction& v, double r) {
  const double s = l[0] * v[0] + l[1] * v[1], t = s > 0 ? std::max(l[2], v[2]) : 1;
  return (1 + r * s / t) / (1 + (0.5 - 2 / (3 * kPi)) * r) / kPi;
}
double fujiiAlbedo(double mu, double r) {
  static std::map<std::pair<double, double>, double> known;
  const auto [it, fresh] = known.try_emplace({mu, r}, 0);
  if (!fresh) return it->second;
  const Direction v{std::sqrt(1 - mu * mu), 0, mu};
  double sum = 0;
  for (int i = 0; i < 500; ++i)
    for (int j = 0; j < 360; ++j) {
      const double c = (i + 0.5) / 500, s = std::sqrt(1 - c * c), phi = 2 * kPi * (j + 0.5) / 360;
      sum += fujii({s * std::cos(phi), s * std::sin(phi), c}, v, r) * c * (2 * kPi / 360) / 500;
    }
  return it->second = sum;
}
Shading eon(const Colour& rho, double r) {
  double mean = 0;
  for (int i = 0; i < 64; ++i) mean += 2 * (i + 0.5) / 64 * fujiiAlbedo((i + 0.5) / 64, r) / 64;
  return [=](const Direction& l, const Direction& v) {
    const double lost = (1 - fujiiAlbedo(l[2], r)) * (1 - fujiiAlbedo(v[2], r)) / (kPi * std::max(1 - mean, 1e-9));
    Colour result;
    for (std::size_t c = 0; c < 3; ++c)
      result[c] = rho[c] * fujii(l, v, r) + (r > 0 ? rho[c] * rho[c] * mean / (1 - rho[c] * (1 - mean)) * lost : 0);
    return result;
  };
}

class MaterialXReader {
 public:
  explicit MaterialXReader(const std::string& text) {
    EXPECT_TRUE(document_.load_string(text.c_str()));
    root_ = document_.child("materialx");
    EXPECT_STREQ(root_.attribute("version").value(), "1.39");
  }
  Shading shading() const {
    const pugi::xml_node material = root_.child("surfacematerial");
    EXPECT_STREQ(material.attribute("name").value(), "material");
    const pugi::xml_node surface = source(material, "surfaceshader");
    if (std::string_view(surface.name()) == "open_pbr_surface") return openPbr(surface);
    if (std::string_view(surface.name()) == "standard_surface") return standardSurface(surface);
    EXPECT_STREQ(surface.name(), "surface");
    return read(source(surface, "bsdf"));
  }

 private:
  static pugi::xml_node input(pugi::xml_node node, const char* name) {
    const pugi::xml_node found = node.find_child_by_attribute("input", "name", name);
    EXPECT_TRUE(found) << node.attribute("name").value() << " lacks " << name;
    return found;
  }
  pugi::xml_node source(pugi::xml_node node, const char* name) const {
    return root_.find_child_by_attribute("name", input(node, name).attribute("nodename").value());
  }
  static double number(pugi::xml_node node, const char* name) {
    EXPECT_STREQ(input(node, name).attribute("type").value(), "float");
    return input(node, name).attribute("value").as_double();
  }
  static Colour colour(pugi::xml_node node, const char* name) {
    EXPECT_STREQ(input(node, name).attribute("type").value(), "color3");
    Colour result{};
    EXPECT_EQ(
        std::sscanf(input(node, name).attribute("value").value(), "%lf, %lf, %lf", &result[0], &result[1], &result[2]),
        3);
    return result;
  }
  static std::array<double, 2> roughness(pugi::xml_node node) {
    EXPECT_STREQ(input(node, "roughness").attribute("type").value(), "vector2");
    std::array<double, 2> result{};
    EXPECT_EQ(std::sscanf(input(node, "roughness").attribute("value").value(), "%lf, %lf", &result[0], &result[1]), 2);
    return result;
  }

  Shading read(pugi::xml_node node) const {
    const std::string kind = node.name();
    EXPECT_STREQ(node.attribute("type").value(), "BSDF");
    if (kind == "add") {
      const Shading a = read(source(node, "in1")), b = read(source(node, "in2"));
      return [=](const Direction& l, const Direction& v) { return a(l, v) + b(l, v); };
    }
    if (kind == "multiply") {
      const Shading a = read(source(node, "in1"));
      const Colour s = colour(node, "in2");
      return [=](const Direction& l, const Direction& v) { return s * a(l, v); };
    }
    if (kind == "oren_nayar_diffuse_bsdf") {
      const Colour rho = colour(node, "color");
      const double sigma = number(node, "roughness"), s2 = sigma * sigma;
      if (input(node, "energy_compensation").attribute("value").as_bool()) return eon(rho, sigma);
      return [=](const Direction& l, const Direction& v) {
        const double s = l[0] * v[0] + l[1] * v[1];
        return (1 - 0.5 * s2 / (s2 + 0.33) + 0.45 * s2 / (s2 + 0.09) * std::max(0.0, s) / std::max(l[2], v[2])) / kPi *
               rho;
      };
    }
    const auto [ax, ay] = roughness(node);
    std::array<std::function<double(double)>, 3> f;
    for (std::size_t c = 0; c < 3; ++c) {
      if (kind == "dielectric_bsdf") {
        f[c] = [n = number(node, "ior")](double x) { return fresnel(n, 0, x); };
      } else if (kind == "conductor_bsdf") {
        f[c] = [n = colour(node, "ior")[c], k = colour(node, "extinction")[c]](double x) { return fresnel(n, k, x); };
      } else {
        EXPECT_EQ(kind, "generalized_schlick_bsdf");
        f[c] = [f0 = colour(node, "color0")[c]](double x) { return schlick(f0, x); };
        EXPECT_EQ(colour(node, "color90"), (Colour{1, 1, 1}));
        EXPECT_EQ(number(node, "exponent"), 5);
      }
    }
    return microfacet(ax, ay, f);
  }

  static Shading openPbr(pugi::xml_node node) {
    const Colour base = colour(node, "base_color");
    const double metalness = number(node, "base_metalness"), r = number(node, "specular_roughness"),
                 across = 1 - number(node, "specular_roughness_anisotropy"), n = number(node, "specular_ior");
    const double ax = r * r * std::sqrt(2 / (1 + across * across)), ay = across * ax;
    std::array<std::function<double(double)>, 3> metal, glass;
    for (std::size_t c = 0; c < 3; ++c) {
      metal[c] = [f0 = base[c]](double x) { return schlick(f0, x); };
      glass[c] = [n](double x) { return fresnel(n, 0, x); };
    }
    const Shading metalLobe = microfacet(ax, ay, metal), coat = microfacet(ax, ay, glass),
                  diffuse = eon(base, number(node, "base_diffuse_roughness"));
    const double f0 = std::pow((n - 1) / (n + 1), 2), a = std::sqrt(ax * ay), mean = meanFresnel(glass[0]);
    return [=](const Direction& l, const Direction& v) {
      const double e = cachedAlbedo(v[2], a), top = cachedAlbedo(v[2], a, f0) * (1 + mean * (1 - e) / e);
      return (1 - metalness) * (coat(l, v) + (1 - top) * diffuse(l, v)) + metalness * metalLobe(l, v);
    };
  }

  /// The graph NG_standard_surface of MaterialX 1.39 where it has a dielectric alone or a metal alone, with the nodes
  /// roughness_anisotropy and artistic_ior (O. Gulbrandsen 2014, JCGT 3(4)).
  static Shading standardSurface(pugi::xml_node node) {
    EXPECT_EQ(number(node, "base"), 1);
    EXPECT_EQ(number(node, "specular"), 1);
    EXPECT_EQ(number(node, "diffuse_roughness"), 0);
    const Colour base = colour(node, "base_color"), edge = colour(node, "specular_color");
    const double r = number(node, "specular_roughness");
    if (number(node, "metalness") == 0) {
      EXPECT_EQ(edge, (Colour{1, 1, 1}));
      const double n = number(node, "specular_IOR"), a = r * r, f0 = std::pow((n - 1) / (n + 1), 2);
      const std::function<double(double)> glass = [n](double x) { return fresnel(n, 0, x); };
      const Shading top = microfacet(a, a, {glass, glass, glass});
      const double mean = meanFresnel(glass);
      return [=](const Direction& l, const Direction& v) {
        const double e = cachedAlbedo(v[2], a), through = 1 - cachedAlbedo(v[2], a, f0) * (1 + mean * (1 - e) / e);
        return top(l, v) + through / kPi * base;
      };
    }
    EXPECT_EQ(number(node, "metalness"), 1);
    const double aspect = std::sqrt(1 - number(node, "specular_anisotropy"));
    double ax = std::min(r * r / aspect, 1.0), ay = r * r * aspect;
    if (const double turn = number(node, "specular_rotation"); turn != 0) {
      EXPECT_EQ(turn, 0.25);  // a right angle
      std::swap(ax, ay);
    }
    std::array<std::function<double(double)>, 3> metal;
    for (std::size_t c = 0; c < 3; ++c) {
      const double f0 = std::clamp(base[c], 0.0, 0.99), least = (1 - f0) / (1 + f0),
                   most = (1 + std::sqrt(f0)) / (1 - std::sqrt(f0)), n = most + (least - most) * edge[c];
      EXPECT_GE(edge[c], 0);
      EXPECT_LE(edge[c], 1);
      const double k = std::sqrt(std::max(0.0, (f0 * (n + 1) * (n + 1) - (n - 1) * (n - 1)) / (1 - f0)));
      metal[c] = [n, k](double x) { return fresnel(n, k, x); };
    }
    return microfacet(ax, ay, metal);
  }

  pugi::xml_document document_;
  pugi::xml_node root_;
};

// Tables of albedo with 32 x 32 nodes stand behind the lobes: their interpolation is what 3e-3 allows.
TEST(MaterialX, HoldsItsOwnLobesExactly) {
  const auto material = parseMaterialExpression(
      "(0.3,0.1,0.05)*OrenNayar(sigma=0.4) + (0.1,0.2,0.3)*Lambertian + 0.5*MaterialXDielectric(alpha=0.3, ior=1.4) + "
      "(0.2,0.3,0.1)*MaterialXConductor(alpha=0.4, alpha_y=0.2, eta=(0.2,0.4,1.4), k=(3.9,2.4,1.6)) + "
      "0.1*MaterialXSchlick(alpha=0.6, F0=(0.2,0.5,0.9))");
  const ExportResult result = exported("materialx", material);
  EXPECT_TRUE(result.exact) << result.reason;
  expectSame(MaterialXReader(result.text).shading(), *material, 3e-3);
}

TEST(MaterialX, HoldsEonExactly) {
  const auto material = parseMaterialExpression("EON(rho=(0.3,0.8,1), r=0.7)");
  const ExportResult result = exported("materialx", material);
  EXPECT_TRUE(result.exact) << result.reason;
  expectSame(MaterialXReader(result.text).shading(), *material, 1e-3);
}

TEST(MaterialX, ApproximatesAMetalAndStatesTheError) {
  const auto material = parseMaterialExpression("GGXConductor(alpha=0.2, eta=(0.2,0.4,1.4), k=(3.9,2.4,1.6))");
  const ExportResult result = exported("materialx", material);
  EXPECT_FALSE(result.exact);
  expectSame(MaterialXReader(result.text).shading(), *result.evaluated, 3e-3);
  EXPECT_LT(result.error.comparison.metrics.at("rms"), 0.02 * result.error.comparison.zeroModel.at("rms"));
}

TEST(OpenPbr, HoldsItsOwnMaterialExactly) {
  const auto material = parseMaterialExpression(
      "OpenPBR(base_color=(0.3,0.6,0.9), base_metalness=0.25, base_diffuse_roughness=0.5, specular_roughness=0.5, "
      "specular_roughness_anisotropy=0.4, specular_ior=1.6)");
  const ExportResult result = exported("openpbr", material);
  EXPECT_TRUE(result.exact) << result.reason;
  expectSame(MaterialXReader(result.text).shading(), *material, 3e-3);
}

TEST(OpenPbr, ApproximatesPlastic) {
  const auto material = parseMaterialExpression("(0.3,0.1,0.05)*Lambertian + GGX(alpha=0.2, ior=1.5)");
  const ExportResult result = exported("openpbr", material);
  EXPECT_FALSE(result.exact);
  expectSame(MaterialXReader(result.text).shading(), *result.evaluated, 3e-3);
  EXPECT_LT(result.error.comparison.metrics.at("rms"), 0.03 * result.error.comparison.zeroModel.at("rms"));
}

TEST(StandardSurface, HoldsADielectricOverDiffuseReflectionExactly) {
  const auto material = parseMaterialExpression(
      "OpenPBR(base_color=(0.3,0.6,0.9), base_metalness=0, base_diffuse_roughness=0, specular_roughness=0.5, "
      "specular_ior=1.6)");
  const ExportResult result = exported("standard_surface", material);
  EXPECT_TRUE(result.exact) << result.reason;
  expectSame(MaterialXReader(result.text).shading(), *material, 3e-3);
}

TEST(StandardSurface, HoldsAMetalAlongAndAcrossTheTangentExactly) {
  for (const char* width : {"alpha=0.4, alpha_y=0.2", "alpha=0.2, alpha_y=0.5", "alpha=0.3"}) {
    const auto material =
        parseMaterialExpression("MaterialXConductor(" + std::string(width) + ", eta=(0.2,0.4,1.4), k=(3.9,2.4,1.6))");
    const ExportResult result = exported("standard_surface", material);
    EXPECT_TRUE(result.exact) << result.reason;
    expectSame(MaterialXReader(result.text).shading(), *material, 3e-3);
  }
}

TEST(StandardSurface, ApproximatesWhatItLacksAndStatesTheError) {
  for (const auto& [text, part] :
       {std::pair<const char*, double>{"(0.3,0.1,0.05)*Lambertian + GGX(alpha=0.2, ior=1.5)", 0.03},
        {"GGXConductor(alpha=0.2, eta=(0.2,0.4,1.4), k=(3.9,2.4,1.6))", 0.03},
        // Reflects more than the 0.99 that artistic_ior has.
        {"MaterialXConductor(alpha=0.3, eta=0.01, k=5)", 0.05}}) {
    const ExportResult result = exported("standard_surface", parseMaterialExpression(text));
    EXPECT_FALSE(result.exact) << text;
    EXPECT_EQ(findExporter("standard_surface").refusal(*result.evaluated), "") << result.evaluated->description();
    expectSame(MaterialXReader(result.text).shading(), *result.evaluated, 3e-3);
    EXPECT_LT(result.error.comparison.metrics.at("rms"), part * result.error.comparison.zeroModel.at("rms")) << text;
  }
}

}  // namespace
}  // namespace brdf::test
