#include <brdf/simulate/BesselIntegral.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace brdf {
namespace {

/// By parts, with (t J1)' = t J0 and J0' = -J1: I_m = (m + 1)/x J0 - J1 - ((m + 1)/x)^2 I_(m+2), asymptotic.
double beyondByParts(double m, double x) {
  const double j0 = std::cyl_bessel_j(0.0, x), j1 = std::cyl_bessel_j(1.0, x);
  double sum = 0, factor = 1, least = 1;
  for (int k = 0; k < 60; ++k, m += 2) {
    sum += factor * ((m + 1) / x * j0 - j1);
    factor *= -(m + 1) * (m + 1) / (x * x);
    if (std::abs(factor) >= least || std::abs(factor) < 1e-18 * std::abs(sum)) break;
    least = std::abs(factor);
  }
  return sum;
}

}  // namespace

double besselIntegralBeyond(double m, double x) {
  const double far = 40 + 2 * m;
  if (x >= far) return beyondByParts(m, x);
  // Panels on which neither the power nor the Bessel function changes much; the power makes the rest negligible.
  double sum = 0, start = x;
  while (start < far) {
    const double end = std::min({start * (1 + 2 / (1 + m)), start + 2, far});
    sum += boost::math::quadrature::gauss<double, 15>::integrate(
        [m, x](double t) { return std::pow(x / t, m) * std::cyl_bessel_j(0.0, t); }, start, end);
    start = end;
    if (m > 1 && start * std::pow(x / start, m) < 1e-18 * std::abs(sum)) return sum;
  }
  return sum + std::pow(x / far, m) * beyondByParts(m, far);
}

double besselMoment(double x) {
  if (x < 2) {
    // Sum of (-1)^k x^(2k+3) / (2^(2k+1) k! (k+1)! (2k+3)).
    double power = x * x * x / 2, sum = 0;
    for (int k = 0; k < 20; ++k) {
      sum += power / (2 * k + 3);
      power *= -x * x / (4.0 * (k + 1) * (k + 2));
    }
    return sum;
  }
  if (x >= 40) return 1 - beyondByParts(0, x) - x * std::cyl_bessel_j(0.0, x);
  // The integral of J0 is 2 (J1 + J3 + J5 + ...); J by downward recurrence, with 1 = J0 + 2 J2 + 2 J4 + ...
  double above = 0, here = 1e-300, odd = 0, norm = 0, zeroth = 0;
  for (int order = 2 * static_cast<int>(x / 2 + 15 + x / 4); order > 0; --order) {
    (order % 2 ? odd : norm) += 2 * here;
    const double below = 2 * order / x * here - above;
    above = here;
    here = below;
  }
  zeroth = here;
  return (odd - x * zeroth) / (norm + zeroth);
}

}  // namespace brdf
