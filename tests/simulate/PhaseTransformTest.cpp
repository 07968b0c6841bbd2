#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/MeasuredSpectrum.h>
#include <brdf/simulate/wave/Renormalization.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "SurfaceSupport.h"
#include "WaveSupport.h"

namespace brdf {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kWavelength = 0.008;  // um: frequencies to 250/um, kappa to 1571/um
double square(double x) { return x * x; }

wave::PhaseTransformPointer transformOf(std::string_view spectrum) {
  return wave::PhaseTransform::of(makeSpectrum(spectrum), kWavelength);
}
double at(const wave::PhaseTransform& transform, double kappa, double f, double fy = 0) {
  double phi = 0;
  transform.evaluate(&kappa, &f, &fy, &phi, 1);
  return phi;
}
/// At g = kappa^2 variance.
double atG(const wave::PhaseTransform& transform, const Spectrum& spectrum, double g, double f) {
  return at(transform, std::sqrt(g / spectrum.variance()), f);
}

TEST(PhaseTransform, GaussianSeriesIsTheIntegral) {
  // 2 pi times the integral of r [exp(-g (1 - rho)) - exp(-g)] J0(2 pi f r), by the trapezoidal rule in exp(r).
  const SpectrumPointer spectrum = gaussianSpectrum(0.3, 1.7, 1.7);
  const auto transform = wave::PhaseTransform::of(spectrum, kWavelength);
  for (const double g : {1e-8, 0.1, 3.0, 60.0, 2000.0})
    for (const double f : {0.0, 0.1, 0.5, 1.0}) {
      const double step = 1e-3;
      double integral = 2 * kPi * (1 - std::exp(-g)) * step * step / 12;  // Euler and Maclaurin's term at r = 0
      for (double r = step; r < 12; r += step)
        integral += 2 * kPi * r * (std::exp(g * std::expm1(-square(r / 1.7))) - std::exp(-g)) *
                    std::cyl_bessel_j(0, 2 * kPi * f * r) * step;
      EXPECT_NEAR(atG(*transform, *spectrum, g, f), integral, 2e-6 * atG(*transform, *spectrum, g, 0)) << g << " " << f;
    }
}

TEST(PhaseTransform, GaussianSeriesIsItsSum) {
  // Beckmann's series term by term: pi L^2 exp(-g) sum of g^m/(m! m) exp(-(pi L f)^2/m).
  const auto transform = transformOf("gaussian(rms=1, correlation=1)");
  for (const double g : {1e-3, 2.0, 90.0, 399.0, 700.0, 4000.0})
    for (const double f : {0.0, 0.7, 5.0, 12.0}) {
      long double sum = 0;
      for (int m = 1; m < 8000; ++m)
        sum += std::exp(m * std::log(static_cast<long double>(g)) - std::lgamma(m + 1.0L) - g -
                        static_cast<long double>(square(kPi * f)) / m) /
               m;
      EXPECT_NEAR(at(*transform, std::sqrt(g), f) / (kPi * static_cast<double>(sum)), 1, 1e-11) << g << " " << f;
    }
}

TEST(PhaseTransform, SeriesMeetsItsIntegralWhereTheMethodChanges) {
  const auto transform = transformOf("gaussian(rms=1, correlation=1)");
  const auto atHeight = [&](double g, double f) { return at(*transform, std::sqrt(g), f); };
  // Smooth across the change at 400 terms, and geometrical optics far beyond: pi/g exp(-pi^2 f^2/g), relative error
  // 1/g.
  for (const double f : {0.0, 1.0, 6.0})
    EXPECT_NEAR(atHeight(399.0, f) * atHeight(405.0, f) / square(atHeight(402.0, f)), 1, 2e-4) << f;
  for (const double g : {1e6, 1e10, 1e16})
    for (const double share : {0.0, 0.5, 3.0}) {
      const double f = std::sqrt(share * g) / kPi;
      EXPECT_NEAR(atHeight(g, f) / (kPi / g * std::exp(-share)), 1, 20 / g + 1e-9) << g << " " << share;
    }
  EXPECT_EQ(atHeight(0, 1), 0);
}

TEST(PhaseTransform, IsItsQuadrature) {
  // tests/reference/phase_transform.csv: computed by phase_transform.py beside it, which uses nothing of ours.
  std::istringstream rows(readFile(std::filesystem::path(BRDF_SOURCE_DIR) / "tests/reference/phase_transform.csv"));
  std::string line;
  std::getline(rows, line);
  std::size_t count = 0;
  std::map<std::string, wave::PhaseTransformPointer> transforms;
  while (std::getline(rows, line)) {
    const std::size_t end = line.find('"', 1);
    const std::string expression = line.substr(1, end - 1);
    double g = 0, f = 0, phi = 0;
    ASSERT_EQ(std::sscanf(line.c_str() + end + 1, ",%lf,%lf,%lf", &g, &f, &phi), 3) << line;
    auto& transform = transforms[expression];
    if (!transform) transform = transformOf(expression);
    const double ours = atG(*transform, *makeSpectrum(expression), g, f);
    const double share = phi / atG(*transform, *makeSpectrum(expression), g, 0);
    EXPECT_NEAR(ours / phi, 1, share > 1e-3 ? 2e-5 : share > 1e-8 ? 2e-4 : 1e-3) << line;
    ++count;
  }
  EXPECT_GT(count, 100u);
}

TEST(PhaseTransform, ExponentialAutocovarianceIsItsSeries) {
  // abc of c = 3 has rho = exp(-r/L), L = b / (2 pi); rho^n has the transform 2 pi L^2 n / (n^2 + (2 pi f L)^2)^(3/2).
  const double b = 5, length = b / (2 * kPi);
  const SpectrumPointer spectrum = abcSpectrum(0.01, b, 3);
  const auto transform = wave::PhaseTransform::of(spectrum, kWavelength);
  for (const double g : {1e-6, 1e-3, 0.2, 1.0, 7.0, 50.0, 400.0})
    for (const double f : {0.0, 1e-4, 0.01, 0.1, 1.0, 7.0, 40.0}) {
      double sum = 0;
      for (int n = 1; n < 3000; ++n)
        sum += std::exp(n * std::log(g) - std::lgamma(n + 1.0) - g) * 2 * kPi * square(length) * n *
               std::pow(square(n) + square(2 * kPi * f * length), -1.5);
      EXPECT_NEAR(atG(*transform, *spectrum, g, f) / sum, 1, 1e-5) << g << " " << f;
    }
}

TEST(PhaseTransform, TableAgreesWithTheGaussianSeries) {
  // A sum of one Gaussian goes the way of any isotropic spectrum.
  const SpectrumPointer spectrum = gaussianSpectrum(0.1, 0.5, 0.5);
  const auto exact = wave::PhaseTransform::of(spectrum, kWavelength);
  const auto table = wave::PhaseTransform::of(sumOfSpectra({spectrum}), kWavelength);
  for (const double g : {1e-5, 0.03, 1.0, 25.0, 600.0}) {
    const double peak = atG(*exact, *spectrum, g, 0);
    for (double f = 0.003; f < 40; f *= 1.3) {
      const double phi = atG(*exact, *spectrum, g, f);
      EXPECT_NEAR(atG(*table, *spectrum, g, f), phi,
                  phi > 1e-3 * peak   ? 2e-5 * phi
                  : phi > 1e-8 * peak ? 2e-4 * phi
                                      : std::max(1e-3 * phi, 1e-12 * peak))
          << g << " " << f;
    }
  }
}

TEST(PhaseTransform, HoldsWhatLeavesTheMirror) {
  // The integral over all frequencies is the integrand at r = 0: 1 - exp(-g).
  struct Case {
    const char* expression;
    double exponent;  // of the tail
  };
  for (const auto& [expression, exponent] :
       {Case{"abc(a=0.01, b=5, c=4)", 4}, Case{"fractal(a=0.001, exponent=3.5, corner=0.1)", 3.5},
        Case{"gaussian(rms=0.1, correlation=2)", 9},
        Case{"measured(surface=gaussian(rms=0.05, correlation=1, seed=3), average=radial)", 9}}) {
    const SpectrumPointer spectrum = makeSpectrum(expression);
    const auto transform = wave::PhaseTransform::of(spectrum, kWavelength);
    for (const double g : {0.01, 1.0, 20.0}) {
      double sum = 0;
      const double step = 2e-3, end = 130;
      for (double t = std::log(end); t > std::log(1e-5); t -= step)
        sum += 2 * kPi * std::exp(2 * t - step) * atG(*transform, *spectrum, g, std::exp(t - step / 2)) * step;
      // Beyond: g PSD / variance of the power laws.
      const double beyond = 2 * kPi * square(end) / (exponent - 2) * g * spectrum->psd(end, 0) / spectrum->variance();
      EXPECT_NEAR((sum + beyond) / -std::expm1(-g), 1, 2e-4) << expression << " " << g;
    }
  }
}

TEST(PhaseTransform, SmallHeightsScatterTheirSpectrum) {
  for (const char* expression :
       {"abc(a=0.01, b=5, c=2.5)", "fractal(a=0.001, exponent=3, corner=0.1)",
        "fractal(a=1e-4, exponent=2.5, corner=0)", "measured(surface=gaussian(rms=0.05, correlation=1), average=none)",
        "measured(surface=gaussian(rms=0.05, correlation=1), average=radial)"}) {
    const SpectrumPointer spectrum = makeSpectrum(expression);
    const auto transform = wave::PhaseTransform::of(spectrum, 0.5);
    const double kappa = 1e-5;
    for (const double f : {0.02, 0.3, 0.5})
      EXPECT_NEAR(at(*transform, kappa, f) / (kappa * kappa * spectrum->psd(f, 0)), 1, 1e-6) << expression << f;
  }
}

TEST(PhaseTransform, PowerLawsAreStable) {
  // Exponent 3: exp(-r/R) of R = 1/(kappa^2 4 pi^2 a), whose transform is 2 pi R^2 / (1 + (2 pi f R)^2)^(3/2).
  const double a = 1e-3;
  const auto cauchy = wave::PhaseTransform::of(fractalSpectrum(a, 3, 0), kWavelength);
  for (const double kappa : {0.3, 5.0, 200.0})
    for (const double f : {0.0, 1e-3, 0.1, 2.0, 40.0}) {
      const double reach = 1 / (kappa * kappa * 4 * kPi * kPi * a);
      const double exact = 2 * kPi * square(reach) * std::pow(1 + square(2 * kPi * f * reach), -1.5);
      EXPECT_NEAR(at(*cauchy, kappa, f) / exact, 1, 1e-6) << kappa << " " << f;
    }
  // Any exponent: all of the light, and the same law from a corner far below (whose variance is finite).
  for (const double exponent : {2.3, 2.5, 3.4, 3.9}) {
    const auto stable = wave::PhaseTransform::of(fractalSpectrum(a, exponent, 0), kWavelength);
    const double kappa = 30;
    double sum = 0;
    const double step = 1e-2;
    for (double t = std::log(1e-30); t < std::log(1e25); t += step)
      sum += 2 * kPi * std::exp(2 * t) * at(*stable, kappa, std::exp(t)) * step;
    EXPECT_NEAR(sum, 1, 1e-5) << exponent;
  }
  const auto stable = wave::PhaseTransform::of(fractalSpectrum(a, 2.5, 0), kWavelength);
  const auto cornered = wave::PhaseTransform::of(fractalSpectrum(a, 2.5, 1e-9), kWavelength);
  for (const double f : {0.5, 5.0, 30.0}) EXPECT_NEAR(at(*cornered, 20, f) / at(*stable, 20, f), 1, 1e-4) << f;
}

TEST(PhaseTransform, CellsOfOneWaveAreBesselFunctions) {
  // Heights A cos(2 pi (3 x / X + 2 y / Y)): rho is that cosine, and exp(g cos) a series of Bessel functions I_n (DLMF
  // 10.35.2): order n scatters exp(-g) I_n(g) into the cell of n times its frequency, X Y in area of frequencies 1/(X
  // Y).
  HeightField field{32, 24, 0.5, 0.25, {}};
  for (std::size_t j = 0; j < 24; ++j)
    for (std::size_t i = 0; i < 32; ++i)
      field.heights.push_back(static_cast<float>(
          0.2 * std::cos(2 * kPi * (3 * static_cast<double>(i) / 32 + 2 * static_cast<double>(j) / 24))));
  const SpectrumPointer spectrum = measuredSpectrum(field, SpectrumWindow::None, false);
  const auto transform = wave::PhaseTransform::of(spectrum, 0.2);
  const double area = field.periodX() * field.periodY();
  for (const double g : {0.01, 0.7, 5.0, 30.0})
    for (const int order : {1, -1, 2, 5, 9}) {
      const double kappa = std::sqrt(g / spectrum->variance());
      const double phi = at(*transform, kappa, 3 * order / field.periodX(), 2 * order / field.periodY());
      const double exact = area * std::exp(-g) * std::cyl_bessel_i(std::abs(order), g);
      EXPECT_NEAR(phi / area, exact / area, 1e-3 * exact / area + 1e-7) << g << " " << order;
      EXPECT_NEAR(at(*transform, kappa, (3 * order + 1) / field.periodX(), 2 * order / field.periodY()) / area, 0,
                  1e-9);
    }
}

TEST(PhaseTransform, CellsHoldWhatLeavesTheMirror) {
  const HeightField field = heightField("gaussian(rms=0.04, correlation=1, period=16, resolution=4, seed=7)");
  const SpectrumPointer spectrum = measuredSpectrum(field, SpectrumWindow::None, false);
  const auto transform = wave::PhaseTransform::of(spectrum, 0.2);
  for (const double g : {0.05, 1.0, 6.0}) {
    double sum = 0;
    for (int m = -200; m <= 200; ++m)
      for (int n = -200; n <= 200; ++n)
        if (std::hypot(m, n) / 16 <= 10)
          sum += at(*transform, std::sqrt(g / spectrum->variance()), m / 16.0, n / 16.0) / 256;
    // The transform of rho^2 and higher powers at f = 0 belongs to it: nothing of 1 - exp(-g) is missing.
    EXPECT_NEAR(sum / -std::expm1(-g), 1, 1e-3) << g;
  }
}

TEST(PhaseTransform, RefusesSpectraItCannotTransform) {
  for (const char* wrong :
       {"HarveyShack(spectrum=abc(c=2))", "HarveyShack(spectrum=fractal(exponent=2))",
        "HarveyShack(spectrum=fractal(exponent=2, corner=0))", "HarveyShack(spectrum=fractal(exponent=4, corner=0))",
        "BeckmannKirchhoff(spectrum=abc(c=2))", "BeckmannKirchhoff(spectrum=abc(a=1e12, b=1, c=3))",
        "HarveyShack(spectrum=sum(gaussian(correlation=1, correlation_y=2), abc(c=3)))",
        "HarveyShack(spectrum=fractal(corner=0, exponent=3), roughness=relevant)",
        "HarveyShack(spectrum=gaussian(correlation=1, correlation_y=2), energy=renormalized)",
        "HarveyShack(spectrum=measured(surface=gaussian(rms=90, correlation=1, period=1000, resolution=2), "
        "average=none))"})
    EXPECT_THROW(makeWaveBrdf(wrong), Error) << wrong;
}

TEST(PhaseTransform, IsFiniteAtExtremes) {
  for (const char* expression :
       {"abc(a=1e-20, b=1e9, c=2.05)", "abc(a=1e6, b=1000, c=2.05)", "abc(a=1, b=1000, c=60)", "abc(a=0, b=1, c=3)",
        "fractal(a=0, corner=0)", "fractal(a=1e-4, exponent=90, corner=1)", "fractal(a=1e12, exponent=2.02, corner=0)",
        "fractal(a=1e-12, exponent=3.99, corner=0)", "fractal(a=1e-9, exponent=2.05, corner=1e-6)"}) {
    const auto transform = wave::PhaseTransform::of(makeSpectrum(expression), 0.5);
    for (const double kappa : {0.0, 1e-300, 1e-9, 1e-3, 1.0, 8 * kPi})
      for (const double f : {0.0, 1e-300, 1e-9, 1e-3, 1.0, 4.0}) {
        const double phi = at(*transform, kappa, f);
        EXPECT_TRUE(std::isfinite(phi) && phi >= 0) << expression << " " << kappa << " " << f << " " << phi;
      }
  }
}

TEST(Renormalization, KeepsWhatIsNotReflected) {
  // K is what makes the integral of Phi / wavelength^2 over direction cosines 1 - exp(-g): here by another rule.
  for (const char* expression :
       {"gaussian(rms=0.15, correlation=0.7)", "abc(a=0.01, b=3, c=3)", "fractal(a=2e-3, exponent=3, corner=0)"}) {
    const SpectrumPointer spectrum = makeSpectrum(expression);
    const auto transform = wave::PhaseTransform::of(spectrum, 0.5);
    const wave::Renormalization normal(spectrum, transform, 0.5, {false, true});
    for (const double theta : {0.0, 20.0, 63.0, 85.0}) {
      const std::array<double, 3> wi = directionOf(theta, 180);
      const double integral = hemisphereIntegral(
          [&](const std::array<double, 3>& wo) {
            return at(*transform, 4 * kPi * (wi[2] + wo[2]), (wi[0] + wo[0]) / 0.5, (wi[1] + wo[1]) / 0.5) / 0.25;
          },
          600, 400);
      const double g = square(8 * kPi * wi[2]) * spectrum->variance();
      EXPECT_NEAR(normal.factor(wi[2]) * integral, std::isfinite(g) ? -std::expm1(-g) : 1, 4e-3)
          << expression << " " << theta;
    }
  }
}

TEST(Renormalization, RelevantRoughnessIsTheSpectrumInItsDisk) {
  const double wavelength = 0.5;
  for (const char* expression : {"abc(a=0.01, b=3, c=3)", "gaussian(rms=0.1, correlation=0.2)"}) {
    const SpectrumPointer spectrum = makeSpectrum(expression);
    const wave::Renormalization normal(spectrum, wave::PhaseTransform::of(spectrum, wavelength), wavelength,
                                       {true, false});
    for (const double theta : {0.0, 30.0, 70.0, 89.0}) {
      const double sine = std::sin(theta * kDegree);
      // Midpoints of a square grid; the spectrum's peak is many steps wide.
      const int steps = 2000;
      double sum = 0;
      for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
          const double x = 2 * (i + 0.5) / steps - 1, y = 2 * (j + 0.5) / steps - 1;
          if (x * x + y * y < 1) sum += spectrum->psd((x + sine) / wavelength, y / wavelength);
        }
      sum *= square(2 / (steps * wavelength));
      EXPECT_NEAR(square(normal.relevantShare(std::cos(theta * kDegree))) * spectrum->variance() / sum, 1, 2e-3)
          << expression << " " << theta;
    }
    EXPECT_DOUBLE_EQ(normal.factor(0.5), 1);
  }
}

TEST(HarveyShack, OptionsChangeWhatTheySay) {
  const PairOfDirections pair(40, 55, 30), back(55, 40, -30);
  const std::string surface = "HarveyShack(wavelength=0.5, eta=1, k=6, spectrum=abc(a=0.01, b=3, c=2.5)";
  const auto plain = makeWaveBrdf(surface + ")"),
             both = makeWaveBrdf(surface + ", roughness=relevant, energy=renormalized)");
  EXPECT_TRUE(plain->reciprocal());
  EXPECT_FALSE(both->reciprocal());
  const SpectrumPointer spectrum = abcSpectrum(0.01, 3, 2.5);
  const auto transform = wave::PhaseTransform::of(spectrum, 0.5);
  const wave::Renormalization normal(spectrum, transform, 0.5, {true, true});
  const double kappa = 4 * kPi * (pair.wi[2] + pair.wo[2]);
  const double f = std::hypot(pair.wi[0] + pair.wo[0], pair.wi[1] + pair.wo[1]) / 0.5;
  EXPECT_NEAR(valueOf(*both, pair) / valueOf(*plain, pair),
              normal.factor(pair.wi[2]) * at(*transform, kappa * normal.relevantShare(pair.wi[2]), f) /
                  at(*transform, kappa, f),
              1e-12);
  EXPECT_NEAR(
      std::log(both->models()[0]->specular(0.7) / plain->models()[0]->specular(0.7)),
      square(8 * kPi * std::cos(0.7)) * spectrum->variance() * (1 - square(normal.relevantShare(std::cos(0.7)))), 1e-9);
}

}  // namespace
}  // namespace brdf
