#include <brdf/base/Error.h>
#include <brdf/color/CieTables.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/color/Illuminant.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using brdf::Observer;

/// Chromaticity of the sums over an illuminant's own wavelengths, not through whitePoint().
std::array<double, 2> chromaticity(const brdf::Illuminant& light, Observer observer) {
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < light.wavelengths.size(); ++i) {
    const auto matching = brdf::colourMatching(observer, light.wavelengths[i]);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += light.power[i] * matching[k];
  }
  const double total = sum[0] + sum[1] + sum[2];
  return {sum[0] / total, sum[1] / total};
}

struct Published {
  const char* name;
  double x2, y2, tolerance2, x10, y10, tolerance10;
};

/// CIE 15:2004. Daylights and A: table T.3, to its five digits; D65 under the 10-degree observer differs in the last
/// two from the sum every 5 nm over 380 to 780 nm. F: table T.8 for 2 degrees, which has four digits; for 10 degrees
/// from the tristimulus values of ASTM E308-01, X = 103.280, 95.792, 103.866 and Z = 69.026, 107.687, 65.627.
constexpr Published kPublished[] = {
    {"A", 0.44758, 0.40745, 1e-5, 0.45117, 0.40594, 1e-5},   {"D50", 0.34567, 0.35851, 1e-5, 0.34773, 0.35952, 1e-5},
    {"D55", 0.33243, 0.34744, 1e-5, 0.33412, 0.34877, 1e-5}, {"D65", 0.31272, 0.32903, 1e-5, 0.31382, 0.33100, 3e-5},
    {"D75", 0.29903, 0.31488, 1e-5, 0.29968, 0.31740, 1e-5}, {"F2", 0.3721, 0.3751, 5.1e-5, 0.37928, 0.36723, 1e-5},
    {"F7", 0.3129, 0.3292, 5.1e-5, 0.31565, 0.32951, 1e-5},  {"F11", 0.3805, 0.3769, 5.1e-5, 0.38541, 0.37107, 1e-4}};

std::string errorOf(const char* text) {
  try {
    brdf::parseIlluminant(text, "lamp.csv");
  } catch (const brdf::Error& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST(Illuminant, ChromaticitiesAreThePublishedOnesUnderBothObservers) {
  for (const Published& p : kPublished) {
    const auto light = brdf::illuminantNamed(p.name);
    EXPECT_EQ(light.name, p.name);
    const auto two = chromaticity(light, Observer::Cie1931), ten = chromaticity(light, Observer::Cie1964);
    EXPECT_NEAR(two[0], p.x2, p.tolerance2) << p.name;
    EXPECT_NEAR(two[1], p.y2, p.tolerance2) << p.name;
    EXPECT_NEAR(ten[0], p.x10, p.tolerance10) << p.name;
    EXPECT_NEAR(ten[1], p.y10, p.tolerance10) << p.name;
  }
}

TEST(Illuminant, EqualEnergyIsAThirdEachUnderBothObservers) {
  for (const Observer observer : {Observer::Cie1931, Observer::Cie1964})
    for (const double share : chromaticity(brdf::illuminantNamed("E"), observer)) EXPECT_NEAR(share, 1.0 / 3, 5e-5);
}

TEST(Illuminant, TheTenDegreeTableHasTheSumsThatCieGives) {
  // CIE 15:2004 table T.5, every 5 nm: 23.329 353, 23.332 036, 23.334 153 over 360 to 830 nm.
  double x = 0, y = 0, z = 0;
  for (const auto& line : brdf::cie1964Table()) x += line.xBar, y += line.yBar, z += line.zBar;
  EXPECT_EQ(brdf::cie1964Table().size(), 81u);
  EXPECT_NEAR(x, 23.329353, 2e-5);
  EXPECT_NEAR(y, 23.332036, 2e-5);
  EXPECT_NEAR(z, 23.334153, 2e-5);
}

TEST(Illuminant, TheTenDegreeTableAgreesWithTheAnalyticApproximation) {
  // Wyman, Sloan and Shirley 2013, JCGT 2(2), "Simple Analytic Approximations to the CIE XYZ Color Matching Functions",
  // equation 3, single-lobe fit of the 1964 observer; they give errors of a few percent of the peaks.
  for (const auto& line : brdf::cie1964Table()) {
    const double w = line.wavelength;
    const auto logGauss = [](double t, double factor) { return std::exp(-factor * t * t); };
    const double x =
        0.398 * logGauss(std::log((w + 570.1) / 1014), 1250) + 1.132 * logGauss(std::log((1338 - w) / 743.5), 234);
    const double y = 1.011 * std::exp(-0.5 * std::pow((w - 556.1) / 46.14, 2));
    const double z = w > 265.8 ? 2.060 * logGauss(std::log((w - 265.8) / 180.4), 32) : 0;
    EXPECT_NEAR(line.xBar, x, 0.06) << w;
    EXPECT_NEAR(line.yBar, y, 0.04) << w;
    EXPECT_NEAR(line.zBar, z, 0.08) << w;
  }
}

TEST(Illuminant, DaylightsAreTheTabulatedOnes) {
  // CIE 15:2004 table T.1, to its three decimals.
  const struct {
    const char* name;
    double at380, at455, at600, at780;
  } published[] = {{"D50", 24.488, 88.930, 97.688, 78.274},
                   {"D55", 32.584, 99.228, 94.419, 71.818},
                   {"D75", 66.703, 132.682, 87.227, 58.324}};
  for (const auto& p : published) {
    const auto light = brdf::illuminantNamed(p.name);
    EXPECT_NEAR(light.at(380), p.at380, 6e-4) << p.name;
    EXPECT_NEAR(light.at(455), p.at455, 6e-4) << p.name;
    EXPECT_NEAR(light.at(600), p.at600, 6e-4) << p.name;
    EXPECT_NEAR(light.at(780), p.at780, 6e-4) << p.name;
    EXPECT_EQ(light.at(560), 100) << p.name;
  }
}

TEST(Illuminant, TheStandardsD65IsDaylightOfItsTemperature) {
  const auto formula = brdf::daylight(6500 * 1.4388 / 1.4380);
  for (const auto& line : brdf::cieTable()) EXPECT_NEAR(formula.at(line.wavelength), line.d65, 1e-3) << line.wavelength;
}

TEST(Illuminant, DaylightLocusHasItsTwoBranchesAndBounds) {
  // The branches of the chromaticity formula meet at 7000 K.
  const auto below = brdf::daylight(7000), above = brdf::daylight(7000.01);
  for (std::size_t i = 0; i < below.power.size(); ++i) EXPECT_NEAR(below.power[i], above.power[i], 0.2);
  EXPECT_THROW(brdf::daylight(3999), brdf::Error);
  EXPECT_THROW(brdf::daylight(25001), brdf::Error);
  EXPECT_THROW(brdf::daylight(std::nan("")), brdf::Error);
}

TEST(Illuminant, IncandescentLightIsTheTabulatedOne) {
  // CIE 15:2004 table T.1.
  const auto a = brdf::illuminantNamed("A");
  for (const auto& [w, power] :
       {std::pair{380.0, 9.7951}, {450, 33.0859}, {555, 96.4423}, {560, 100.0}, {700, 198.261}, {780, 241.675}})
    EXPECT_NEAR(a.at(w), power, 6e-4) << w;
}

TEST(Illuminant, UnknownNamesAreErrors) {
  EXPECT_THROW(brdf::illuminantNamed("D60"), brdf::Error);
  EXPECT_THROW(brdf::colourSettings({"lamp", "2", "bradford"}), brdf::Error);
  EXPECT_THROW(brdf::colourSettings({"A", "5", "bradford"}), brdf::Error);
  EXPECT_THROW(brdf::colourSettings({"A", "2", "cat02"}), brdf::Error);
  EXPECT_EQ(brdf::describe(brdf::colourSettings({})), "D65");
  EXPECT_EQ(brdf::describe(brdf::colourSettings({"A", "10", "none"})), "A, 10-degree observer, not adapted");
}

TEST(Illuminant, AUsersSpectrumIsReadWhateverItsPunctuation) {
  const auto light =
      brdf::parseIlluminant("\xef\xbb\xbf# a lamp\r\n300 9\r\n 400,1\r\n500 ; 3 # here\r\n\r\n800\t6", "lamp.csv");
  EXPECT_EQ(light.wavelengths.front(), 380);
  EXPECT_EQ(light.wavelengths.back(), 780);
  for (std::size_t i = 1; i < light.wavelengths.size(); ++i)
    EXPECT_LE(light.wavelengths[i] - light.wavelengths[i - 1], 5 + 1e-9);
  EXPECT_NEAR(light.at(380), 2.6, 1e-12);
  EXPECT_NEAR(light.at(450), 2, 1e-12);
  EXPECT_NEAR(light.at(650), 4.5, 1e-12);
  EXPECT_EQ(light.at(790), 0);
}

TEST(Illuminant, AUsersCopyOfD65HasItsColour) {
  std::string text;
  for (const auto& line : brdf::cieTable())
    text += std::to_string(line.wavelength) + " " + std::to_string(line.d65) + "\n";
  const auto xy = chromaticity(brdf::parseIlluminant(text, "lamp.csv"), Observer::Cie1931);
  EXPECT_NEAR(xy[0], 0.31272, 1e-5);
  EXPECT_NEAR(xy[1], 0.32903, 1e-5);
}

TEST(Illuminant, BadSpectraAreErrorsWithTheirLine) {
  EXPECT_NE(errorOf("400 1\n500 x\n").find("line 2"), std::string::npos);
  EXPECT_NE(errorOf("400 1\n400 2\n").find("line 2"), std::string::npos);
  EXPECT_NE(errorOf("400 1 2\n500 1\n").find("line 1"), std::string::npos);
  EXPECT_NE(errorOf("400 -1\n500 1\n").find("line 1"), std::string::npos);
  EXPECT_NE(errorOf("400 inf\n500 1\n").find("line 1"), std::string::npos);
  EXPECT_NE(errorOf("400\n500 1\n").find("line 1"), std::string::npos);
  EXPECT_NE(errorOf("550 1\n").find("at least 2"), std::string::npos);
  EXPECT_NE(errorOf("").find("at least 2"), std::string::npos);
  EXPECT_NE(errorOf("900 1\n1000 1\n").find("visible"), std::string::npos);
  EXPECT_NE(errorOf("400 0\n700 0\n800 5\n").find("none"), std::string::npos);  // 700 to 780 rises from 0
  EXPECT_NE(errorOf("400 0\n700 0\n").find("visible"), std::string::npos);
  EXPECT_THROW(brdf::readIlluminant("/nowhere/lamp.csv"), brdf::Error);
}
