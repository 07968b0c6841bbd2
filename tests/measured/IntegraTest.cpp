// Integra's .ddr, .ddt and .sdr: small files by hand, values and directions worked out by hand.
#include <brdf/material/GridBrdf.h>

#include "LightingSupport.h"

namespace {

using namespace lightingtest;
using brdf::ComponentKind;
using brdf::kPi;

/// One incidence at the normal, theta 0 and 90 degrees, the same all around.
std::string normalIncidence(const std::string& data, const std::string& kbdf, const std::string& values) {
  return "TypeSym AxiSymmetrical TypeColorModel BW TypeData " + data + " sigma 1 0 phi 1 0 theta 2 0 90 bw kbdf " +
         kbdf + " def " + values;
}

}  // namespace

TEST(Integra, ValuesAreTimesKbdfOverPi) {
  const auto result = readHandWritten("plane.ddr");
  EXPECT_EQ(result.report.format, "integra");
  EXPECT_EQ(result.brdf->channels(), brdf::Channels::rgb());
  EXPECT_TRUE(result.components.front);
  const double sigma[2] = {10, 50}, table[2][3] = {{2, 3, 4}, {6, 7, 8}}, at0[2] = {1, 5};
  const double kbdf[3][2] = {{0.5, 0.25}, {2, 4}, {1, 1}};  // blue has none
  for (int s = 0; s < 2; ++s)
    for (int a = 0; a < 3; ++a)
      for (const double side : {1.0, -1.0})
        for (std::size_t c = 0; c < 3; ++c) {
          const auto light = polar(sigma[s], 200);
          EXPECT_NEAR(valueAt(*result.brdf, light, aboutMirror(sigma[s], 200, 15, side * 90 * a), c),
                      table[s][a] * kbdf[c][s] / kPi, 1e-12);
          EXPECT_NEAR(valueAt(*result.brdf, light, polar(sigma[s], 20), c), at0[s] * kbdf[c][s] / kPi, 1e-12);
        }
  // By hand: light at 10 degrees, viewer 15 degrees from the mirror direction past the normal, on the light's side.
  EXPECT_NEAR(valueAt(*result.brdf, polar(10, 0), polar(5, 0), 0), 2 * 0.5 / kPi, 1e-12);
  EXPECT_TRUE(mentions(result.report.assumptions, "quantity: reflectance_factor (Luminance: pi f_r with kbdf)"));
  EXPECT_TRUE(mentions(result.report.assumptions, "the file's name; nothing in the content tells"));
}

TEST(Integra, ABentBeamIsTheReferenceOfTransmittedLight) {
  const auto result = readHandWritten("bent.ddt");
  ASSERT_EQ(result.components.scatter.size(), 1u);
  EXPECT_EQ(result.components.scatter[0].kind, ComponentKind::FrontTransmission);
  EXPECT_FALSE(result.components.front);
  const auto& brdf = *result.components.scatter[0].brdf;
  for (int a = 0; a < 4; ++a) {
    const auto viewer = aboutMirror(40, 10, 20, 90 * a, -15);
    EXPECT_NEAR(valueAt(brdf, polar(40, 10), viewer), 0.5 * (7 + a) / viewer[2], 1e-12);  // Intensity: f_r cos
    const auto atNormal = aboutMirror(0, 0, 20, 90 * a);
    EXPECT_NEAR(valueAt(brdf, polar(0, 0), atNormal), (2 + a) / std::cos(radians(20)), 1e-12);
  }
  EXPECT_NEAR(valueAt(brdf, polar(40, 0), polar(25, 180)), 0.5 * 6 / std::cos(radians(25)), 1e-12);
  EXPECT_TRUE(mentions(result.report.assumptions, "quantity: brdf_cos"));
}

TEST(Integra, SigmaTMayHaveItsNumberBeforeIt) {
  const std::string text = brdf::readFile(handWritten("bent.ddt"));
  const auto counted = readText("a.ddt", with(text, "sigmaT\n", "sigmaT 2\n"));
  const auto plain = readText("b.ddt", text);
  EXPECT_EQ(dynamic_cast<const brdf::GridBrdf&>(*counted.brdf).layout(),
            dynamic_cast<const brdf::GridBrdf&>(*plain.brdf).layout());
}

TEST(Integra, PsiIsSlowestAndThetaFastest) {
  std::string text =
      "TypeSym ASymmetrical 4D\nTypeColorModel BW\nTypeData Luminance Absolute\npsi 4\n0 90 180 270\nsigma 2\n20 40\n"
      "phi 4\n0 90 180 270\ntheta 2\n0 10\nbw\nkbdf 1 2 3 4 5 6 7 8\ndef\n";
  for (int p = 0; p < 4; ++p)
    for (int s = 0; s < 2; ++s)
      for (int a = 0; a < 4; ++a)
        for (int t = 0; t < 2; ++t) text += std::to_string(t == 0 ? 1 : 1000 * p + 100 * s + 10 * a + 2) + " ";
  const auto result = readText("a.ddr", text);
  EXPECT_EQ(result.brdf->symmetry(), brdf::Symmetry::Anisotropic);
  for (int p = 0; p < 4; ++p)
    for (int s = 0; s < 2; ++s)
      for (int a = 0; a < 4; ++a) {
        const double thetaI = 20 * (s + 1), kbdf = 1 + s + 2 * p;  // sigma fastest
        EXPECT_NEAR(valueAt(*result.brdf, polar(thetaI, 90 * p), aboutMirror(thetaI, 90 * p, 10, 90 * a)),
                    (1000 * p + 100 * s + 10 * a + 2) * kbdf / kPi, 1e-8);
      }
}

TEST(Integra, RelativeValuesAreScaledToTheirReflectance) {
  // All the same: Lambertian, whatever the number; kbdf is the albedo.
  const auto lambert = readText("a.ddr", normalIncidence("Luminance Relative", "0.5", "17 17"));
  EXPECT_NEAR(valueAt(*lambert.brdf, polar(0, 0), polar(30, 9)), 0.5 / kPi, 1e-6);
  // Falling linearly from 2 to 1 over theta: the integral of (2 - 2 theta / pi) / pi cos(theta) over the hemisphere is
  // 2 [1 - (2 / pi) (pi / 8)] = 3/2, so that kbdf 0.3 scales by 1/5.
  const auto falling = readText("a.ddr", normalIncidence("Luminance Relative", "0.3", "2 1"));
  EXPECT_NEAR(valueAt(*falling.brdf, polar(0, 0), polar(0, 0)), 0.4 / kPi, 1e-6);
  EXPECT_NEAR(valueAt(*falling.brdf, polar(0, 0), polar(45, 0)), 0.3 / kPi, 1e-6);
  EXPECT_TRUE(mentions(falling.report.assumptions, "Relative"));
  // The same where only one side of each plane of incidence is listed.
  const auto half =
      readText("a.ddr",
               "TypeSym PlaneSymmetrical TypeColorModel BW TypeData Luminance Relative psi 2 0 90 sigma 1 0 "
               "phi 2 0 180 theta 2 0 90 bw kbdf 0.3 0.6 def 2 1 2 1 2 1 2 1");
  EXPECT_NEAR(valueAt(*half.brdf, polar(0.001, 0), polar(45, 200)), 0.3 / kPi, 1e-4);
  EXPECT_NEAR(valueAt(*half.brdf, polar(0.001, 90), polar(45, 200)), 0.6 / kPi, 1e-4);
  // Constant intensity f_r cos = c up to 45 degrees, nothing beyond: its integral is 2 pi c (1 - cos 45).
  const auto even = readText("a.ddr", with(normalIncidence("Intensity Relative", "0.3", "4 4 4 4 4 4 4 4 4 4"),
                                           "theta 2 0 90", "theta 10 0 5 10 15 20 25 30 35 40 45"));
  const double intensity = 0.3 / (2 * kPi * (1 - std::cos(radians(45))));
  EXPECT_NEAR(valueAt(*even.brdf, polar(0, 0), polar(0, 0)), intensity, 2e-3 * intensity);
  EXPECT_NEAR(valueAt(*even.brdf, polar(0, 0), polar(40, 0)), intensity / std::cos(radians(40)), 4e-3 * intensity);
}

TEST(Integra, SpecularFractionsAreAComponent) {
  const auto result = readHandWritten("glass.sdr");
  EXPECT_EQ(result.report.format, "integra");
  ASSERT_EQ(result.components.specular.size(), 1u);
  const auto& specular = result.components.specular[0];
  EXPECT_EQ(specular.kind, ComponentKind::FrontReflection);
  EXPECT_EQ(specular.channels, brdf::Channels::spectral({450, 650}));
  EXPECT_NEAR(specular.at(0, radians(60)), 0.12, 1e-15);
  EXPECT_NEAR(specular.at(1, radians(30)), 0.07, 1e-12);
  EXPECT_FALSE(isValid(*result.brdf, polar(10, 0), polar(10, 180)));
  EXPECT_TRUE(mentions(result.report.warnings, "valid nowhere"));
  const auto through = readText("a.sdt", brdf::readFile(handWritten("glass.sdr")));
  EXPECT_EQ(through.components.specular[0].kind, ComponentKind::FrontTransmission);
  brdf::ReadOptions options;
  options.quantity = brdf::Quantity::Brdf;
  EXPECT_NE(measuredtest::errorOf([&] { readHandWritten("glass.sdr", options); }).find("specular fractions only"),
            std::string::npos);
}

TEST(Integra, WhatIsNotEstablishedIsRefused) {
  const std::string good = brdf::readFile(handWritten("plane.ddr"));
  expectErrors("a.ddr", {
                            {with(good, "PlaneSymmetrical", "DirSymmetrical"), "not established"},
                            {with(with(good, "Absolute", "Relative"), "kbdf", ""), "no number"},
                            {with(good, "TypeSym PlaneSymmetrical", ""), "TypeSym"},
                            {with(good, "TypeSym PlaneSymmetrical", "TypeSym RoundSymmetrical"), "unknown TypeSym"},
                            {"TypeSym AxiSymmetrical TypeColorModel bw TypeData Luminance Relative\nsigma 1 0 phi 1 0 "
                             "theta 2 0 90 bw 1 1",
                             "Relative values without kbdf"},
                        });
}

TEST(Integra, DamagedFilesNameTheirLine) {
  const std::string good = brdf::readFile(handWritten("plane.ddr"));
  expectErrors("a.ddr", {
                            {good.substr(0, good.find("blue")), "where channel should be"},
                            {good.substr(0, good.find("green") + 6), "where a value should be"},
                            {good.substr(0, good.find("\nred\n") + 5), "too short"},
                            {with(good, "1 3\n", "1\n"), "no number where a value"},
                            {with(good, "1 3\n", "1 3 3\n"), "unknown channel"},
                            {with(good, "green", "red"), "stands twice"},
                            {with(good, "sigma 2", "sigma 3"), "no number where sigma"},
                            {with(good, "sigma 2", "sigma 99999999999999"), "wrong number of sigma"},
                            {with(good, "sigma 2", "sigma 1.5"), "wrong number of sigma"},
                            {with(good, " 10 50", " 50 10"), "not ascending"},
                            {with(good, " 10 50", " 10 95"), "out of range"},
                            {with(good, "0 90 180", "0 90 270"), "both sides"},
                            {with(good, "TypeColorModel RGB", "TypeColorModel spectral 100000000"), "wrong number"},
                            {with(good, "theta 2\n 0 15", ""), "theta"},
                            {good + " 5", "after the last channel"},
                        });
}
