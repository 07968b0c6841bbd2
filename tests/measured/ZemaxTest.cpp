// Zemax's tabular BSDF: small files by hand, values at directions made by vectors (LightingSupport.h).
#include <brdf/material/GridBrdf.h>

#include "LightingSupport.h"

namespace {

using namespace lightingtest;
using brdf::ComponentKind;

std::string asymmetric(const std::string& rotations = "1\n0") {
  return "Source Measured\nSymmetry ASymmetrical4D\nSpectralContent Monochrome\nScatterType BRDF\nSampleRotation " +
         rotations + "\nAngleOfIncidence 1\n30\nScatterAzimuth 4\n0 90 180 270\nScatterRadial 2\n0 20\n";
}

}  // namespace

TEST(Zemax, ValuesStandAboutTheMirrorDirection) {
  const auto result = readHandWritten("plane.zemax.bsdf");
  EXPECT_EQ(result.report.format, "zemax");
  EXPECT_EQ(result.brdf->channels(), brdf::Channels::monochrome());
  EXPECT_EQ(result.brdf->symmetry(), brdf::Symmetry::Isotropic);
  const double table[2][3][3] = {{{1, .5, .25}, {1, .4, .2}, {1, .3, .1}}, {{2, .9, .6}, {2, .8, .5}, {2, .7, 0}}};
  for (int i = 0; i < 2; ++i)
    for (int a = 0; a < 3; ++a)
      for (int r = 0; r < 3; ++r)
        for (const double turn : {0.0, 123.0})         // isotropic
          for (const double side : {1.0, -1.0}) {      // mirrored
            if (i == 1 && a == 2 && r == 2) continue;  // below the horizon
            const double thetaI = 30 * (i + 1);
            EXPECT_NEAR(valueAt(*result.brdf, polar(thetaI, turn), aboutMirror(thetaI, turn, 20 * r, side * 90 * a)),
                        table[i][a][r], 1e-12)
                << i << a << r;
          }
}

TEST(Zemax, TheMirrorDirectionItselfByHand) {
  const auto result = readHandWritten("plane.zemax.bsdf");
  EXPECT_NEAR(valueAt(*result.brdf, {0.5, 0, std::sqrt(0.75)}, {-0.5, 0, std::sqrt(0.75)}), 1, 1e-12);
  // 20 degrees from there towards the normal: 10 degrees from it.
  EXPECT_NEAR(valueAt(*result.brdf, {0.5, 0, std::sqrt(0.75)}, polar(10, 180)), 0.5, 1e-12);
  EXPECT_NEAR(valueAt(*result.brdf, {0.5, 0, std::sqrt(0.75)}, polar(50, 180)), 0.3, 1e-12);
}

TEST(Zemax, BetweenTheAnglesItIsLinear) {
  const auto result = readHandWritten("plane.zemax.bsdf");
  // The middle of eight values: (1 + 0.5 + 1 + 0.4) / 4 at 30 degrees and (2 + 0.9 + 2 + 0.8) / 4 at 60.
  EXPECT_NEAR(valueAt(*result.brdf, polar(45, 0), aboutMirror(45, 0, 10, 45)), 1.075, 1e-12);
}

TEST(Zemax, ZerosBelowTheHorizonAreNoValues) {
  const auto result = readHandWritten("plane.zemax.bsdf");
  EXPECT_EQ(result.report.samples, 18u);
  EXPECT_EQ(result.report.invalid, 1u);
  EXPECT_EQ(result.report.belowHorizon, 1u);
  // Between 0.7 at 20 degrees and the filler at 40 only 0.7 counts; azimuth 180 leads down.
  EXPECT_NEAR(valueAt(*result.brdf, polar(60, 0), aboutMirror(60, 0, 25, 180)), 0.7, 1e-12);
  // Beyond the last radial angle there is nothing.
  EXPECT_FALSE(isValid(*result.brdf, polar(30, 0), aboutMirror(30, 0, 41, 0)));
}

TEST(Zemax, AzimuthsRunCounterClockwiseSeenAgainstTheBeam) {
  const auto result = readText("a.bsdf", asymmetric() + "Monochrome\nDataBegin\nTIS 1\n1 2\n1 5\n1 3\n1 7\nDataEnd\n");
  EXPECT_EQ(result.brdf->symmetry(), brdf::Symmetry::Bilateral);
  // The light in the xz plane at x > 0: who looks from the tip of the mirror direction (x < 0) back at the surface, the
  // normal up, sees +y on the left, where a counter-clockwise quarter turn from "up" leads.
  const double c = std::cos(radians(20)), s = std::sin(radians(20));
  const Direction light{0.5, 0, std::sqrt(0.75)};
  EXPECT_NEAR(valueAt(*result.brdf, light, {-0.5 * c, s, std::sqrt(0.75) * c}), 5, 1e-12);
  EXPECT_NEAR(valueAt(*result.brdf, light, {-0.5 * c, -s, std::sqrt(0.75) * c}), 7, 1e-12);
  // Across the seam from 270 to 0.
  EXPECT_NEAR(valueAt(*result.brdf, light, aboutMirror(30, 0, 20, 315)), 4.5, 1e-12);
}

TEST(Zemax, RotationsAreSlowest) {
  std::string text = asymmetric("4\n0 90 180 270") + "Monochrome\nDataBegin\n";
  for (int r = 0; r < 4; ++r) {
    text += "TIS 1\n";
    for (int a = 0; a < 4; ++a) text += std::to_string(r + 1) + " " + std::to_string(10 * (r + 1) + a) + "\n";
  }
  const auto result = readText("a.bsdf", text + "DataEnd\n");
  EXPECT_EQ(result.brdf->symmetry(), brdf::Symmetry::Anisotropic);
  EXPECT_TRUE(mentions(result.report.assumptions, "SampleRotation"));
  for (int r = 0; r < 4; ++r)
    for (int a = 0; a < 4; ++a)
      EXPECT_NEAR(valueAt(*result.brdf, polar(30, 90 * r), aboutMirror(30, 90 * r, 20, 90 * a)), 10 * (r + 1) + a,
                  1e-10);
}

TEST(Zemax, MirroredRotationsCoverBothSidesOfEachPlane) {
  const auto result = readText(
      "a.bsdf", with(with(asymmetric("2\n0 90"), "ASymmetrical4D", "PlaneSymmetrical"), "4\n0 90 180 270", "2\n0 180") +
                    "Monochrome\nDataBegin\nTIS 1\n1 2\n1 3\nTIS 1\n4 5\n4 6\nDataEnd\n");
  for (const double side : {1.0, -1.0}) {
    EXPECT_NEAR(valueAt(*result.brdf, polar(30, 0), aboutMirror(30, 0, 20, side * 90)), 2.5, 1e-12);
    EXPECT_NEAR(valueAt(*result.brdf, polar(30, 90), aboutMirror(30, 90, 20, side * 45)), 5.25, 1e-12);
  }
  EXPECT_TRUE(mentions(result.report.warnings, "ASymmetrical4D"));
  EXPECT_TRUE(mentions(result.report.warnings, "phi_i from 0 to 90"));
}

TEST(Zemax, TransmissionIsAComponentAndXyzBecomesLinearSrgb) {
  const auto result = readHandWritten("xyz.zemax.bsdf");
  EXPECT_FALSE(result.components.front);
  ASSERT_EQ(result.components.scatter.size(), 1u);
  EXPECT_EQ(result.components.scatter[0].kind, ComponentKind::FrontTransmission);
  EXPECT_TRUE(mentions(result.report.warnings, "front transmission"));
  const auto& brdf = *result.components.scatter[0].brdf;
  EXPECT_EQ(brdf.channels(), brdf::Channels::rgb());
  // Straight through, the viewer mirrored through the surface: (-wi.x, -wi.y, wi.z). The white of D65 (0.3127, 0.3290).
  const auto white = brdf.evaluate(polar(20, 0), polar(20, 180));
  for (const double value : white) EXPECT_NEAR(value, 0.2, 1e-9);
  // IEC 61966-2-1 gives the primaries' tristimulus values with four digits.
  const auto red = brdf.evaluate(polar(20, 0), aboutMirror(20, 0, 30, 0));
  EXPECT_NEAR(red[0], 1, 5e-4);
  EXPECT_NEAR(red[1], 0, 5e-4);
  EXPECT_NEAR(red[2], 0, 5e-4);
  EXPECT_TRUE(mentions(result.report.assumptions, "colour: xyz (SpectralContent XYZ)"));
  // TIS: of the luminance.
  ASSERT_EQ(result.components.totals.size(), 1u);
  EXPECT_EQ(result.components.totals[0].values, std::vector<double>{0.2});
}

TEST(Zemax, StatedTotalsAreKeptByIncidence) {
  const auto totals = readHandWritten("plane.zemax.bsdf").components.totals;
  ASSERT_EQ(totals.size(), 1u);
  EXPECT_EQ(totals[0].kind, ComponentKind::FrontReflection);
  EXPECT_EQ(totals[0].values, (std::vector<double>{0.25, 0.5}));
  EXPECT_NEAR(totals[0].thetaI[1], radians(60), 1e-15);
}

TEST(Zemax, OptionsOverrideWhatTheFormatSays) {
  brdf::ReadOptions options;
  options.quantity = brdf::Quantity::BrdfCosine;
  options.sides = brdf::Sides::Swapped;
  const auto result = readHandWritten("plane.zemax.bsdf", options);
  ASSERT_EQ(result.components.scatter.size(), 1u);
  EXPECT_EQ(result.components.scatter[0].kind, ComponentKind::BackReflection);
  EXPECT_NEAR(valueAt(*result.brdf, polar(60, 0), polar(60, 180)), 2 / std::cos(radians(60)), 1e-12);
  brdf::ReadOptions colour;
  colour.colour = brdf::ColourSpace::Xyz;
  EXPECT_NE(measuredtest::errorOf([&] { readHandWritten("plane.zemax.bsdf", colour); }).find("no colours"),
            std::string::npos);
  brdf::ReadOptions plain;
  plain.colour = brdf::ColourSpace::LinearSrgb;
  EXPECT_NEAR(readHandWritten("xyz.zemax.bsdf", plain).brdf->evaluate(polar(20, 0), polar(20, 180))[0], 0.19009118541,
              1e-12);
}

TEST(Zemax, DamagedFilesNameTheirLine) {
  const std::string good = brdf::readFile(handWritten("plane.zemax.bsdf"));
  expectErrors("a.bsdf", {
                             {with(good, "DataEnd", ""), "where end of the values should be"},
                             {with(good, "0.7", "0.7 0.7"), "unknown end of the values"},
                             {with(good, "0.8", "o.8"), "no number where a value"},
                             {with(good, "TIS 0.5", ""), "unknown start of an incidence"},
                             {with(good, "TIS 0.5", "TIS"), "no number where a value"},
                             {with(good, "Radial\t3", "Radial\t4"), "no number where ScatterRadial"},
                             {with(good, "Radial\t3", "Radial\t2"), "unknown key"},
                             {with(good, "Radial\t3", "Radial\t1000000000000"), "wrong number of ScatterRadial"},
                             {with(good, "Radial\t3", "Radial\t-3"), "wrong number of ScatterRadial"},
                             {with(good, "30\t60", "60\t30"), "not ascending"},
                             {with(good, "30\t60", "30\t91"), "out of range"},
                             {with(good, "0\t90\t180", "0\t90\t190"), "both sides"},
                             {with(good, "BRDF", "BSSRDF"), "unknown ScatterType"},
                             {with(good, "Symmetry\tPlaneSymmetrical", ""), "Symmetry"},
                             {good.substr(0, good.find("Monochrome\nDataBegin")), "too short"},
                             {good.substr(0, good.find("TIS 0.5")), "where start of an incidence should be"},
                             {good + "more", "after the last channel"},
                         });
}
