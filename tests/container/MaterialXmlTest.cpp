#include <brdf/base/File.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/BrdfLabXml.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/io/MaterialXml.h>
#include <brdf/io/SaveMaterial.h>
#include <gtest/gtest.h>

#include <cmath>

#include "Samples.h"

namespace fs = std::filesystem;
using brdf::Direction;
using brdf::kPi;
using brdf::loadMaterial;
using samples::errorOf;
using samples::freshFolder;

namespace {

const fs::path kData = fs::path(BRDF_SOURCE_DIR) / "tests/data/xml";

std::string dataFile(const char* name) { return (kData / name).string(); }

/// A light, a viewer, and the quantities that the old formulas are written in.
struct Setting {
  Direction u = brdf::fromSpherical(0.6, 0.2), v = brdf::fromSpherical(0.4, 2.9);
  Direction h = brdf::normalized({u[0] + v[0], u[1] + v[1], u[2] + v[2]});
  double tan2() const { return (h[0] * h[0] + h[1] * h[1]) / (h[2] * h[2]); }
};

void expectSameValues(const brdf::Brdf& a, const brdf::Brdf& b, double tolerance) {
  for (const auto& [theta, phi] : {std::pair{0.1, 0.0}, {0.9, 2.0}, {1.3, 3.1}}) {
    const Direction u = brdf::fromSpherical(0.6, 0.2), v = brdf::fromSpherical(theta, phi);
    const auto left = a.evaluate(u, v), right = b.evaluate(u, v);
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t c = 0; c < left.size(); ++c) EXPECT_NEAR(left[c], right[c], tolerance * std::abs(right[c]));
  }
}

}  // namespace

TEST(MaterialXml, HandWrittenMaterialEqualsItsExpression) {
  const auto loaded = loadMaterial(dataFile("material.xml"));
  EXPECT_EQ(loaded.kind, "material");
  EXPECT_EQ(loaded.brdf->description(),
            brdf::parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + 0.5*Ward(ax=(0.25,0.5,0.25))")->description());
}

TEST(MaterialXml, RoundTripIsExact) {
  for (const char* text : {"0.3*Lambertian", "(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)",
                           "Microfacet(D=Beckmann(alpha=0.1), F=Conductor(eta=0.2, k=3), G=Smith)",
                           "Ward(ax=(0.1,0.2,0.3), ay=(0.2,0.3,0.1234567890123456789))"}) {
    const auto material = brdf::parseMaterialExpression(text);
    const auto back = brdf::readMaterialXml(brdf::writeMaterialXml(*material), "test");
    EXPECT_EQ(back->description(), material->description());
    EXPECT_EQ(back->channels(), material->channels());
  }
  const auto spectral = brdf::parseMaterialExpression("(0.3,0.2)*Lambertian", brdf::Channels::spectral({450, 650.5}));
  EXPECT_EQ(brdf::readMaterialXml(brdf::writeMaterialXml(*spectral), "test")->channels(), spectral->channels());
}

TEST(MaterialXml, MistakesAreNamed) {
  const struct {
    const char *text, *expected;
  } cases[] = {{"<material><lobe model='Nonsense'/></material>", "Nonsense"},
               {"<material><lobe model='GGX'><parameter name='beta'>1</parameter></lobe></material>", "beta"},
               {"<material><lobe model='GGX'><parameter name='alpha'>x</parameter></lobe></material>", "no number"},
               {"<material><lobe model='GGX'><parameter name='alpha'>7</parameter></lobe></material>", "out of bounds"},
               {"<material><lobe model='Lambertian'><scale>1 2</scale></lobe></material>", "wrong number of values"},
               {"<material channels='spectral' wavelengths='650 450'/>", "ascending"},
               {"<material version='2'/>", "version"},
               {"<material/>", "at least one lobe"},
               {"<material", "not well-formed"}};
  for (const auto& [text, expected] : cases) {
    const std::string error = errorOf([&] { brdf::readMaterialXml(text, "test"); });
    EXPECT_NE(error.find(expected), std::string::npos) << text << ": " << error;
  }
}

TEST(BrdfLabXml, LinearFitHasTheOldProgramsValues) {
  const auto loaded = loadMaterial(dataFile("fits.xml"));
  ASSERT_FALSE(loaded.report.warnings.empty());
  EXPECT_NE(loaded.report.warnings[0].find("nowhere.binary"), std::string::npos) << "the original is not at hand";
  EXPECT_EQ(loaded.report.metadata.at("optimizer"), "levmar");
  const Setting s;
  const double inside = -0.5 * (s.u[0] * s.v[0] + s.u[1] * s.v[1]) + 0.4 * s.u[2] * s.v[2];
  const double lafortune = std::pow(std::max(0.0, inside), 2) * (2 + 2) / (2 * kPi * std::pow(0.5, 2));
  const auto value = loaded.brdf->evaluate(s.u, s.v);
  EXPECT_NEAR(value[0], 0.1 + lafortune, 1e-14);
  EXPECT_NEAR(value[1], 0.02 + 2 * lafortune, 1e-14);
  EXPECT_NEAR(value[2], 3 * lafortune, 1e-14);
}

TEST(BrdfLabXml, FixedFitHasAShapeForEachChannel) {
  const auto loaded = loadMaterial(dataFile("fits.xml") + "#2");
  const Setting s;
  const auto blinn = [&](double n) { return (n + 2) / (2 * kPi) * std::pow(s.h[2], n); };
  const double ward = std::exp(-s.tan2() / 0.25 / (4 * kPi * 0.25)) / std::sqrt(s.u[2] * s.v[2]);
  const auto value = loaded.brdf->evaluate(s.u, s.v);
  EXPECT_NEAR(value[0], 0.1 + blinn(4), 1e-14);
  EXPECT_NEAR(value[1], 0.2 + blinn(6), 1e-14);
  EXPECT_NEAR(value[2], 0.3 + ward, 1e-14);
  bool counted = false;
  for (const std::string& note : loaded.report.assumptions)
    counted = counted || note.find("nLobes says 7") != std::string::npos;
  EXPECT_TRUE(counted);
}

TEST(BrdfLabXml, EntriesArePickedByNumberAndName) {
  const std::string file = dataFile("fits.xml");
  EXPECT_EQ(loadMaterial(file + "#Both").brdf->description(), loadMaterial(file + "#1").brdf->description());
  EXPECT_EQ(loadMaterial(file + "#Fit-1").brdf->description(), loadMaterial(file + "#2").brdf->description());
  EXPECT_NE(errorOf([&] { loadMaterial(file + "#0"); }).find("not at hand"), std::string::npos);
  EXPECT_NE(errorOf([&] { loadMaterial(file + "#7"); }).find("2 (Fit-1)"), std::string::npos);
}

TEST(BrdfLabXml, AModelFileIsItsLobe) {
  const auto loaded = loadMaterial(dataFile("model.xml"));
  EXPECT_NEAR(loaded.brdf->evaluate(brdf::fromSpherical(0.3, 0), {0, 0, 1})[0], 0.25, 1e-15);
  EXPECT_NEAR(loaded.brdf->evaluate(brdf::fromSpherical(1.3, 0), {0, 0, 1})[0], 0.5, 1e-15);
  EXPECT_EQ(brdf::parseMaterialExpression(loaded.brdf->description())->description(), loaded.brdf->description());
}

TEST(BrdfLabXml, WritesBothCombinations) {
  for (const char* text : {"(0.3,0.2,0.1)*Lambertian + (0.5,1,2)*Lafortune(Cx=-0.9, Cy=-0.9, Cz=0.8, n=12)",
                           "0.1*Lambertian + 0.5*BRDFLab082Ward(ax=(0.2,0.3,0.4))",
                           "(0.1,0.2,0.3)*Lambertian + BRDFLab082BlinnPhong(Exponent=(3,4,5))",
                           "(1,1,1)*BRDFLab082AshikhminShirley(F0=400, Exponent=38)"}) {
    brdf::BrdfLabFile file;
    file.name = "MainBRDF";
    file.type = "Analytic";
    file.analytic = brdf::parseMaterialExpression(text);
    file.fittings.push_back({"Fit-0", file.analytic, 1.25, "levmar", true});
    const std::string xml = brdf::writeBrdfLabXml(file);
    const auto back = brdf::readBrdfLabXml(xml, "test");
    expectSameValues(*back.analytic, *file.analytic, 1e-13);
    ASSERT_EQ(back.fittings.size(), 1u);
    EXPECT_EQ(back.fittings[0].name, "Fit-0");
    EXPECT_EQ(back.fittings[0].error, 1.25);
    EXPECT_EQ(back.fittings[0].optimizer, "levmar");
    EXPECT_TRUE(back.fittings[0].readOnly);
    const bool fixed = xml.find("Fixed") != std::string::npos;
    EXPECT_EQ(fixed, std::string_view(text).find("BlinnPhong") != std::string_view::npos) << xml;
  }
}

TEST(BrdfLabXml, WhatTheDialectCannotSayIsRefused) {
  const fs::path folder = freshFolder("brdflab_refused");
  const auto save = [&](const char* text) {
    const auto loaded = loadMaterial(text);
    return errorOf([&] { brdf::saveMaterial(loaded, folder / "a.xml", "brdflab-xml", "test"); });
  };
  EXPECT_NE(save("0.04*GGX").find("does not know this lobe"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(folder));
  EXPECT_EQ(save("0.3*Lambertian"), "");
  EXPECT_NEAR(loadMaterial((folder / "a.xml").string()).brdf->evaluate({0, 0, 1}, {0, 0, 1})[0], 0.3 / kPi, 1e-15);
}

TEST(BrdfLabFiles, ShippedFilesOpenWithThePublishedNumbers) {
  const fs::path folder = fs::path(BRDF_SHARED_DIR) / "data/brdflab/brdfs";
  if (!fs::exists(folder)) GTEST_SKIP() << "no folder " << folder;
  const struct {
    const char* file;
    std::size_t fits;
  } cases[] = {{"Cornell-Skin-mahesh-Indian.xml", 0},
               {"MERL-orange-paint.xml", 0},
               {"MPI-brdf_blue.xml", 1},
               {"fitting_done.xml", 6}};
  for (const auto& [name, fits] : cases) {
    const std::string text = brdf::readFile(folder / name);
    const auto file = brdf::readBrdfLabXml(text, name);
    if (fits > 0) {
      EXPECT_EQ(file.fittings.size(), fits) << name;
    }
    const auto back = brdf::readBrdfLabXml(brdf::writeBrdfLabXml(file), name);
    ASSERT_EQ(back.fittings.size(), file.fittings.size()) << name;
    for (std::size_t i = 0; i < file.fittings.size(); ++i) {
      expectSameValues(*back.fittings[i].material, *file.fittings[i].material, 1e-13);
      EXPECT_EQ(back.fittings[i].error, file.fittings[i].error);
    }
    if (file.analytic) expectSameValues(*back.analytic, *file.analytic, 1e-13);
  }
  // The Ward fit of fitting_done.xml (its formula as coded there) at the setting above, in its blue channel.
  const auto ward = loadMaterial((folder / "fitting_done.xml").string() + "#Fit-4");
  const Setting s;
  const double ax2 = 0.2440424117584361 * 0.2440424117584361;
  const double expected = 0.009492678176974939 +
                          0.2784705617597376 * std::exp(-s.tan2() / ax2 / (4 * kPi * ax2)) / std::sqrt(s.u[2] * s.v[2]);
  EXPECT_NEAR(ward.brdf->evaluate(s.u, s.v)[2], expected, 1e-13);
}
