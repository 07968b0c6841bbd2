#include <brdf/base/Error.h>
#include <brdf/color/CieTables.h>
#include <brdf/color/Colorimetry.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {

using brdf::Adaptation;
using brdf::ColourSettings;
using brdf::Observer;
using Spectrum = std::vector<double>;

Spectrum range(double first, double last, double step) {
  Spectrum result;
  for (double w = first; w <= last; w += step) result.push_back(w);
  return result;
}

std::array<double, 3> colour(const Spectrum& weights, const Spectrum& reflectance) {
  std::array<double, 3> result{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t i = 0; i < reflectance.size(); ++i)
      result[r] += weights[r * reflectance.size() + i] * reflectance[i];
  return result;
}

std::vector<ColourSettings> everySettings() {
  std::vector<ColourSettings> all;
  for (const auto name : brdf::illuminantNames())
    for (const Observer observer : {Observer::Cie1931, Observer::Cie1964})
      all.push_back({brdf::illuminantNamed(name), observer, Adaptation::Bradford});
  return all;
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  double largest = 0;
  for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
  return largest;
}

}  // namespace

TEST(ColourSettings, TheDefaultIsD65AndTwoDegreesToTheLastBit) {
  // What rgbWeights and luminanceWeights computed before they took settings, written out.
  const auto wavelengths = range(401.3, 699, 9.7);
  const std::size_t n = wavelengths.size();
  Spectrum x(n), y(n), z(n), luminance(n);
  const auto width = [&](std::size_t i) {
    if (i == 0) return wavelengths[1] - wavelengths[0];
    if (i + 1 == n) return wavelengths[n - 1] - wavelengths[n - 2];
    return (wavelengths[i + 1] - wavelengths[i - 1]) / 2;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const auto line = brdf::cieAt(wavelengths[i]);
    x[i] = width(i) * line.d65 * line.xBar;
    y[i] = width(i) * line.d65 * line.yBar;
    z[i] = width(i) * line.d65 * line.zBar;
    luminance[i] = width(i) * line.yBar;
  }
  for (Spectrum* weights : {&x, &y, &z, &luminance}) {
    double sum = 0;
    for (const double weight : *weights) sum += weight;
    for (double& weight : *weights) weight /= sum;
  }
  const auto matrix = brdf::xyzToLinearSrgb();
  Spectrum rgb(3 * n);
  for (std::size_t r = 0; r < 3; ++r) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double weight = 0;
      weight += matrix[r][0] * (0.3127 / 0.3290) * x[i];
      weight += matrix[r][1] * 1 * y[i];
      weight += matrix[r][2] * ((1 - 0.3127 - 0.3290) / 0.3290) * z[i];
      rgb[r * n + i] = weight;
      sum += weight;
    }
    for (std::size_t i = 0; i < n; ++i) rgb[r * n + i] /= sum;
  }
  EXPECT_EQ(brdf::rgbWeights(wavelengths), rgb);
  EXPECT_EQ(brdf::luminanceWeights(wavelengths), luminance);
  ColourSettings stated{brdf::illuminantNamed("D65")};
  EXPECT_EQ(brdf::rgbWeights(wavelengths, stated), rgb);
  stated.adaptation = Adaptation::None;
  EXPECT_EQ(brdf::rgbWeights(wavelengths, stated), rgb);
}

TEST(ColourSettings, AdaptedWhiteIsOneInEveryColourUnderEveryIlluminant) {
  for (const ColourSettings& settings : everySettings())
    for (const auto& wavelengths : {range(400, 700, 10), range(380, 780, 5), range(650, 1000, 25), Spectrum{550}}) {
      const auto white = colour(brdf::rgbWeights(wavelengths, settings), Spectrum(wavelengths.size(), 1));
      EXPECT_LT(distance(white, {1, 1, 1}), 1e-14) << describe(settings) << " " << wavelengths.size();
      const auto weights = brdf::luminanceWeights(wavelengths, settings);
      EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-14);
    }
}

TEST(ColourSettings, UnadaptedWhiteHasTheIlluminantsColour) {
  // Illuminant A, 2 degrees: XYZ (1.09850, 1, 0.35585) as published (ASTM E308), through the standard's rounded matrix.
  const double matrix[3][3] = {{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
  const auto wavelengths = range(380, 780, 5);
  const ColourSettings settings{brdf::illuminantNamed("A"), Observer::Cie1931, Adaptation::None};
  const auto white = colour(brdf::rgbWeights(wavelengths, settings), Spectrum(wavelengths.size(), 1));
  for (std::size_t r = 0; r < 3; ++r)
    EXPECT_NEAR(white[r], matrix[r][0] * 1.09850 + matrix[r][1] + matrix[r][2] * 0.35585, 1e-3);
}

TEST(ColourSettings, WhitePointsAreThePublishedTristimulusValues) {
  // ASTM E308-01: X and Z of a perfect white, there for Y = 100, from finer tables over a longer range; ours
  // of D65 and 2 degrees is that of sRGB, whose chromaticity has four digits.
  const struct {
    const char* name;
    Observer observer;
    double x, z, tolerance;
  } published[] = {
      {"A", Observer::Cie1931, 1.09850, 0.35585, 5e-5},   {"D50", Observer::Cie1931, 0.96422, 0.82521, 1e-4},
      {"D55", Observer::Cie1931, 0.95682, 0.92149, 2e-4}, {"D65", Observer::Cie1931, 0.95047, 1.08883, 3e-4},
      {"D75", Observer::Cie1931, 0.94972, 1.22638, 3e-4}, {"F2", Observer::Cie1931, 0.99186, 0.67393, 2e-5},
      {"F7", Observer::Cie1931, 0.95041, 1.08747, 3e-5},  {"F11", Observer::Cie1931, 1.00962, 0.64350, 2e-5},
      {"A", Observer::Cie1964, 1.11144, 0.35200, 1e-5},   {"D65", Observer::Cie1964, 0.94811, 1.07304, 3e-4},
      {"F2", Observer::Cie1964, 1.03280, 0.69026, 1e-4},  {"F7", Observer::Cie1964, 0.95792, 1.07687, 1e-4},
      {"F11", Observer::Cie1964, 1.03866, 0.65627, 3e-4}};
  for (const auto& p : published) {
    const auto white = brdf::whitePoint({brdf::illuminantNamed(p.name), p.observer, Adaptation::Bradford});
    EXPECT_NEAR(white[0], p.x, p.tolerance) << p.name;
    EXPECT_EQ(white[1], 1) << p.name;
    EXPECT_NEAR(white[2], p.z, p.tolerance) << p.name;
  }
}

TEST(ColourSettings, BradfordIsTheIccsMatrixFromD65ToD50) {
  // ICC Technical Note 02-2003, from these whites.
  const double expected[3][3] = {{1.04790738171017, 0.0229333845542104, -0.0502016347980104},
                                 {0.0296059594177168, 0.990456039910785, -0.01707552919587},
                                 {-0.00924679432678241, 0.0150626801401488, 0.751791232609078}};
  const auto matrix = brdf::bradford({0.9504, 1, 1.0889}, {0.9642, 1, 0.8249});
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(matrix[r][c], expected[r][c], 1e-13);
}

TEST(ColourSettings, OneWavelengthHasTheChromaticityOfTheSpectrumLocus) {
  // CIE 15:2004 tables T.4 and T.5: chromaticity coordinates of the spectrum; the illuminant does not matter.
  const auto wavelengths = range(380, 780, 5);
  const struct {
    double wavelength, x, y;
  } locus[] = {{450, 0.15664, 0.01771},
               {520, 0.07430, 0.83380},
               {550, 0.30160, 0.69231},
               {600, 0.62704, 0.37249},
               {700, 0.73469, 0.26531}};
  for (const char* name : {"E", "A", "D50", "F11"})
    for (const auto& p : locus) {
      const ColourSettings settings{brdf::illuminantNamed(name)};
      const auto weights = brdf::xyzWeights(wavelengths, settings);
      const auto i = static_cast<std::size_t>((p.wavelength - 380) / 5);
      const std::size_t n = wavelengths.size();
      const double sum = weights[i] + weights[n + i] + weights[2 * n + i];
      EXPECT_NEAR(weights[i] / sum, p.x, 1e-5) << name << " " << p.wavelength;
      EXPECT_NEAR(weights[n + i] / sum, p.y, 1e-5) << name << " " << p.wavelength;
    }
}

TEST(ColourSettings, MetamersMatchUnderOneLightAndNotUnderAnother) {
  // A grey, and the grey plus what is left of a wave when its colour under D65 is taken out.
  const auto wavelengths = range(400, 700, 10);
  const std::size_t n = wavelengths.size();
  const auto weights = brdf::rgbWeights(wavelengths);
  Spectrum wave(n);
  for (std::size_t i = 0; i < n; ++i) wave[i] = std::sin(wavelengths[i] / 18);
  std::vector<Spectrum> basis;
  for (std::size_t r = 0; r < 3; ++r) {
    Spectrum row(weights.begin() + static_cast<std::ptrdiff_t>(r * n),
                 weights.begin() + static_cast<std::ptrdiff_t>((r + 1) * n));
    basis.push_back(row);
    for (std::size_t k = 0; k < r; ++k) {
      const double dot = std::inner_product(basis[r].begin(), basis[r].end(), basis[k].begin(), 0.0);
      for (std::size_t i = 0; i < n; ++i) basis[r][i] -= dot * basis[k][i];
    }
    const double length = std::sqrt(std::inner_product(basis[r].begin(), basis[r].end(), basis[r].begin(), 0.0));
    for (double& entry : basis[r]) entry /= length;
    const double dot = std::inner_product(wave.begin(), wave.end(), basis[r].begin(), 0.0);
    for (std::size_t i = 0; i < n; ++i) wave[i] -= dot * basis[r][i];
  }
  const Spectrum grey(n, 0.5);
  Spectrum other = grey;
  for (std::size_t i = 0; i < n; ++i) other[i] += 0.4 * wave[i];
  EXPECT_LT(distance(colour(weights, grey), colour(weights, other)), 1e-14);
  for (const char* name : {"A", "F2", "F11"}) {
    const auto under = brdf::rgbWeights(wavelengths, {brdf::illuminantNamed(name)});
    EXPECT_LT(distance(colour(under, grey), {0.5, 0.5, 0.5}), 1e-14);
    EXPECT_GT(distance(colour(under, grey), colour(under, other)), 0.01) << name;
  }
  const auto tenDegrees = brdf::rgbWeights(wavelengths, {std::nullopt, Observer::Cie1964});
  EXPECT_GT(distance(colour(tenDegrees, grey), colour(tenDegrees, other)), 1e-3);
}

TEST(ColourSettings, LinesBetweenTheDatasWavelengthsCount) {
  // F11's green line is at 545 nm, between samples every 10 nm: a reflectance that is linear between them must get
  // nearly the colour that its values every 5 nm get.
  const ColourSettings settings{brdf::illuminantNamed("F11")};
  const auto reflectance = [](const Spectrum& wavelengths) {
    Spectrum result;
    for (const double w : wavelengths) result.push_back(0.2 + 0.6 / (1 + std::exp((560 - w) / 20)));
    return result;
  };
  const auto coarse = range(380, 780, 10), fine = range(380, 780, 5);
  const auto a = colour(brdf::rgbWeights(coarse, settings), reflectance(coarse));
  const auto b = colour(brdf::rgbWeights(fine, settings), reflectance(fine));
  EXPECT_LT(distance(a, b), 3e-3);
}

TEST(ColourSettings, LuminanceUnderALightIsTheRatioOfSums) {
  const auto wavelengths = range(400, 700, 10);
  const auto a = brdf::illuminantNamed("A");
  const auto weights = brdf::luminanceWeights(wavelengths, {a, Observer::Cie1964});
  double sum = 0;
  for (const double w : wavelengths) sum += a.at(w) * brdf::colourMatching(Observer::Cie1964, w)[1];
  for (std::size_t i = 0; i < weights.size(); ++i)
    EXPECT_NEAR(weights[i], a.at(wavelengths[i]) * brdf::colourMatching(Observer::Cie1964, wavelengths[i])[1] / sum,
                1e-15);
}

TEST(ColourSettings, InvisibleDataAreAnErrorUnderEveryLight) {
  for (const ColourSettings& settings : everySettings()) {
    EXPECT_THROW(brdf::rgbWeights(range(900, 1000, 50), settings), brdf::Error);
    EXPECT_THROW(brdf::rgbWeights({}, settings), brdf::Error);
  }
}
