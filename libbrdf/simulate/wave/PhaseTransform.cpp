#include <brdf/base/Error.h>
#include <brdf/simulate/wave/PhaseTransform.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdf::wave {
namespace {

constexpr double kPi = std::numbers::pi;

/// (1 + d) ln(1 + d) - d without cancellation near d = 0.
double entropyExcess(double d) {
  if (std::abs(d) > 0.05) return (1 + d) * std::log1p(d) - d;
  double sum = 0, power = d * d;
  for (int k = 2; k <= 14; ++k) {
    sum += (k % 2 ? -power : power) / (k * (k - 1));
    power *= d;
  }
  return sum;
}

/// The logarithm of exp(-g) g^m / (m! m) exp(-a/m), m >= 1 not necessarily whole.
double logTerm(double g, double a, double m) {
  if (m < 64) return m * std::log(g) - g - std::lgamma(m + 1) - std::log(m) - a / m;
  const double stirling = 1 / (12 * m) - 1 / (360 * m * m * m);
  return -g * entropyExcess((m - g) / g) - stirling - 0.5 * std::log(2 * kPi * m) - std::log(m) - a / m;
}

/// Where the terms are largest: ln(g/m) + a/m^2 = 1/m + 1/(2m) falls in m.
double largestTerm(double g, double a) {
  const auto slope = [&](double m) { return std::log(g / m) + a / (m * m) - 1.5 / m; };
  if (slope(1) <= 0) return 1;
  double low = 1, high = 2 * std::max({g, std::sqrt(a), 2.0});
  while (slope(high) > 0) high *= 2;
  // To a hundredth of the width of the bell, which is at most sqrt(m).
  for (int k = 0; k < 200 && high - low > 0.01 * std::sqrt(low) / (1 + std::sqrt(2 * a) / low); ++k) {
    const double middle = low + (high - low) / 2;
    (slope(middle) > 0 ? low : high) = middle;
  }
  return low + (high - low) / 2;
}

/// Term after term, where none that matters underflows.
double shortSeries(double g, double a) {
  double weight = std::exp(-g), sum = 0;
  for (int m = 1; m < 4000; ++m) {
    weight *= g / m;
    const double term = weight * std::exp(-a / m) / m;
    sum += term;
    // Beyond the largest term, where the next is smaller by g/m exp(a/m^2) at least.
    if (term < 1e-14 * sum && m > 2 * g && a < 0.5 * m * m) break;
  }
  return sum;
}

/// exp(-g) sum over m >= 1 of g^m / (m! m) exp(-a/m): Beckmann's series, from its largest term to both sides.
double beckmannSeries(double g, double a) {
  if (!(g > 0)) return 0;
  if (g < 50 && a < 400) return shortSeries(g, a);
  const double peak = largestTerm(g, a);
  if (peak > 400) {
    // The terms are a smooth bell many terms wide: the sum is its integral, by the trapezoidal rule.
    const double width = 1 / std::sqrt(1 / peak + 2 * a / (peak * peak * peak)), step = width / 3;
    double sum = 0;
    for (int k = -30; k <= 30; ++k) sum += std::exp(logTerm(g, a, peak + k * step));
    return sum * step;
  }
  const double start = std::round(peak), first = logTerm(g, a, start);
  if (first < -745) return 0;
  double up = 1, sum = 1;
  for (double m = start; m < start + 4000; ++m) {
    up *= g / (m + 1) * (m / (m + 1)) * std::exp(a / (m * (m + 1)));
    sum += up;
    if (up < 1e-17 * sum) break;
  }
  double down = 1;
  for (double m = start; m > 1; --m) {
    down *= m / g * (m / (m - 1)) * std::exp(-a / (m * (m - 1)));
    sum += down;
    if (down < 1e-17 * sum) break;
  }
  return sum * std::exp(first);
}

class GaussianTransform : public PhaseTransform {
 public:
  explicit GaussianTransform(const Spectrum::Gaussian& shape) : shape_(shape) {}
  void evaluate(const double* kappa, const double* fx, const double* fy, double* phi,
                std::size_t count) const override {
    const double x = kPi * shape_.correlationX, y = kPi * shape_.correlationY;
    for (std::size_t k = 0; k < count; ++k) {
      const double a = x * x * fx[k] * fx[k] + y * y * fy[k] * fy[k];
      phi[k] = kPi * shape_.correlationX * shape_.correlationY *
               beckmannSeries(kappa[k] * kappa[k] * shape_.rms * shape_.rms, a);
    }
  }

 private:
  Spectrum::Gaussian shape_;
};

}  // namespace

PhaseTransform::~PhaseTransform() = default;

PhaseTransformPointer PhaseTransform::of(const SpectrumPointer& spectrum, double wavelength) {
  if (const auto gaussian = spectrum->gaussian()) return std::make_shared<GaussianTransform>(*gaussian);
  if (spectrum->powerLaw()) return stableTransform(spectrum);
  if (spectrum->cells()) return cellTransform(spectrum, wavelength);
  if (spectrum->isotropic()) return isotropicTransform(spectrum, wavelength);
  throw Error(Error::Kind::Value,
              {"theories of any height do not take this anisotropic spectrum", "wave model", spectrum->description(),
               "isotropic ones, gaussian(...), measured(...), or RayleighRice"});
}

}  // namespace brdf::wave
