#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/simulate/wave/Mie.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>

namespace brdf::wave {
namespace {

TEST(Mie, IsTheSeriesInExtendedPrecision) {
  // tests/reference/mie.csv, computed by mie.py beside it with 300 digits and checked there against published figures:
  // Wiscombe's test cases of MIEV0 and Bohren and Huffman's appendix A.
  std::istringstream rows(readFile(std::filesystem::path(BRDF_SOURCE_DIR) / "tests/reference/mie.csv"));
  std::string line;
  std::getline(rows, line);
  std::size_t count = 0;
  while (std::getline(rows, line)) {
    double n = 0, k = 0, size = 0, extinction = 0, scattering = 0, back = 0, asymmetry = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%lf", &n, &k, &size, &extinction, &scattering, &back,
                          &asymmetry),
              7)
        << line;
    const MieSphere sphere(size, {n, k});
    // Rounding grows with the square of the size; backscattering is a sum of alternating terms.
    const double rounding = 1e-11 + 1e-16 * size * size;
    EXPECT_NEAR(sphere.extinction() / extinction, 1, rounding) << line;
    EXPECT_NEAR(sphere.scattering() / scattering, 1, rounding) << line;
    EXPECT_NEAR(sphere.backscattering() / back, 1, 1e3 * rounding) << line;
    EXPECT_NEAR(sphere.asymmetry(), asymmetry, rounding) << line;
    ++count;
  }
  EXPECT_EQ(count, 14u);
}

TEST(Mie, OpticalTheorem) {
  // Extinction is 4/x^2 Re S(0): Bohren and Huffman (4.76).
  for (const Complex index : {Complex(1.5, 0), Complex(0.2, 3), Complex(1.33, 0.01), Complex(4, 0.05)})
    for (const double size : {1e-3, 0.3, 2.0, 30.0, 1500.0}) {
      const MieSphere sphere(size, index);
      Complex s1, s2;
      sphere.amplitudes(1, s1, s2);
      EXPECT_NEAR(4 / (size * size) * s1.real() / sphere.extinction(), 1, 1e-12) << index << size;
      EXPECT_NEAR(std::abs(s1 - s2), 0, 1e-12 * std::abs(s1));
      sphere.amplitudes(-1, s1, s2);
      EXPECT_NEAR(4 / (size * size) * std::norm(s1) / sphere.backscattering(), 1, 1e-9) << index << size;
    }
}

TEST(Mie, ScatteringIsTheIntegralOfTheAmplitudes) {
  for (const Complex index : {Complex(1.5, 0), Complex(0.2, 3)})
    for (const double size : {0.1, 3.0, 20.0}) {
      const MieSphere sphere(size, index);
      double sum = 0, cosine = 0;
      const int steps = 4000;
      for (int k = 0; k <= steps; ++k) {  // Simpson's rule in the angle
        const double theta = std::numbers::pi * k / steps, mu = std::cos(theta);
        Complex s1, s2;
        sphere.amplitudes(mu, s1, s2);
        const double weight = k == 0 || k == steps ? 1 : (k % 2 ? 4 : 2);
        sum += weight * (std::norm(s1) + std::norm(s2)) * std::sin(theta);
        cosine += weight * mu * (std::norm(s1) + std::norm(s2)) * std::sin(theta);
      }
      EXPECT_NEAR(sum * std::numbers::pi / (3 * steps) / (size * size) / sphere.scattering(), 1, 1e-8);
      EXPECT_NEAR(cosine / sum, sphere.asymmetry(), 1e-8);
    }
}

TEST(Mie, TinySpheresAreRayleighs) {
  // Bohren and Huffman (5.7), (5.8) without the next order: relative error of the order of x^2.
  for (const double size : {1e-12, 1e-8, 1e-4})
    for (const Complex index : {Complex(1.5, 0), Complex(1.5, 0.1)}) {
      const MieSphere sphere(size, index);
      const Complex contrast = (index * index - 1.0) / (index * index + 2.0);
      EXPECT_NEAR(sphere.scattering() / (8 / 3.0 * std::pow(size, 4) * std::norm(contrast)), 1, 1e-7) << size;
      if (index.imag() > 0) {
        EXPECT_NEAR(sphere.extinction() / (4 * size * contrast.imag()), 1, 1e-7) << size;
      }
    }
}

TEST(Mie, LargeSpheresExtinguishTwiceTheirShadow) {
  for (const double size : {1e5, 1e6}) {
    const MieSphere sphere(size, {1.5, 0.1});
    // Corrections to the extinction paradox are 1.99 x^(-2/3): H. M. Nussenzveig and W. J. Wiscombe, Phys. Rev. Lett.
    // 45, 1490 (1980), doi:10.1103/PhysRevLett.45.1490.
    EXPECT_NEAR(sphere.extinction(), 2 + 1.9923861 * std::pow(size, -2 / 3.0), 2e-5) << size;
    EXPECT_LT(sphere.scattering(), sphere.extinction());
  }
  EXPECT_TRUE(std::isfinite(MieSphere(1e3, {1, 1e3}).extinction()));
  EXPECT_NEAR(MieSphere(3, {1, 0}).extinction(), 0, 1e-14);
}

TEST(Mie, RefusesWhatItCannotSum) {
  EXPECT_THROW(MieSphere(0, 1.5), Error);
  EXPECT_THROW(MieSphere(1e7, 1.5), Error);
  EXPECT_THROW(MieSphere(1, 0), Error);
  EXPECT_THROW(MieSphere(1e6, {1, 1000}), Error);
  EXPECT_THROW(MieSphere(std::nan(""), 1.5), Error);
}

}  // namespace
}  // namespace brdf::wave
