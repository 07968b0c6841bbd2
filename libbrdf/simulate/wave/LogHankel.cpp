#include <brdf/simulate/wave/LogHankel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace brdf::wave {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;
constexpr double kBias = 0.75;

/// ln Gamma(z) for Re z > 0: the recurrence up to |z| >= 12, then Stirling's series (DLMF 5.11.1).
Complex logGamma(Complex z) {
  Complex shift = 0;
  while (std::abs(z) < 12) {
    shift += std::log(z);
    z += 1.0;
  }
  const Complex w = 1.0 / (z * z);
  const Complex series =
      (1 / 12.0 + w * (-1 / 360.0 + w * (1 / 1260.0 + w * (-1 / 1680.0 + w * (1 / 1188.0 - w * 691.0 / 360360.0))))) /
      z;
  return (z - 0.5) * std::log(z) - z + 0.5 * std::log(2 * kPi) + series - shift;
}

}  // namespace

LogHankel::LogHankel(double first, double step, std::size_t count) {
  const auto number = static_cast<double>(count);
  const double last = std::log(first) + step * (number - 1);
  for (std::size_t j = 0; j < count; ++j) {
    const double r = first * std::exp(step * static_cast<double>(j));
    const double k = std::exp(-last + step * static_cast<double>(j));
    distances_.push_back(r);
    frequencies_.push_back(k / (2 * kPi));
    bias_.push_back(std::pow(r, kBias));
    unbias_.push_back(2 * kPi / number * std::pow(k, kBias - 2));
  }
  // k^(2 - b) F/(2 pi) = integral of r^b a(r) (k r)^(2 - b) J0(k r) d ln r.
  const double origin = std::log(first) - last;
  for (std::size_t j = 0; j < count; ++j) {
    const double index = static_cast<double>(j) - (j > count / 2 ? number : 0);
    const double omega = 2 * kPi * index / (number * step);
    const Complex mu(2 - kBias, omega);
    Complex u = std::exp((mu - 1.0) * std::log(2.0) + logGamma(mu / 2.0) - logGamma(1.0 - mu / 2.0) -
                         Complex(0, omega * origin));
    if (2 * j == count) u = u.real();
    multiplier_.push_back(u);
  }
}

std::vector<double> LogHankel::transform(const std::vector<double>& values) const {
  Eigen::FFT<double> fft;
  std::vector<Complex> line(values.size()), spectrum(values.size());
  for (std::size_t j = 0; j < values.size(); ++j) line[j] = bias_[j] * values[j];
  fft.fwd(spectrum, line);
  for (std::size_t j = 0; j < values.size(); ++j) spectrum[j] *= multiplier_[j];
  fft.fwd(line, spectrum);
  std::vector<double> result(values.size());
  for (std::size_t j = 0; j < values.size(); ++j) result[j] = line[j].real() * unbias_[j];
  return result;
}

std::vector<double> LogHankel::rounding(const std::vector<double>& values) const {
  double largest = 0;
  for (std::size_t j = 0; j < values.size(); ++j) largest = std::max(largest, bias_[j] * std::abs(values[j]));
  std::vector<double> result(values.size());
  const double scale = largest * std::numeric_limits<double>::epsilon() * static_cast<double>(values.size());
  for (std::size_t j = 0; j < values.size(); ++j) result[j] = scale * unbias_[j];
  return result;
}

}  // namespace brdf::wave
