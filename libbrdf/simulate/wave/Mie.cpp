#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/wave/Mie.h>

#include <cmath>

namespace brdf::wave {
namespace {

void checkSphere(double size, Complex index) {
  if (!(size >= 1e-12 && size <= 1e6))
    throw Error(Error::Kind::Value, {"size parameter 2 pi radius n / wavelength of a sphere out of bounds",
                                     "Mie sphere", formatNumber(size), "[1e-12, 1e6]"});
  if (!(std::abs(index) > 0 && std::abs(index) * size <= 4e6 && index.imag() >= 0))
    throw Error(Error::Kind::Value, {"relative index of a sphere out of bounds", "Mie sphere",
                                     formatNumber(index.real()) + " + " + formatNumber(index.imag()) + " i",
                                     "not 0, absorption not negative, modulus times the size parameter at most 4e6"});
}

/// Beyond the turning point at |z| a downward recurrence forgets its start within a few times |z|^(1/3) steps.
std::size_t startOf(double z, std::size_t terms) {
  return static_cast<std::size_t>(std::max(z, static_cast<double>(terms)) + 10 * std::cbrt(z)) + 30;
}

/// psi_0 .. psi_terms, Riccati-Bessel functions of a real argument.
std::vector<double> riccatiBessel(double x, std::size_t terms) {
  std::vector<double> psi(terms + 1);
  psi[0] = std::sin(x);
  const std::size_t start = startOf(x, terms);
  // ratio[n] = psi_n / psi_(n-1), by psi_(n-1) + psi_(n+1) = (2n + 1)/x psi_n.
  std::vector<double> ratio(terms + 1);
  double above = 0;
  for (std::size_t n = start; n >= 1; --n) {
    above = 1 / ((2 * static_cast<double>(n) + 1) / x - above);
    if (n <= terms) ratio[n] = above;
  }
  double previous = std::cos(x);  // psi_(-1)
  for (std::size_t n = 1; n <= terms; ++n) {
    if (static_cast<double>(n) <= x) {
      psi[n] = (2 * static_cast<double>(n) - 1) / x * psi[n - 1] - previous;
    } else {
      psi[n] = ratio[n] * psi[n - 1];
    }
    previous = psi[n - 1];
  }
  return psi;
}

}  // namespace

MieSphere::MieSphere(double size, Complex index) : size_(size) {
  checkSphere(size, index);
  const double x = size;
  const auto terms = static_cast<std::size_t>(x + 4.05 * std::cbrt(x) + 12);
  const Complex y = index * x;
  std::vector<Complex> derivative(terms + 1);  // D_n(y) = psi_n'(y) / psi_n(y)
  Complex below = 0;
  for (std::size_t n = startOf(std::abs(y), terms); n >= 1; --n) {
    if (n <= terms) derivative[n] = below;
    const Complex ny = static_cast<double>(n) / y;
    below = ny - 1.0 / (below + ny);
  }
  const std::vector<double> psi = riccatiBessel(x, terms);

  double chiPrevious = -std::sin(x), chi = std::cos(x);  // chi_(-1), chi_0
  Complex back = 0;
  double forward = 0, scattered = 0, cosine = 0;
  Complex lastA = 0, lastB = 0;
  for (std::size_t k = 1; k <= terms; ++k) {
    const double n = static_cast<double>(k);
    const double chiNext = (2 * n - 1) / x * chi - chiPrevious;
    chiPrevious = chi;
    chi = chiNext;
    if (!std::isfinite(chi) || std::abs(chi) > 1e150) break;
    const Complex xi(psi[k], -chi), xiPrevious(psi[k - 1], -chiPrevious);
    const Complex u = derivative[k] / index + n / x, v = index * derivative[k] + n / x;
    const Complex a = (u * psi[k] - psi[k - 1]) / (u * xi - xiPrevious);
    const Complex b = (v * psi[k] - psi[k - 1]) / (v * xi - xiPrevious);
    const double weight = 2 * n + 1;
    forward += weight * (a.real() + b.real());
    scattered += weight * (std::norm(a) + std::norm(b));
    back += (k % 2 ? -weight : weight) * (a - b);
    if (k > 1) {
      const double m = n - 1;
      cosine += m * (m + 2) / (m + 1) * (lastA * std::conj(a) + lastB * std::conj(b)).real();
    }
    cosine += (2 * n + 1) / (n * (n + 1)) * (a * std::conj(b)).real();
    lastA = a;
    lastB = b;
    a_.push_back(weight / (n * (n + 1)) * a);
    b_.push_back(weight / (n * (n + 1)) * b);
  }
  const double xx = x * x;
  extinction_ = 2 / xx * forward;
  scattering_ = 2 / xx * scattered;
  backscattering_ = std::norm(back) / xx;
  asymmetry_ = scattered > 0 ? 2 * cosine / scattered : 0;
}

void MieSphere::amplitudes(double cosine, Complex& s1, Complex& s2) const {
  double previous = 0, pi = 1;  // pi_(n-1), pi_n
  s1 = s2 = 0;
  for (std::size_t k = 0; k < a_.size(); ++k) {
    const double n = static_cast<double>(k + 1);
    const double tau = n * cosine * pi - (n + 1) * previous;
    s1 += a_[k] * pi + b_[k] * tau;
    s2 += a_[k] * tau + b_[k] * pi;
    const double next = ((2 * n + 1) * cosine * pi - (n + 1) * previous) / n;
    previous = pi;
    pi = next;
  }
}

}  // namespace brdf::wave
