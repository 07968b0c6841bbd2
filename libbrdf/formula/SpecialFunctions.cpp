#include <brdf/formula/SpecialFunctions.h>

#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>
#include <limits>

namespace brdf::formula {
namespace {

/// Overflow, poles and lost iterations give infinity or NaN, as in every other operation, instead of an exception.
namespace policies = boost::math::policies;
using Quiet =
    policies::policy<policies::domain_error<policies::ignore_error>, policies::pole_error<policies::ignore_error>,
                     policies::overflow_error<policies::ignore_error>,
                     policies::evaluation_error<policies::ignore_error>>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool isDefined(double a, double x) { return a > 0 && x >= 0 && std::isfinite(a); }

/// sum of x^n/((a+1)...(a+n)) over n >= 0, and its derivative with respect to a.
void powerSeries(double a, double x, double& sum, double& slope) {
  double term = 1, harmonic = 0;
  sum = 1;
  slope = 0;
  for (int n = 1; n < 100'000; ++n) {
    term *= x / (a + n);
    harmonic += 1 / (a + n);
    sum += term;
    slope -= term * harmonic;
    if (term * (1 + harmonic) < 1e-17 * sum) return;
  }
}

/// The continued fraction 1/(x + 1 - a - 1 (1 - a)/(x + 3 - a - 2 (2 - a)/(x + 5 - a - ...))) and its derivative with
/// respect to a, by Lentz's method on numbers that carry their derivative.
void continuedFraction(double a, double x, double& value, double& slope) {
  struct Dual {
    double v, d;
    Dual inverse() const { return {1 / v, -d / (v * v)}; }
    Dual operator*(const Dual& o) const { return {v * o.v, d * o.v + v * o.d}; }
    Dual operator+(const Dual& o) const { return {v + o.v, d + o.d}; }
  };
  Dual b{x + 1 - a, -1}, d = b.inverse(), c{1e300, 0}, h = d;
  for (int n = 1; n < 100'000; ++n) {
    const Dual level{-n * (n - a), static_cast<double>(n)};
    b = b + Dual{2, 0};
    d = (level * d + b).inverse();
    c = b + level * c.inverse();
    const Dual step = c * d;
    h = h * step;
    if (std::fabs(step.v - 1) < 1e-16 && std::fabs(step.d) < 1e-16 * (1 + std::fabs(h.d / h.v))) break;
  }
  value = h.v;
  slope = h.d;
}

}  // namespace

double gammaP(double a, double x) {
  if (!isDefined(a, x)) return kNan;
  return x == kInfinity ? 1 : boost::math::gamma_p(a, x, Quiet{});
}

double gammaQ(double a, double x) {
  if (!isDefined(a, x)) return kNan;
  return x == kInfinity ? 0 : boost::math::gamma_q(a, x, Quiet{});
}

double gammaPDa(double a, double x) {
  if (!isDefined(a, x)) return kNan;
  if (x == 0 || x == kInfinity) return 0;
  // x^a exp(-x)/Gamma(a + 1), by logarithms where a is too small for the quotient of a product that vanishes with it.
  const double factor = a < 1 ? std::exp(a * std::log(x) - x - boost::math::lgamma(a + 1, Quiet{}))
                              : x / a * boost::math::gamma_p_derivative(a, x, Quiet{});
  if (factor == 0) return 0;
  const double logarithm = std::log(x) - boost::math::digamma(a + 1, Quiet{});
  double value = 0, slope = 0;
  if (x < a + 1) {
    powerSeries(a, x, value, slope);
    return factor * (value * logarithm + slope);
  }
  continuedFraction(a, x, value, slope);
  return -factor * (a * (value * logarithm + slope) + value);
}

double trigamma(double x) { return x > 0 ? boost::math::trigamma(x, Quiet{}) : kNan; }

double besselJ0(double x) {
  if (std::isinf(x)) return 0;
  return std::isnan(x) ? x : boost::math::cyl_bessel_j(0, x, Quiet{});
}

double besselJ1(double x) {
  if (std::isinf(x)) return 0;
  return std::isnan(x) ? x : boost::math::cyl_bessel_j(1, x, Quiet{});
}

double besselI0(double x) {
  if (std::isinf(x)) return kInfinity;
  return std::isnan(x) ? x : boost::math::cyl_bessel_i(0, x, Quiet{});
}

double besselI1(double x) {
  if (std::isinf(x)) return x;
  return std::isnan(x) ? x : boost::math::cyl_bessel_i(1, x, Quiet{});
}

double besselK0(double x) {
  if (!(x >= 0)) return kNan;
  return x == 0 ? kInfinity : x == kInfinity ? 0 : boost::math::cyl_bessel_k(0, x, Quiet{});
}

double besselK1(double x) {
  if (!(x >= 0)) return kNan;
  return x == 0 ? kInfinity : x == kInfinity ? 0 : boost::math::cyl_bessel_k(1, x, Quiet{});
}

}  // namespace brdf::formula
