#include "SurfaceSupport.h"

#include <brdf/geometry/Directions.h>
#include <brdf/simulate/HeightStatistics.h>
#include <brdf/simulate/MeasuredSpectrum.h>
#include <brdf/simulate/SurfaceRandom.h>

#include <cmath>

namespace brdf {
namespace {

HeightField noise(std::size_t columns, std::size_t rows) {
  HeightField field{columns, rows, 0.5, 0.25, {}};
  SurfaceRandom random(7);
  for (std::size_t k = 0; k < columns * rows; ++k) field.heights.push_back(static_cast<float>(3 + random.normal()));
  return field;
}

/// amplitude cos(2 pi (m i / columns + n j / rows)).
HeightField wave(std::size_t columns, std::size_t rows, double m, double n, double amplitude) {
  HeightField field{columns, rows, 0.5, 0.25, {}};
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i)
      field.heights.push_back(
          static_cast<float>(amplitude * std::cos(2 * kPi *
                                                  (m * static_cast<double>(i) / static_cast<double>(columns) +
                                                   n * static_cast<double>(j) / static_cast<double>(rows)))));
  return field;
}

TEST(MeasuredSpectrum, IntegralIsTheVariance) {
  for (const auto& [columns, rows] :
       {std::pair<std::size_t, std::size_t>{16, 8}, {15, 9}, {2, 2}, {31, 64}, {2, 100}}) {
    const HeightField field = noise(columns, rows);
    const double variance = std::pow(statisticsOf(field).rms, 2);
    EXPECT_NEAR(spectrumOf(field).variance(), variance, 1e-12 * variance) << columns << " x " << rows;
    const SpectrumPointer cells = measuredSpectrum(field, SpectrumWindow::None, false);
    EXPECT_NEAR(cells->variance(), variance, 1e-12 * variance);
    // The integral over the plane, cell by cell: four points in each see halves of the highest frequencies' cells.
    double integral = 0;
    const double stepX = 1 / field.periodX(), stepY = 1 / field.periodY();
    for (double v = -static_cast<double>(rows) / 2 - 0.75; v < static_cast<double>(rows) / 2 + 1; v += 0.5)
      for (double u = -static_cast<double>(columns) / 2 - 0.75; u < static_cast<double>(columns) / 2 + 1; u += 0.5)
        integral += cells->psd(u * stepX, v * stepY) * stepX * stepY / 4;
    EXPECT_NEAR(integral, variance, 1e-12 * variance) << columns << " x " << rows;
  }
}

TEST(MeasuredSpectrum, WaveHasItsPowerAtItsFrequency) {
  const HeightField field = wave(32, 20, 3, -2, 0.7);
  const HeightSpectrum spectrum = spectrumOf(field);
  const double area = field.periodX() * field.periodY();
  for (std::size_t n = 0; n < 20; ++n)
    for (std::size_t m = 0; m < 32; ++m) {
      const bool there = (m == 3 && n == 18) || (m == 29 && n == 2);
      EXPECT_NEAR(spectrum.psd[n * 32 + m], there ? 0.49 / 4 * area : 0, 1e-6 * area) << m << "," << n;
    }
  EXPECT_DOUBLE_EQ(spectrum.frequencyX(29), -3 / field.periodX());
  EXPECT_DOUBLE_EQ(spectrum.frequencyY(2), 2 / field.periodY());
  const double slope = 2 * kPi * 3 / field.periodX();
  EXPECT_NEAR(spectrum.slopeVarianceX(), slope * slope * 0.49 / 2, 1e-6);
  const SpectrumPointer cells = measuredSpectrum(field, SpectrumWindow::None, false);
  EXPECT_NEAR(cells->psd(3 / field.periodX(), -2 / field.periodY()), 0.49 / 4 * area, 1e-6 * area);
  EXPECT_NEAR(cells->psd(-3 / field.periodX(), 2 / field.periodY()), 0.49 / 4 * area, 1e-6 * area);
  EXPECT_NEAR(cells->psd(3 / field.periodX(), 2 / field.periodY()), 0, 1e-6 * area);
}

TEST(MeasuredSpectrum, HannWindowKeepsTheVarianceOfAWave) {
  // Its square holds no harmonic above the second: a wave of three or more periods keeps its mean square exactly.
  EXPECT_NEAR(spectrumOf(wave(64, 48, 5, 4, 0.7), SpectrumWindow::Hann).variance(), 0.49 / 2, 1e-6);
  HeightField flat{8, 8, 1, 1, std::vector<float>(64, 5.0F)};
  EXPECT_EQ(spectrumOf(flat, SpectrumWindow::Hann).variance(), 0);
}

TEST(MeasuredSpectrum, HannWindowKeepsEdgesThatDoNotFitOutOfTheTail) {
  // Two and a half periods: a jump at the edge. Far from the wave's frequency the window leaves next to nothing.
  const HeightField field = wave(256, 4, 10.5, 0, 1);
  const HeightSpectrum plain = spectrumOf(field), hann = spectrumOf(field, SpectrumWindow::Hann);
  EXPECT_GT(plain.psd[100], 1e3 * hann.psd[100]);
}

TEST(MeasuredSpectrum, AutocovarianceIsTheMeanProduct) {
  const HeightField field = noise(12, 10);
  const double mean = statisticsOf(field).mean;
  const SpectrumPointer cells = measuredSpectrum(field, SpectrumWindow::None, false);
  for (std::size_t j = 0; j < 10; j += 3)
    for (std::size_t i = 0; i < 12; ++i) {
      double sum = 0;
      for (std::size_t row = 0; row < 10; ++row)
        for (std::size_t column = 0; column < 12; ++column)
          sum += (field.height(column, row) - mean) * (field.height((column + i) % 12, (row + j) % 10) - mean);
      const double u = kPi * static_cast<double>(i) / 12, v = kPi * static_cast<double>(j) / 10;
      const double cell = (i ? std::sin(u) / u : 1) * (j ? std::sin(v) / v : 1);
      EXPECT_NEAR(cells->autocovariance(static_cast<double>(i) * 0.5, static_cast<double>(j) * 0.25), sum / 120 * cell,
                  1e-12)
          << i << "," << j;
    }
}

TEST(MeasuredSpectrum, RingsOfARandomSurfaceFollowItsSpectrum) {
  const HeightField field = heightField("gaussian(rms=2, correlation=5, rms_of=ensemble, period=320, resolution=4)");
  const SpectrumPointer exact = gaussianSpectrum(2, 5, 5);
  const RadialSpectrum rings = radialAverage(spectrumOf(field));
  double chiSquare = 0, count = 0;
  for (std::size_t k = 4; k < rings.psd.size(); ++k) {
    const double expected = exact->psd(rings.frequency[k], 0);
    if (expected < 1e-4 * exact->psd(0, 0)) break;
    // Opposite frequencies are one draw; the mean over the ring's width adds a bias far below its error.
    chiSquare += std::pow(rings.psd[k] / expected - 1, 2) * static_cast<double>(rings.counts[k]) / 2;
    ++count;
  }
  ASSERT_GT(count, 30);
  EXPECT_LT(std::abs(chiSquare - count) / std::sqrt(2 * count), 4);
  const SpectrumPointer radial = measuredSpectrum(field, SpectrumWindow::None, true);
  EXPECT_TRUE(radial->isotropic());
  EXPECT_NEAR(radial->variance(), std::pow(statisticsOf(field).rms, 2), 0.02 * 4);
  EXPECT_NEAR(radial->autocovariance(3, 4), 4 * std::exp(-1), 0.1 * 4 * std::exp(-1) + 0.1);
  EXPECT_EQ(radial->psd(1e9, 0), 0);
}

TEST(MeasuredSpectrum, AutocovarianceOfRingsIsTheFourierTransform) {
  // 2 pi integral of f PSD J0(2 pi f r), by Simpson's rule; the highest ring is at 2/um at most.
  const SpectrumPointer radial = measuredSpectrum(
      heightField("gaussian(rms=0.3, correlation=1, period=20, resolution=4)"), SpectrumWindow::None, true);
  for (const double r : {0.0, 1e-9, 1e-4, 0.03, 0.2, 1.0, 2.7, 15.0}) {
    const int steps = 200'000;
    double sum = 0;
    for (int k = 0; k <= steps; ++k) {
      const double f = 2.5 * k / steps, weight = k == 0 || k == steps ? 1 : (k % 2 ? 4 : 2);
      sum += weight * 2 * kPi * f * radial->psd(f, 0) * std::cyl_bessel_j(0, 2 * kPi * f * r);
    }
    EXPECT_NEAR(radial->autocovariance(0, r), sum * 2.5 / (3 * steps), 1e-6 * 0.09) << r;
  }
}

TEST(MeasuredSpectrum, IsASpectrumThatExpressionsName) {
  const SpectrumPointer spectrum =
      makeSpectrum("measured(surface=gaussian(rms=0.3, correlation=4), average=none, window=none)");
  EXPECT_NEAR(spectrum->variance(), 0.09, 1e-6);
  EXPECT_THROW(makeSpectrum("measured(surface=lamellar)"), std::exception);
  EXPECT_THROW(makeSpectrum("measured"), std::exception);
  EXPECT_THROW(makeSpectrum("measured(surface=flat, average=some)"), std::exception);
}

}  // namespace
}  // namespace brdf
