#include "SurfaceSupport.h"

#include <brdf/geometry/Directions.h>
#include <brdf/simulate/HeightStatistics.h>
#include <brdf/simulate/MeasuredSpectrum.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// Mean product of heights (i, j) nodes apart, around the tile.
double covariance(const HeightField& field, std::size_t i, std::size_t j) {
  double sum = 0;
  for (std::size_t row = 0; row < field.rows; ++row)
    for (std::size_t column = 0; column < field.columns; ++column)
      sum += static_cast<double>(field.height(column, row)) *
             static_cast<double>(field.height((column + i) % field.columns, (row + j) % field.rows));
  return sum / static_cast<double>(field.heights.size());
}

std::string withSeed(const std::string& expression, std::size_t seed) {
  return expression.substr(0, expression.size() - 1) + ", seed=" + std::to_string(seed) + ")";
}

TEST(RandomSurface, RmsHeightOfTheTileIsWhatIsAskedFor) {
  for (const char* kind : {"gaussian", "exponential"})
    for (const std::size_t seed : {1, 2, 3}) {
      const HeightField field = heightField(withSeed(std::string(kind) + "(rms=0.37, correlation=3)", seed));
      const HeightStatistics statistics = statisticsOf(field);
      EXPECT_NEAR(statistics.rms, 0.37, 0.37 * 1e-6);
      EXPECT_NEAR(statistics.mean, 0, 1e-6);
    }
  EXPECT_EQ(statisticsOf(heightField("gaussian(rms=0)")).rms, 0);
}

TEST(RandomSurface, AutocovarianceIsTheClosedFormWithinItsStandardError) {
  struct Case {
    std::string expression;
    double lengthX, lengthY;
    bool exponential;
  };
  // 8 lags each; a deviation beyond 4.4 standard errors has probability 1e-5 for normal, about 1e-3 for Student's t of
  // the 47 degrees of freedom over all 24.
  for (const Case& c :
       {Case{"gaussian(rms=2, correlation=5, rms_of=ensemble, period=160, resolution=4)", 5, 5, false},
        Case{"gaussian(rms=2, correlation=10, correlation_y=4, rms_of=ensemble, period=160, resolution=4)", 10, 4,
             false},
        Case{"exponential(rms=2, correlation=5, correlation_y=8, rms_of=ensemble, period=160, resolution=12)", 5, 8,
             true}}) {
    SCOPED_TRACE(c.expression);
    const std::vector<std::array<std::size_t, 2>> lags{{1, 0}, {2, 0}, {4, 0}, {8, 0},
                                                       {0, 2}, {0, 5}, {3, 3}, {20, 20}};
    std::vector<std::vector<double>> draws(lags.size());
    HeightField field;
    for (std::size_t seed = 0; seed < 48; ++seed) {
      field = heightField(withSeed(c.expression, seed));
      for (std::size_t k = 0; k < lags.size(); ++k) draws[k].push_back(covariance(field, lags[k][0], lags[k][1]));
    }
    for (std::size_t k = 0; k < lags.size(); ++k) {
      const double x = static_cast<double>(lags[k][0]) * field.spacingX / c.lengthX;
      const double y = static_cast<double>(lags[k][1]) * field.spacingY / c.lengthY;
      const double shape = c.exponential ? std::exp(-std::hypot(x, y)) : std::exp(-x * x - y * y);
      // Without f = 0, its cell's share of the variance is missing at every lag.
      const double peak = (c.exponential ? 2 * kPi : kPi) * c.lengthX * c.lengthY;
      const double expected = 4 * (shape - peak / (field.periodX() * field.periodY()));
      // Of the exponential, frequencies beyond the lattice are missing: below 1 / (pi 12) at lags of a node or more.
      if (c.exponential && lags[k][0] + lags[k][1] < 4) continue;
      EXPECT_LT(std::abs(deviation(draws[k], expected)), 4.4) << lags[k][0] << "," << lags[k][1];
    }
  }
}

TEST(RandomSurface, SlopesOfGaussianSurfacesAreGaussian) {
  // Slopes of triangles 4 correlation lengths apart, correlated by less than 2e-6, against the normal distribution of
  // the closed form: E (h(x+d) - h(x))^2 = 2 rms^2 (1 - exp(-d^2/L^2)). Anderson-Darling with known mean and variance:
  // beyond 3.857 with probability 1 % (Stephens 1974, doi:10.1080/01621459.1974.10480196).
  const HeightField field = heightField("gaussian(rms=1, correlation=10, rms_of=ensemble, period=1280, resolution=8)");
  const double d = field.spacingX, sigma = std::sqrt(2 * (1 - std::exp(-d * d / 100))) / d;
  for (const bool alongX : {true, false}) {
    std::vector<double> u;
    for (std::size_t j = 0; j < field.rows; j += 32)
      for (std::size_t i = 0; i < field.columns; i += 32) {
        const double next = alongX ? field.height(i + 1, j) : field.height(i, j + 1);
        u.push_back(0.5 * std::erfc(-(next - field.height(i, j)) / d / sigma / std::sqrt(2.0)));
      }
    std::ranges::sort(u);
    const std::size_t n = u.size();
    ASSERT_EQ(n, 1024u);
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k)
      sum += static_cast<double>(2 * k + 1) * (std::log(u[k]) + std::log1p(-u[n - 1 - k]));
    EXPECT_LT(-static_cast<double>(n) - sum / static_cast<double>(n), 3.857);
  }
}

TEST(RandomSurface, SlopeOfTheTrianglesIsTheClosedForm) {
  const MadeSurface made = makeSurface("gaussian(rms=0.5, correlation=8, correlation_y=16, resolution=8)");
  // The slopes' mean square over one tile of 64 x 64 correlation areas scatters by about 1 / 64 of itself.
  const double factor = std::sqrt((1 - std::exp(-1.0 / 64)) * 64);
  EXPECT_NEAR(factOf(made, "rms slope along x"), std::sqrt(2) * 0.5 / 8 * factor, 0.03 * 0.0884);
  EXPECT_NEAR(factOf(made, "rms slope along y"), std::sqrt(2) * 0.5 / 16 * factor, 0.03 * 0.0442);
}

TEST(RandomSurface, SpectrumIsTheOneAskedFor) {
  // Every frequency's share of the periodogram is its PSD times an exponential variate of mean 1, one for each pair of
  // opposite frequencies: mean 1 and mean square 2, of standard deviations 1 and sqrt(20).
  struct Case {
    std::string expression, spectrum;
  };
  for (const Case& c : {Case{"gaussian(rms=2, correlation=5, rms_of=ensemble, period=160, resolution=4)",
                             "gaussian(rms=2, correlation=5)"},
                        Case{"rough(spectrum=abc(a=0.01, b=5, c=3), period=80, spacing=0.5)", "abc(a=0.01, b=5, c=3)"},
                        Case{"rough(spectrum=fractal(a=0.02, exponent=2.5), period=80, spacing=0.5)",
                             "fractal(a=0.02, exponent=2.5)"}}) {
    SCOPED_TRACE(c.expression);
    const HeightSpectrum measured = spectrumOf(heightField(c.expression));
    const SpectrumPointer spectrum = makeSpectrum(c.spectrum);
    const double floor = 1e-7 * spectrum->psd(measured.frequencyX(1), 0);
    double sum = 0, squares = 0, count = 0;
    for (std::size_t n = 1; n < measured.rows / 2; ++n)
      for (std::size_t m = 0; m < measured.columns; ++m) {
        const double expected = spectrum->psd(measured.frequencyX(m), measured.frequencyY(n));
        if (expected < floor) continue;  // heights are floats
        const double ratio = measured.psd[n * measured.columns + m] / expected;
        sum += ratio;
        squares += ratio * ratio;
        ++count;
      }
    ASSERT_GT(count, 500);
    EXPECT_LT(std::abs(sum / count - 1) * std::sqrt(count), 4);
    EXPECT_LT(std::abs(squares / count - 2) * std::sqrt(count / 20), 4);
  }
}

TEST(RandomSurface, TileRepeatsWithoutAStep) {
  for (const char* expression : {"gaussian(correlation=5)", "exponential(correlation=5)",
                                 "rough(spectrum=abc(a=0.01, b=5, c=3), period=80, spacing=0.5)", "sinusoidal"}) {
    SCOPED_TRACE(expression);
    const HeightField field = heightField(expression);
    double across = 0, inside = 0;
    for (std::size_t j = 0; j < field.rows; ++j) {
      across += std::pow(field.height(0, j) - field.height(field.columns - 1, j), 2);
      for (std::size_t i = 1; i < field.columns; ++i)
        inside += std::pow(field.height(i, j) - field.height(i - 1, j), 2);
    }
    const double ratio = across / (inside / static_cast<double>(field.columns - 1));
    EXPECT_LT(ratio, 2);  // a step would be some hundred times the mean square of smooth heights
  }
}

TEST(RandomSurface, RefusesWhatDoesNotFit) {
  EXPECT_NE(surfaceError("gaussian(correlation=10, period=20)").find("at least 4 correlation lengths"),
            std::string::npos);
  EXPECT_NE(surfaceError("gaussian(correlation=1e-3, period=1000)").find("too many nodes"), std::string::npos);
  EXPECT_NE(surfaceError("rough").find("spectrum: must be given"), std::string::npos);
  EXPECT_NE(surfaceError("rough(spectrum=acb(a=1))").find("unknown spectrum"), std::string::npos);
}

}  // namespace
}  // namespace brdf
