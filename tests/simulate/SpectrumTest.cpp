#include <brdf/base/Error.h>
#include <brdf/simulate/Spectrum.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace brdf {
namespace {

constexpr double kPi = std::numbers::pi;

/// Integral of g(f) over the half line by the double-exponential rule f = exp(pi/2 sinh t).
template <class Function>
double overHalfLine(Function&& g) {
  double sum = 0;
  const double step = 1.0 / 64;
  for (int k = -256; k <= 256; ++k) {
    const double t = k * step, f = std::exp(kPi / 2 * std::sinh(t));
    if (f > 0 && std::isfinite(f)) sum += g(f) * f * kPi / 2 * std::cosh(t) * step;
  }
  return sum;
}

TEST(Spectrum, VarianceIsTheIntegralOverThePlane) {
  for (const char* text : {"abc(a=0.01, b=5, c=3)", "abc(a=2, b=0.4, c=4.5)", "gaussian(rms=0.2, correlation=3)",
                           "sum(abc(a=0.01, b=5, c=3), gaussian(rms=0.2, correlation=3))"}) {
    const SpectrumPointer spectrum = makeSpectrum(text);
    const double integral = overHalfLine([&](double f) { return 2 * kPi * f * spectrum->psd(f, 0); });
    EXPECT_NEAR(integral, spectrum->variance(), 1e-10 * spectrum->variance()) << text;
  }
}

TEST(Spectrum, AutocovarianceOfAFractalIsTheFourierTransform) {
  // 2 pi integral of f PSD J0(2 pi f r), by Simpson's rule on a fine grid up to 400/um; beyond it the power law, by
  // parts: its first term is -f^(1 - n) J1(2 pi f r) / (2 pi r).
  for (const double exponent : {2.3, 3.7}) {
    const SpectrumPointer spectrum = fractalSpectrum(0.02, exponent, 0.25);
    for (const double r : {0.05, 0.4, 11.0}) {
      const double end = 400;
      const int steps = 192'000;  // the corner is between two parabolas
      double sum = 0;
      for (int k = 0; k <= steps; ++k) {
        const double f = end * k / steps, weight = k == 0 || k == steps ? 1 : (k % 2 ? 4 : 2);
        sum += weight * 2 * kPi * f * spectrum->psd(f, 0) * std::cyl_bessel_j(0, 2 * kPi * f * r);
      }
      sum *= end / (3.0 * steps);
      sum -= 0.02 * std::pow(end, 1 - exponent) * std::cyl_bessel_j(1, 2 * kPi * end * r) / r;
      EXPECT_NEAR(spectrum->autocovariance(r, 0), sum, 1e-6 * spectrum->variance()) << exponent << " " << r;
    }
    EXPECT_DOUBLE_EQ(spectrum->autocovariance(0, 0), spectrum->variance());
    EXPECT_NEAR(spectrum->autocovariance(0, 1e-12), spectrum->variance(), 1e-3 * spectrum->variance());
  }
  EXPECT_THROW(fractalSpectrum(1, 3, 0)->autocovariance(1, 0), Error);
  EXPECT_THROW(fractalSpectrum(1, 2, 1)->autocovariance(1, 0), Error);
}

TEST(Spectrum, AutocovarianceIsTheFourierTransform) {
  // The inverse transform, PSD(f) = 2 pi integral of C(r) J0(2 pi f r) r dr: here C falls exponentially.
  for (const char* text : {"abc(a=0.01, b=5, c=3)", "abc(a=2, b=0.4, c=4.5)", "gaussian(rms=0.2, correlation=3)"}) {
    const SpectrumPointer spectrum = makeSpectrum(text);
    for (const double f : {0.0, 0.01, 0.1, 0.3}) {
      const double transform = overHalfLine([&](double r) {
        return r > 200 ? 0 : 2 * kPi * r * spectrum->autocovariance(0, r) * std::cyl_bessel_j(0, 2 * kPi * f * r);
      });
      EXPECT_NEAR(transform, spectrum->psd(f, 0), 1e-8 * spectrum->psd(0, 0)) << text << " " << f;
    }
    EXPECT_EQ(spectrum->autocovariance(0, 0), spectrum->variance());
    EXPECT_EQ(spectrum->autocovariance(1e9, 0), 0);
  }
  // c = 3 is an exponential: variance exp(-2 pi r / b).
  const SpectrumPointer exponential = abcSpectrum(0.01, 5, 3);
  for (const double r : {1e-9, 1e-3, 0.1, 1.0, 10.0})
    EXPECT_NEAR(exponential->autocovariance(r, 0), exponential->variance() * std::exp(-2 * kPi * r / 5),
                1e-12 * exponential->variance());
}

TEST(Spectrum, GaussianMayDifferAlongXAndY) {
  const SpectrumPointer spectrum = makeSpectrum("gaussian(rms=0.1, correlation=2, correlation_y=0.5)");
  EXPECT_FALSE(spectrum->isotropic());
  EXPECT_DOUBLE_EQ(spectrum->psd(0, 0), kPi * 0.01);
  EXPECT_DOUBLE_EQ(spectrum->psd(0.1, 0) / spectrum->psd(0, 0), std::exp(-std::pow(kPi * 0.2, 2)));
  EXPECT_DOUBLE_EQ(spectrum->autocovariance(0, 0.5), 0.01 * std::exp(-1.0));
  EXPECT_TRUE(makeSpectrum("gaussian(rms=0.1, correlation=2)")->isotropic());
}

TEST(Spectrum, FractalHasAVarianceWithACornerOnly) {
  const SpectrumPointer spectrum = makeSpectrum("fractal(a=0.01, exponent=2.5, corner=0)");
  EXPECT_DOUBLE_EQ(spectrum->psd(3, 4), 0.01 * std::pow(5, -2.5));
  EXPECT_TRUE(std::isinf(spectrum->variance()));
  EXPECT_TRUE(std::isinf(spectrum->psd(0, 0)));
  EXPECT_THROW(spectrum->autocovariance(1, 0), Error);
  EXPECT_TRUE(std::isinf(abcSpectrum(0.01, 5, 2)->variance()));
  const SpectrumPointer cornered = makeSpectrum("fractal(a=0.01, exponent=3.5, corner=0.1)");
  EXPECT_EQ(cornered->psd(0, 0), cornered->psd(0.06, 0.08));
  EXPECT_EQ(cornered->psd(3, 4), makeSpectrum("fractal(a=0.01, exponent=3.5, corner=0)")->psd(3, 4));
  const double integral = overHalfLine([&](double f) { return 2 * kPi * f * cornered->psd(f, 0); });
  EXPECT_NEAR(integral, cornered->variance(), 1e-3 * cornered->variance());  // the corner spoils the rule's convergence
}

TEST(Spectrum, DescriptionReadsBack) {
  for (const char* text :
       {"abc(a=0.01, b=5, c=3)", "gaussian(rms=0.2, correlation=3, correlation_y=1)",
        "fractal(a=0.01, exponent=2.5, corner=0.1)", "sum(abc(a=1, b=2, c=3), fractal(a=1, exponent=2, corner=0))"})
    EXPECT_EQ(makeSpectrum(text)->description(), text);
}

TEST(Spectrum, ErrorsNameColumnAndNearest) {
  try {
    makeSpectrum("abc(a=1, bb=2)");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "spectrum, column 10: unknown parameter of abc; found 'bb'; allowed: a, b, c (did you mean b?)");
  }
  EXPECT_THROW(makeSpectrum("gausian(rms=1)"), Error);
  EXPECT_THROW(makeSpectrum("gaussian(rms=-1)"), Error);
  EXPECT_THROW(makeSpectrum("gaussian(rms=nan)"), Error);
  EXPECT_THROW(makeSpectrum("sum()"), Error);
}

}  // namespace
}  // namespace brdf
