#include <brdf/base/Error.h>
#include <brdf/simulate/wave/Mie.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace brdf::wave {
namespace {

TEST(Mie, AppendixAOfBohrenAndHuffman) {
  // Bohren and Huffman (1983), appendix A: radius 0.525 um, index 1.55, wavelength 0.6328 um in vacuum, medium 1.
  const MieSphere sphere(2 * std::numbers::pi * 0.525 / 0.6328, 1.55);
  EXPECT_NEAR(sphere.extinction(), 3.10543, 5e-6);
  EXPECT_NEAR(sphere.scattering(), 3.10543, 5e-6);
  EXPECT_NEAR(sphere.backscattering(), 2.92534, 5e-6);
}

TEST(Mie, TestCasesOfWiscombe) {
  // W. J. Wiscombe, Mie Scattering Calculations, NCAR/TN-140+STR (1979), doi:10.5065/D6ZP4414, table of test cases;
  // indices there n - i k.
  struct Case {
    Complex index;
    double size, extinction, scattering, asymmetry;
  };
  const Case cases[] = {
      {{0.75, 0}, 0.099, 7.417859e-6, 7.417859e-6, 0.001448}, {{0.75, 0}, 10, 2.232265, 2.232265, 0.896473},
      {{0.75, 0}, 1000, 1.997908, 1.997908, 0.844944},        {{1.33, 1e-5}, 1, 0.093952, 0.093923, 0.184517},
      {{1.33, 1e-5}, 100, 2.101321, 2.096594, 0.868959},      {{1.33, 1e-5}, 10000, 2.004089, 1.723857, 0.907840},
      {{1.5, 1}, 0.055, 0.101491, 0.000011, 0.000491},        {{1.5, 1}, 1, 2.336321, 0.663454, 0.192136},
      {{1.5, 1}, 100, 2.097502, 1.283697, 0.850252},          {{1.5, 1}, 10000, 2.004368, 1.236574, 0.846310},
      {{10, 10}, 1, 2.532993, 2.049405, -0.110664},           {{10, 10}, 100, 2.071124, 1.836785, 0.556215},
      {{10, 10}, 10000, 2.005914, 1.795393, 0.548194},
  };
  for (const Case& one : cases) {
    const MieSphere sphere(one.size, one.index);
    EXPECT_NEAR(sphere.extinction(), one.extinction, 6e-7) << one.index << " " << one.size;
    EXPECT_NEAR(sphere.scattering(), one.scattering, 6e-7) << one.index << " " << one.size;
    EXPECT_NEAR(sphere.asymmetry(), one.asymmetry, 6e-7) << one.index << " " << one.size;
  }
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
