// LightTools' BSDF text: small files by hand, values at directions worked out by hand.
#include <brdf/material/GridBrdf.h>

#include "LightingSupport.h"

namespace {

using namespace lightingtest;
using brdf::ComponentKind;

const std::string kHeader =
    "Symmetry Asymmetric\nSpectralContent Monochrome\nScatterAzimuth 4\n0 90 180 270\nScatterRadial 2\n0 "
    "30\nDataBegin\n";
const std::string kBlock = "AOI 40\nPOI 0\nSide Front\nWavelength 550\nScatterType BRDF\nTIS 0.5\n1 5\n1 2\n1 7\n1 3\n";

}  // namespace

TEST(LightTools, TheLightStandsAtAzimuthNinety) {
  const auto result = readHandWritten("sides.lighttools.bsdf");
  EXPECT_EQ(result.report.format, "lighttools");
  EXPECT_TRUE(result.components.front);
  EXPECT_EQ(result.brdf->symmetry(), brdf::Symmetry::Isotropic);
  const double light[2] = {20, 50};
  for (int i = 0; i < 2; ++i)
    for (const double turn : {0.0, 77.0})
      for (int a = 0; a < 3; ++a)
        for (int r = 0; r < 3; ++r) {
          const double expected = (i + 1) + (r ? 0.1 * (2 * a + r) : 0);
          for (const double side : {1.0, -1.0})
            EXPECT_NEAR(valueAt(*result.brdf, polar(light[i], turn), polar(30 * r, turn + side * 90 * a)), expected,
                        1e-12);
        }
  // By hand: the light over +x, azimuth 270 of the file lies opposite.
  EXPECT_NEAR(valueAt(*result.brdf, polar(20, 0), {-0.5, 0, std::sqrt(0.75)}), 1.5, 1e-12);
}

TEST(LightTools, AsymmetricAzimuthsKeepTheirSense) {
  const auto result = readText("a.bsdf", kHeader + kBlock + "DataEnd\n");
  EXPECT_EQ(result.brdf->symmetry(), brdf::Symmetry::Bilateral);
  // The light over +x (file azimuth 90): file azimuth 180 is +y, 0 is -y.
  EXPECT_NEAR(valueAt(*result.brdf, polar(40, 0), {0, 0.5, std::sqrt(0.75)}), 7, 1e-12);
  EXPECT_NEAR(valueAt(*result.brdf, polar(40, 0), {0, -0.5, std::sqrt(0.75)}), 5, 1e-12);
  EXPECT_NEAR(valueAt(*result.brdf, polar(40, 0), {0.5, 0, std::sqrt(0.75)}), 2, 1e-12);
  EXPECT_NEAR(valueAt(*result.brdf, polar(40, 0), polar(30, 225)), 4, 1e-12);  // across the seam: between 3 and 5
}

TEST(LightTools, TheOtherHalfOfTheAzimuthsWillDo) {
  std::string text = brdf::readFile(handWritten("sides.lighttools.bsdf"));
  const auto result = readText("a.bsdf", with(text, "90 180 270", "-90 0 90"));
  // Now the first row is opposite to the light, the last on its side.
  EXPECT_NEAR(valueAt(*result.brdf, polar(20, 0), polar(30, 180)), 1.1, 1e-12);
  EXPECT_NEAR(valueAt(*result.brdf, polar(20, 0), polar(30, 0)), 1.5, 1e-12);
  EXPECT_NEAR(valueAt(*result.brdf, polar(20, 0), polar(60, 90)), 1.4, 1e-12);
}

TEST(LightTools, SidesAndTransmissionAreComponents) {
  const auto result = readHandWritten("sides.lighttools.bsdf");
  ASSERT_EQ(result.components.scatter.size(), 2u);
  const auto through = result.components.find(ComponentKind::FrontTransmission);
  const auto back = result.components.find(ComponentKind::BackReflection);
  ASSERT_TRUE(through && back);
  // The viewer is mirrored through the surface: straight through is where a mirror would send it.
  EXPECT_NEAR(valueAt(*through, polar(20, 0), polar(60, 180)), 3.6, 1e-12);
  // AOI 180: the normal of the back; its only incidence, so that it stands for all.
  EXPECT_NEAR(valueAt(*back, polar(10, 0), polar(60, 180)), 4.6, 1e-12);
  EXPECT_TRUE(mentions(result.report.assumptions, "above 90 degrees: taken for 0"));
  ASSERT_EQ(result.components.totals.size(), 3u);
  EXPECT_EQ(result.components.totals[0].kind, ComponentKind::FrontReflection);
  EXPECT_EQ(result.components.totals[0].values, (std::vector<double>{0.5, 0.6}));
  EXPECT_EQ(result.report.samples, 36u);

  brdf::ReadOptions options;
  options.sides = brdf::Sides::Swapped;
  const auto swapped = readHandWritten("sides.lighttools.bsdf", options);
  EXPECT_NEAR(valueAt(*swapped.brdf, polar(10, 0), polar(60, 180)), 4.6, 1e-12);
  EXPECT_TRUE(swapped.components.find(ComponentKind::BackTransmission));
}

TEST(LightTools, TristimulusBlocksBecomeLinearSrgb) {
  // The blue primary of sRGB, four digits (IEC 61966-2-1).
  std::string text = with(kHeader, "Monochrome", "XYZ");
  const char* names[3] = {"TrisZ", "TrisX", "TrisY"};
  const char* values[3] = {"0.9505", "0.1805", "0.0722"};
  for (int c = 0; c < 3; ++c) {
    text += std::string("AOI 0\nPOI 0\nSide Front\nScatterType BRDF\nTristimulusValue ") + names[c] + "\nTIS 1\n";
    for (int i = 0; i < 8; ++i) text += std::string(values[c]) + " ";
  }
  const auto blue = readText("a.bsdf", text + "DataEnd\n").brdf->evaluate(polar(0, 0), polar(30, 40));
  EXPECT_NEAR(blue[0], 0, 5e-4);
  EXPECT_NEAR(blue[1], 0, 5e-4);
  EXPECT_NEAR(blue[2], 1, 5e-4);
  const std::string error =
      measuredtest::errorOf([&] { readText("a.bsdf", with(text, "TristimulusValue TrisY", "") + "DataEnd\n"); });
  EXPECT_NE(error.find("TristimulusValue"), std::string::npos) << error;
}

TEST(LightTools, DamagedFilesNameTheirLine) {
  const std::string good = kHeader + kBlock + "DataEnd\n";
  expectErrors("a.bsdf",
               {
                   {with(good, "DataEnd", ""), "where DataEnd should be"},
                   {with(good, "1 3\n", "1\n"), "no number where a value"},
                   {with(good, "1 3\n", "1 3 4\n"), "unknown key"},
                   {kHeader + kBlock + kBlock + "DataEnd", "a block stands twice"},
                   {with(good, "POI 0", "POI 45"), "not established"},
                   {with(good, "AOI 40", ""), "AOI"},
                   {with(good, "Side Front", ""), "Side"},
                   {with(good, "Side Front", "Side Top"), "unknown Side"},
                   {with(good, "AOI 40", "AOI 200"), "out of range"},
                   {with(good, "Radial 2", "Radial 3000000000"), "wrong number of ScatterRadial"},
                   {with(good, "Radial 2\n0 30", "Radial 2\n0 95"), "out of range"},
                   {with(good, "Wavelength", "TristimulusValue TrisX Wavelength"), "SpectralContent XYZ"},
                   {kHeader + "DataEnd", "no block"},
                   {good + "x", "after DataEnd"},
                   {with(with(good, "Asymmetric", "PlaneSymmetrical"), "0 90 180 270", "0 90 180 200"), "both sides"},
               });
}
