#include <brdf/base/Error.h>
#include <brdf/color/CieTables.h>
#include <brdf/color/Colorimetry.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

/// A Gaussian of Wyman, Sloan and Shirley 2013 with its own width on either side.
double lobe(double x, double mean, double left, double right) {
  const double t = (x - mean) / (x < mean ? left : right);
  return std::exp(-0.5 * t * t);
}

/// "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2(2) 2013, multi-lobe fit (equation
/// 4, table 1, the 1931 observer).
brdf::CieSample wyman(double w) {
  return {w,
          1.056 * lobe(w, 599.8, 37.9, 31.0) + 0.362 * lobe(w, 442.0, 16.0, 26.7) - 0.065 * lobe(w, 501.1, 20.4, 26.2),
          0.821 * lobe(w, 568.8, 46.9, 40.5) + 0.286 * lobe(w, 530.9, 16.3, 31.1),
          1.217 * lobe(w, 437.0, 11.8, 36.0) + 0.681 * lobe(w, 459.0, 26.0, 13.8), 0};
}

std::vector<double> range(double first, double last, double step) {
  std::vector<double> result;
  for (double w = first; w <= last; w += step) result.push_back(w);
  return result;
}

}  // namespace

TEST(CieTables, CoverTheVisibleRangeEveryFiveNanometres) {
  const auto table = brdf::cieTable();
  ASSERT_EQ(table.size(), 81u);
  for (std::size_t i = 0; i < table.size(); ++i) EXPECT_EQ(table[i].wavelength, 380 + 5.0 * i);
}

TEST(CieTables, LuminousEfficiencyPeaksAtOneAt555Nanometres) {
  const auto peak = std::ranges::max_element(brdf::cieTable(), {}, &brdf::CieSample::yBar);
  EXPECT_EQ(peak->wavelength, 555);
  EXPECT_EQ(peak->yBar, 1);
}

TEST(CieTables, EqualEnergySumsAreThoseThatCieGives) {
  // CIE 15:2004 table 6: the 5 nm sums are 21.371 4, 21.371 1, 21.371 5 (360 to 830 nm, and to 380..780 nm within
  // 1e-3).
  double x = 0, y = 0, z = 0;
  for (const auto& line : brdf::cieTable()) x += line.xBar, y += line.yBar, z += line.zBar;
  EXPECT_NEAR(x, 21.3714, 1e-3);
  EXPECT_NEAR(y, 21.3711, 1e-3);
  EXPECT_NEAR(z, 21.3715, 1e-3);
}

TEST(CieTables, D65HasItsPublishedChromaticity) {
  double x = 0, y = 0, z = 0;
  for (const auto& line : brdf::cieTable())
    x += line.d65 * line.xBar, y += line.d65 * line.yBar, z += line.d65 * line.zBar;
  EXPECT_NEAR(x / (x + y + z), 0.31272, 1e-5);  // CIE 15:2004, table 11.3
  EXPECT_NEAR(y / (x + y + z), 0.32903, 1e-5);
  EXPECT_EQ(brdf::cieAt(560).d65, 100);
}

TEST(CieTables, AgreeWithTheAnalyticApproximation) {
  // Its authors give maximum errors of 2 % or so of each function's peak.
  for (const auto& line : brdf::cieTable()) {
    const auto fit = wyman(line.wavelength);
    EXPECT_NEAR(line.xBar, fit.xBar, 0.03) << line.wavelength;
    EXPECT_NEAR(line.yBar, fit.yBar, 0.02) << line.wavelength;
    EXPECT_NEAR(line.zBar, fit.zBar, 0.07) << line.wavelength;
  }
}

TEST(CieTables, AreLinearBetweenTheLinesAndZeroOutside) {
  const auto middle = brdf::cieAt(557.5);
  EXPECT_DOUBLE_EQ(middle.yBar, (1.0 + 0.995) / 2);
  for (double outside : {379.9, 780.1, -1.0, std::nan("")}) EXPECT_EQ(brdf::cieAt(outside).yBar, 0) << outside;
  EXPECT_GT(brdf::cieAt(780).yBar, 0);
}

TEST(Colorimetry, LuminanceWeightsAreTheRatioOfSums) {
  const auto wavelengths = range(400, 700, 10);
  const auto weights = brdf::luminanceWeights(wavelengths);
  double sum = 0;
  for (double w : wavelengths) sum += brdf::cieAt(w).yBar;
  for (std::size_t i = 0; i < weights.size(); ++i)
    EXPECT_NEAR(weights[i], brdf::cieAt(wavelengths[i]).yBar / sum, 1e-15);
}

TEST(Colorimetry, UnevenWavelengthsCountByTheirShare) {
  // Dense samples in one half must not outweigh the other: a ramp keeps its luminance.
  const auto even = range(400, 700, 5);
  std::vector<double> uneven = range(400, 550, 1);
  for (double w : range(555, 700, 5)) uneven.push_back(w);
  const auto luminance = [](const std::vector<double>& wavelengths) {
    const auto weights = brdf::luminanceWeights(wavelengths);
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * wavelengths[i];
    return sum;
  };
  EXPECT_NEAR(luminance(uneven), luminance(even), 0.1);
}

TEST(Colorimetry, PerfectWhiteIsOneInEveryColour) {
  for (const auto& wavelengths : {range(400, 700, 10), range(380, 780, 5), range(650, 1000, 25), range(550, 550, 1)}) {
    const auto weights = brdf::rgbWeights(wavelengths);
    for (std::size_t r = 0; r < 3; ++r) {
      const auto row = weights.begin() + static_cast<std::ptrdiff_t>(r * wavelengths.size());
      EXPECT_NEAR(std::accumulate(row, row + static_cast<std::ptrdiff_t>(wavelengths.size()), 0.0), 1, 1e-15);
    }
  }
}

TEST(Colorimetry, LongWavesAreRedAndShortOnesBlue) {
  const auto wavelengths = range(400, 700, 10);
  const auto weights = brdf::rgbWeights(wavelengths);
  const auto colour = [&](double from, double to) {
    std::array<double, 3> rgb{};
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t i = 0; i < wavelengths.size(); ++i)
        if (wavelengths[i] >= from && wavelengths[i] <= to) rgb[r] += weights[r * wavelengths.size() + i];
    return rgb;
  };
  const auto red = colour(600, 700), green = colour(510, 570), blue = colour(400, 480);
  EXPECT_GT(red[0], std::max(red[1], red[2]));
  EXPECT_GT(green[1], std::max(green[0], green[2]));
  EXPECT_GT(blue[2], std::max(blue[0], blue[1]));
}

TEST(Colorimetry, InvisibleLightIsAnError) {
  EXPECT_THROW(brdf::luminanceWeights(range(900, 1000, 50)), brdf::Error);
  EXPECT_THROW(brdf::rgbWeights(range(900, 1000, 50)), brdf::Error);
  EXPECT_THROW(brdf::rgbWeights({}), brdf::Error);
}

TEST(Colorimetry, SrgbMatrixIsThatOfTheStandard) {
  // IEC 61966-2-1, rounded there to four digits.
  const double expected[3][3] = {{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
  const auto matrix = brdf::xyzToLinearSrgb();
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(matrix[r][c], expected[r][c], 4e-4);
  const auto back = brdf::linearSrgbToXyz();
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(back[1][c], brdf::kRgbLuminanceWeights[c], 1e-4);
}

TEST(Colorimetry, SrgbEncodingGoesThereAndBack) {
  for (double value : {0.0, 1e-6, 0.0031308, 0.01, 0.18, 0.5, 1.0})
    EXPECT_NEAR(brdf::decodeSrgb(brdf::encodeSrgb(value)), value, 1e-8) << value;
  EXPECT_NEAR(brdf::encodeSrgb(0.18), 0.4613561295, 1e-9);  // 1.055 * 0.18^(1/2.4) - 0.055 by hand
  EXPECT_EQ(brdf::encodeSrgb(-1), 0);
  EXPECT_EQ(brdf::encodeSrgb(2), 1);
  EXPECT_EQ(brdf::encodeSrgb(std::nan("")), 0);
}
