#pragma once
#include <cmath>

namespace brdf {

/// Unpolarised reflectance of an interface between two dielectrics: Walter, Marschner, Li, Torrance 2007, "Microfacet
/// models for refraction through rough surfaces", eq. 22, DOI 10.2312/EGWR/EGSR07/195-206. `cosI` in [0, 1] of the
/// angle of incidence, `eta` the index behind the interface over that before it. `cosT` becomes the cosine of the angle
/// of refraction, 0 for total reflection.
inline double dielectricReflectance(double cosI, double eta, double& cosT) {
  const double N = (eta - 1) * (eta + 1), g2 = N + cosI * cosI;
  cosT = 0;
  if (!(g2 > 0)) return N < 0 ? 1.0 : 0.0;  // total reflection; N = 0 at grazing: no interface
  const double g = std::sqrt(g2), s = g + cosI;
  cosT = std::fmin(g / eta, 1.0);
  // g - c = (eta^2 - 1) / (g + c), without cancellation near eta = 1.
  const double difference = N / s, a = difference / s, b = (cosI * s - 1) / (cosI * difference + 1);
  return std::fmin(0.5 * a * a * (1 + b * b), 1.0);
}

/// Unpolarised reflectance of a conductor of the index eta + i k relative to what is before it: with
/// a + i b = sqrt((eta + i k)^2 - sin^2), Rs = ((a - c)^2 + b^2) / ((a + c)^2 + b^2) and
/// Rp = Rs ((a c - s^2)^2 + b^2 c^2) / ((a c + s^2)^2 + b^2 c^2) (Born and Wolf 1999, "Principles of Optics", section
/// 14.2, eqs. 1 to 9, DOI 10.1017/CBO9781139644181; the lobes' F_conductor is the same function). `cosI` in [0, 1].
inline double conductorReflectance(double cosI, double eta, double k) {
  const double s2 = (1 - cosI) * (1 + cosI), t = (eta - k) * (eta + k) - s2, ek = eta * k;
  const double big = 0.5 * (std::hypot(t, 2 * ek) + std::fabs(t));
  const double small = big > 0 ? ek * ek / big : 0;  // of a^2 and b^2, whose product is (eta k)^2
  const double a = std::sqrt(t > 0 ? big : small), b2 = t > 0 ? small : big;
  const auto squared = [](double x) { return x * x; };
  const double rs = (squared(a - cosI) + b2) / (squared(a + cosI) + b2);
  const double below = squared(a * cosI + s2) + b2 * cosI * cosI;
  const double rp = below > 0 ? rs * (squared(a * cosI - s2) + b2 * cosI * cosI) / below : rs;
  return std::fmin(0.5 * (rs + rp), 1.0);
}

}  // namespace brdf
