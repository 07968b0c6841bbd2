#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/Presets.h>
#include <brdf/material/LobeSum.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <set>

using brdf::Direction;
using brdf::kPi;
using Numbers = std::function<double(const char* name)>;

namespace {

/// What the published equations are written in.
struct Geometry {
  double hz, c, ci, co;  ///< cosines: normal and half vector, light and half vector, light, viewer
  double ti, to;         ///< polar angles of light and viewer
  double tan2;           ///< squared tangent of the half vector's polar angle

  Geometry(const Direction& wi, const Direction& wo) {
    const Direction h = brdf::normalized({wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]});
    hz = h[2];
    c = brdf::dot(wi, h);
    ci = wi[2];
    co = wo[2];
    ti = std::acos(ci);
    to = std::acos(co);
    tan2 = (h[0] * h[0] + h[1] * h[1]) / (hz * hz);
  }
};

double schlick(double f0, double c) { return f0 + (1 - f0) * std::pow(1 - c, 5); }

/// Unpolarised Fresnel reflectance of a dielectric (Cook and Torrance 1982).
double fresnel(double n, double c) {
  const double g = std::sqrt(n * n - 1 + c * c);
  const double a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
  return 0.5 * a * a * (1 + b * b);
}

/// Ward 1992, equation (5a), isotropic, without the diffuse term and the specular factor.
double ward(const Geometry& q, const Numbers& p) {
  const double a = p("ax");
  return std::exp(-q.tan2 / (a * a)) / (4 * kPi * a * a * std::sqrt(q.ci * q.co));
}

/// Ashikhmin and Shirley 2000, equation (4), isotropic.
double ashikhminShirley(const Geometry& q, const Numbers& p) {
  const double n = p("nu");
  return (n + 1) / (8 * kPi) * std::pow(q.hz, n) * schlick(p("F0"), q.c) / (q.c * std::max(q.ci, q.co));
}

/// Cook and Torrance 1981, as printed (D without 1/pi, and D F G / (pi cos cos)).
double cookTorrance1981(const Geometry& q, const Numbers& p) {
  const double m2 = p("m") * p("m");
  const double d = std::exp(-q.tan2 / m2) / (m2 * std::pow(q.hz, 4));
  const double g = std::min({1.0, 2 * q.hz * q.ci / q.c, 2 * q.hz * q.co / q.c});
  return d * fresnel(p("ior"), q.c) * g / (kPi * q.ci * q.co);
}

/// Bagher, Soler, Holzschuch 2012, equations (10) to (13); their shadowing and Fresnel terms, negative for some
/// published parameters, taken as 0 there.
double shiftedGamma(const Geometry& q, const Numbers& p) {
  const double x = p("alpha") + q.tan2 / p("alpha");
  const double d = p("K") * std::exp(-x) * std::pow(x, -p("p")) / (kPi * std::pow(q.hz, 4));
  const double f = schlick(p("F0"), q.c) - p("F1") * q.c;
  const auto g1 = [&](double theta) {
    if (theta <= p("theta0")) return 1.0;
    return std::max(0.0, 1 + p("Lambda") * (1 - std::exp(p("c") * std::pow(theta - p("theta0"), p("k")))));
  };
  return d * std::max(0.0, f) * g1(q.ti) * g1(q.to) / (kPi * q.ci * q.co);
}

struct Published {
  const char* prefix;  ///< of the preset's name
  const char* file;    ///< of the published figures
  double (*value)(const Geometry&, const Numbers&);
  double factor;                                           ///< our specular scale over the published one
  std::vector<std::pair<const char*, const char*>> names;  ///< our parameter, the file's
};
const std::vector<Published> kPublished = {
    {"bagher-sgd-",
     "bagher_sgd.json",
     shiftedGamma,
     1,
     {{"alpha", "alpha"}, {"p", "p"}, {"K", "K"}, {"Lambda", "Lambda"}, {"c", "c"}, {"k", "k"}, {"theta0", "theta0"}}},
    {"ngan-ward-", "ngan_ward.json", ward, 1, {{"ax", "roughness"}, {"ay", "roughness"}}},
    {"ngan-ashikhminshirley-",
     "ngan_ashikhminshirley.json",
     ashikhminShirley,
     1,
     {{"nu", "sharpness"}, {"nv", "sharpness"}, {"F0", "fresnelReflectance"}}},
    {"low-cooktorrance-", "low_cooktorrance_E2.json", cookTorrance1981, 4, {{"m", "roughness"}, {"ior", "eta"}}}};

const Published& publishedFormOf(const brdf::Preset& preset) {
  return *std::find_if(kPublished.begin(), kPublished.end(),
                       [&](const Published& form) { return preset.name.starts_with(form.prefix); });
}

/// Pairs over the hemisphere, the mirror direction's neighbourhood and grazing.
std::vector<std::pair<Direction, Direction>> someDirections() {
  std::vector<std::pair<Direction, Direction>> pairs;
  for (const double ti : {0.0, 10.0, 35.0, 60.0, 80.0, 88.0})
    for (const double to : {0.5, 11.0, 34.0, 61.0, 79.0, 89.0})
      for (const double phi : {0.0, 5.0, 90.0, 178.0, 180.0})
        pairs.emplace_back(brdf::fromSpherical(brdf::radians(ti), 0.3),
                           brdf::fromSpherical(brdf::radians(to), 0.3 + brdf::radians(phi)));
  return pairs;
}

}  // namespace

TEST(Presets, ThereAreADozenAndEachIsCited) {
  EXPECT_GE(brdf::presets().size(), 12U);
  std::set<std::string> names;
  for (const brdf::Preset& preset : brdf::presets()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    EXPECT_TRUE(preset.doi.starts_with("10.")) << preset.name;
    EXPECT_NE(preset.citation.find(preset.doi), std::string::npos) << preset.name;
    EXPECT_FALSE(preset.conversion.empty()) << preset.name;
    EXPECT_FALSE(preset.measured.empty()) << preset.name;
    EXPECT_EQ(preset.expression.find('\n'), std::string::npos) << preset.name;
    EXPECT_EQ(&brdf::findPreset(preset.name), &preset);
  }
}

TEST(Presets, AnUnknownNameIsAnError) { EXPECT_THROW(brdf::findPreset("nothing"), brdf::Error); }

TEST(Presets, EachHasTheValueOfThePublishedEquation) {
  for (const brdf::Preset& preset : brdf::presets()) {
    const auto material = brdf::parseMaterialExpression(preset.expression);
    ASSERT_EQ(material->lobes().size(), 2U) << preset.name;
    const brdf::Lobe &diffuse = material->lobes()[0], &specular = material->lobes()[1];
    const Published& form = publishedFormOf(preset);
    std::size_t brightPairs = 0;
    for (const auto& [wi, wo] : someDirections()) {
      const std::vector<double> values = material->evaluate(wi, wo);
      ASSERT_EQ(values.size(), 3U);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto parameters = specular.parametersOf(channel);
        const Numbers number = [&](const char* name) { return parameters[specular.model->parameterIndex(name)]; };
        const double expected = diffuse.scaleOf(channel) / kPi +
                                specular.scaleOf(channel) / form.factor * form.value(Geometry(wi, wo), number);
        // The equations as printed take differences of angles and high powers: their own rounding is the tolerance.
        EXPECT_NEAR(values[channel], expected, 1e-10 * expected) << preset.name << ", channel " << channel;
        brightPairs += expected > 2 * diffuse.scaleOf(channel) / kPi;
      }
    }
    EXPECT_GT(brightPairs, 10U) << preset.name << ": the specular lobe was not tested";
  }
}

TEST(Presets, FiguresAreThePublishedOnes) {
  const auto folder = std::filesystem::path(BRDF_SHARED_DIR) / "data" / "published_fits";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the published tables are not at " << folder;
  for (const brdf::Preset& preset : brdf::presets()) {
    const Published& form = publishedFormOf(preset);
    const auto document = nlohmann::json::parse(brdf::readFile(folder / form.file));
    const auto& lobes = document["materials"][preset.measured];
    ASSERT_EQ(lobes.size(), 2U) << preset.name;
    const auto material = brdf::parseMaterialExpression(preset.expression);
    const brdf::Lobe& specular = material->lobes()[1];
    const auto published = [&](const nlohmann::json& figure, std::size_t channel) {
      return figure.is_array() ? figure[channel].get<double>() : figure.get<double>();
    };
    for (std::size_t channel = 0; channel < 3; ++channel) {
      EXPECT_EQ(material->lobes()[0].scaleOf(channel), published(lobes[0]["albedo"], channel)) << preset.name;
      EXPECT_NEAR(specular.scaleOf(channel), form.factor * published(lobes[1]["albedo"], channel), 1e-15)
          << preset.name;
      const auto parameters = specular.parametersOf(channel);
      const auto ours = [&](const char* name) { return parameters[specular.model->parameterIndex(name)]; };
      for (const auto& [name, theirs] : form.names)
        EXPECT_EQ(ours(name), published(lobes[1][theirs], channel)) << preset.name << " " << name;
      if (form.value == shiftedGamma) {
        EXPECT_EQ(ours("F0"), published(lobes[1]["eta"][0], channel)) << preset.name;
        EXPECT_EQ(ours("F1"), published(lobes[1]["eta"][1], channel)) << preset.name;
      }
    }
  }
}
