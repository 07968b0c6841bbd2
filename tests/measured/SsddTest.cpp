// SSDD: small files by hand, values and directions worked out by hand.
#include <brdf/material/GridBrdf.h>

#include <cstdint>

#include "LightingSupport.h"

namespace {

using namespace lightingtest;
using brdf::ComponentKind;

/// The pair whose half vector is at (thetaH, 0) and whose light is at (thetaD, phiD) about it, by vectors: about h the
/// first axis is +x turned along with the normal into h, the second +y.
brdf::DirectionPair aboutHalf(double thetaH, double thetaD, double phiD) {
  const Direction h = polar(thetaH, 0), first = polar(thetaH + 90, 0), second{0, 1, 0};
  Direction wi, wo;
  for (std::size_t x = 0; x < 3; ++x)
    wi[x] = std::cos(radians(thetaD)) * h[x] +
            std::sin(radians(thetaD)) * (std::cos(radians(phiD)) * first[x] + std::sin(radians(phiD)) * second[x]);
  for (std::size_t x = 0; x < 3; ++x) wo[x] = 2 * brdf::dot(wi, h) * h[x] - wi[x];
  return {wi, wo};
}

const std::string kSpherical =
    "VERSION 0.3\nDATA_TYPE brdf\nCOLOR_MODEL monochrome\nPARAM_TYPE spherical_coordinate_system\n"
    "PARAM0_LIST 10 50\nPARAM1_LIST 0 90 180 270\nPARAM2_LIST 20 40 60\nPARAM3_LIST 0 90 180 270\nDATA ascii\n";

}  // namespace

TEST(Ssdd, HalfDifferenceIsReciprocalAndMirrored) {
  const auto result = readHandWritten("four.ssdd");
  EXPECT_EQ(result.report.format, "ssdd");
  EXPECT_TRUE(result.components.front);
  EXPECT_TRUE(result.brdf->reciprocal());
  EXPECT_EQ(result.brdf->symmetry(), brdf::Symmetry::Isotropic);
  EXPECT_EQ(result.brdf->channels(), brdf::Channels::rgb());
  for (int p = 0; p < 2; ++p)
    for (int d = 0; d < 3; ++d)
      for (int h = 0; h < 2; ++h) {
        if (d == 0 && p == 1) continue;  // the azimuth of no angle is 0
        for (const double turned : {90.0 * p, -90.0 * p, 180 - 90.0 * p, 180 + 90.0 * p}) {
          const auto [wi, wo] = aboutHalf(30 * h, 20 * d, turned);
          // On the normal the half vector has no azimuth, and the light's sets none apart.
          if (h == 0) continue;
          const double expected = 1 + h + 2 * d + 6 * p;  // PARAM0 fastest
          EXPECT_NEAR(valueAt(*result.brdf, wi, wo, 0), expected, 1e-9) << p << d << h << turned;
          EXPECT_NEAR(valueAt(*result.brdf, wi, wo, 2), 100 * expected, 1e-7);
        }
      }
  EXPECT_EQ(result.report.metadata.at("brdf NAME"), "paint #7, left panel");
  EXPECT_EQ(result.report.metadata.at("SOFTWARE"), "by hand");
  EXPECT_TRUE(mentions(result.report.assumptions, "leaves its primaries open"));
}

TEST(Ssdd, TransmissionAndSpecularBlocksAreComponents) {
  const auto result = readHandWritten("four.ssdd");
  const auto through = result.components.find(ComponentKind::FrontTransmission);
  ASSERT_TRUE(through);
  EXPECT_EQ(through->symmetry(), brdf::Symmetry::Bilateral);
  // At 45 degrees of incidence the beam leaves at 35.
  EXPECT_NEAR(valueAt(*through, polar(45, 0), polar(35, 180)), 2, 1e-12);
  for (int a = 0; a < 4; ++a) {
    EXPECT_NEAR(valueAt(*through, polar(0, 0), aboutMirror(0, 0, 10, 90 * a)), 3 + 2 * a, 1e-12);
    EXPECT_NEAR(valueAt(*through, polar(45, 30), aboutMirror(45, 30, 10, 90 * a, -10)), 4 + 2 * a, 1e-12);
  }
  ASSERT_EQ(result.components.specular.size(), 2u);
  EXPECT_EQ(result.components.specular[0].kind, ComponentKind::FrontReflection);
  EXPECT_EQ(result.components.specular[0].channels, brdf::Channels::spectral({450, 550, 650}));
  EXPECT_NEAR(result.components.specular[0].at(2, radians(80)), 0.6, 1e-12);
  EXPECT_NEAR(result.components.specular[0].at(1, radians(40)), 0.275, 1e-12);
  EXPECT_EQ(result.components.specular[1].kind, ComponentKind::FrontTransmission);
  EXPECT_NEAR(result.components.specular[1].at(0, 0), 0.9, 1e-12);
}

TEST(Ssdd, AnisotropicAzimuthsAreThoseOfTheSurface) {
  std::string text = kSpherical;
  for (int p3 = 0; p3 < 4; ++p3)
    for (int p2 = 0; p2 < 3; ++p2)
      for (int p1 = 0; p1 < 4; ++p1)
        for (int p0 = 0; p0 < 2; ++p0) text += std::to_string(1000 * p3 + 100 * p2 + 10 * p1 + p0) + "\n";
  const auto result = readText("a.ssdd", text);
  EXPECT_EQ(result.brdf->symmetry(), brdf::Symmetry::Anisotropic);
  for (int p3 = 0; p3 < 4; ++p3)
    for (int p2 = 0; p2 < 3; ++p2)
      for (int p1 = 0; p1 < 4; ++p1)
        for (int p0 = 0; p0 < 2; ++p0)
          EXPECT_NEAR(valueAt(*result.brdf, polar(10 + 40 * p0, 90 * p1), polar(20 + 20 * p2, 90 * p3)),
                      1000 * p3 + 100 * p2 + 10 * p1 + p0, 1e-8);
}

TEST(Ssdd, WithoutParameterOneItIsIsotropic) {
  const auto result = readText("a.ssdd",
                               "VERSION 0.3\nDATA_TYPE brdf\nCOLOR_MODEL monochrome\n"
                               "PARAM_TYPE spherical_coordinate_system\nREDUCTION_TYPE bilateral_symmetry\n"
                               "PARAM0_LIST 30\nPARAM2_LIST 40\nPARAM3_LIST 0 90 180\nDATA ascii\n1\n2\n4\n");
  for (const double turn : {0.0, 200.0})
    for (const double side : {1.0, -1.0})
      EXPECT_NEAR(valueAt(*result.brdf, polar(30, turn), polar(40, turn + side * 135)), 3, 1e-12);
}

TEST(Ssdd, MirroredAnisotropicDataCoverBothSidesOfEachPlane) {
  const auto result =
      readText("a.ssdd",
               "VERSION 0.3\nDATA_TYPE brdf\nCOLOR_MODEL monochrome\n"
               "PARAM_TYPE specular_coordinate_system\nREDUCTION_TYPE bilateral_symmetry\n"
               "PARAM0_LIST 30\nPARAM1_LIST 0 120 240\nPARAM2_LIST 20\nPARAM3_LIST 0 90 180\nDATA ascii\n"
               "1\n2\n3\n4\n5\n6\n7\n8\n9\n");
  for (int p = 0; p < 3; ++p)
    for (int a = 0; a < 3; ++a)
      for (const double side : {1.0, -1.0})
        EXPECT_NEAR(valueAt(*result.brdf, polar(30, 120 * p), aboutMirror(30, 120 * p, 20, side * 90 * a)),
                    1 + p + 3 * a, 1e-10);
}

TEST(Ssdd, BinaryValuesAreLittleEndianFloats) {
  std::string text =
      "VERSION 0.3\r\nDATA_TYPE brdf\r\nCOLOR_MODEL xyz\r\nPARAM_TYPE spherical_coordinate_system\r\n"
      "PARAM0_LIST 0\r\nPARAM2_LIST 0 60\r\nPARAM3_LIST 0\r\nDATA binary\r\n";
  const std::string head = text;
  // 0.25 is 0x3e800000, 0.5 is 0x3f000000, 10 is 0x41200000; line ends and comment signs may occur among the bytes.
  const auto add = [&](std::uint32_t bits) {
    for (int shift = 0; shift < 32; shift += 8) text += static_cast<char>(bits >> shift & 255);
  };
  for (const std::uint32_t bits : {0x3e800000u, 0x3f000000u, 0x41200000u, 0x0a0d230au, 0x3f000000u, 0x3e800000u})
    add(bits);
  text += "\nDATA_TYPE specular_transmittance\nCOLOR_MODEL monochrome\nPARAM0_LIST 0\nDATA binary\n";
  add(0x3f000000u);
  brdf::ReadOptions plain;
  plain.colour = brdf::ColourSpace::LinearSrgb;
  const auto result = readText("a.ssdd", text, plain);
  EXPECT_EQ(valueAt(*result.brdf, polar(0, 0), polar(0, 0), 0), 0.25);
  EXPECT_EQ(valueAt(*result.brdf, polar(0, 0), polar(0, 0), 2), 10);
  EXPECT_NEAR(valueAt(*result.brdf, polar(0, 0), polar(60, 0), 1), 0.5, 1e-15);
  EXPECT_EQ(result.components.specular[0].values, std::vector<double>{0.5});
  EXPECT_TRUE(mentions(result.report.assumptions, "colour: linear_srgb (given; COLOR_MODEL xyz: xyz)"));
  expectErrors("a.ssdd", {{text.substr(0, text.size() - 1), "too short"}, {head + "1234", "too short"}});
}

TEST(Ssdd, WhatIsNotDefinedIsRefused) {
  expectErrors("a.ssdd",
               {{with(kSpherical, "spherical_coordinate", "distorted_spherical_coordinate"), "does not define it"},
                {with(kSpherical, "PARAM0", "REDUCTION_TYPE bilateral_symmetry\nPARAM0"), "not established"},
                {with(kSpherical, "PARAM0", "REDUCTION_TYPE reciprocity\nPARAM0"), "half_difference"},
                {with(kSpherical, "DATA ascii", "PARAM4_LIST 1 2\nDATA ascii"), "PARAM4_LIST"},
                {with(kSpherical, "0 90 180 270", "30"), "one PARAM1 that is not 0"}});
}

TEST(Ssdd, DamagedFilesNameTheirLine) {
  const std::string good = brdf::readFile(handWritten("four.ssdd"));
  expectErrors("a.ssdd", {
                             {with(good, "6 60 600\n", ""), "wrong number of values in a line"},
                             {with(good, "6 60 600", "6 60"), "wrong number of values in a line"},
                             {with(good, "6 60 600", "6 60 x"), "no number"},
                             {good.substr(0, good.size() - 5), "within the values"},
                             {with(good, "PARAM3_LIST 0 90\n", ""), "PARAM3_LIST"},
                             {with(good, "PARAM3_LIST 0 90\n", "PARAM3_LIST 90 0\n"), "not ascending"},
                             {with(good, "PARAM3_LIST 0 90\n", "PARAM3_LIST 0 100\n"), "out of range"},
                             {with(good, "PARAM2_LIST 0 20 40\n", "PARAM2_LIST\n"), "an empty list"},
                             {with(good, "COLOR_MODEL rgb", "COLOR_MODEL cmyk"), "unknown COLOR_MODEL"},
                             {with(good, "COLOR_MODEL rgb", ""), "COLOR_MODEL"},
                             {with(good, "DATA_TYPE btdf", "DATA_TYPE brdf"), "stands twice"},
                             {with(good, "DATA ascii\n", ""), "a block without DATA"},
                             {with(good, "WAVELENGTH_LIST 450 550 650", ""), "WAVELENGTH_LIST"},
                             {with(good, "PARAM4_LIST 0 -10", "PARAM4_LIST 0"), "does not match"},
                             {"VERSION 0.3\n", "no block"},
                         });
  std::string wide = kSpherical;  // four short lists, 10^12 cells
  for (const char* list : {"10 50", "0 90 180 270", "20 40 60", "0 90 180 270"}) {
    std::string many;
    for (int i = 0; i < 1000; ++i) many += " " + std::to_string(i * 0.09);
    wide = with(wide, std::string("_LIST ") + list, "_LIST" + many);
  }
  expectErrors("a.ssdd", {{wide + "1\n2\n", "too short for the values"}});
}
