#pragma once
#include <brdf/brdf_export.h>

#include <array>
#include <cmath>
#include <numbers>

namespace brdf {

using Direction = std::array<double, 3>;  ///< x, y, z; unit length unless said otherwise

constexpr double kPi = std::numbers::pi;
constexpr double radians(double degrees) { return degrees * (kPi / 180); }
constexpr double degrees(double radians) { return radians * (180 / kPi); }

inline double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// `a` scaled to unit length; a zero vector stays zero.
inline Direction normalized(const Direction& a) {
  const double length = std::sqrt(dot(a, a));
  return length > 0 ? Direction{a[0] / length, a[1] / length, a[2] / length} : a;
}

/// The direction at polar angle `theta` from +z and azimuth `phi` from +x (radians). Exact at theta = 0 and with
/// z = 0 at theta = pi/2 as typed (cos(pi/2) in double is 6e-17, which is kept: the horizon itself is theta > pi/2).
inline Direction fromSpherical(double theta, double phi) {
  const double s = std::sin(theta);
  return {s * std::cos(phi), s * std::sin(phi), std::cos(theta)};
}

struct Spherical {
  double theta;  ///< from +z, [0, pi]
  double phi;    ///< from +x, (-pi, pi]; 0 at the pole
};
inline Spherical toSpherical(const Direction& w) {
  return {std::atan2(std::hypot(w[0], w[1]), w[2]), (w[0] == 0 && w[1] == 0) ? 0.0 : std::atan2(w[1], w[0])};
}

/// Half/difference coordinates of Rusinkiewicz 1998, "A New Change of Variables for Efficient BRDF Representation",
/// radians: the half vector's angles and the light direction's angles in the frame whose pole is the half vector.
struct HalfDifference {
  double thetaH;  ///< [0, pi/2] for directions above the horizon
  double phiH;    ///< (-pi, pi]; 0 where theta_h = 0
  double thetaD;  ///< [0, pi/2]
  double phiD;    ///< (-pi, pi]; 0 where theta_d = 0
};
BRDF_EXPORT HalfDifference toHalfDifference(const Direction& wi, const Direction& wo);

struct DirectionPair {
  Direction wi, wo;
};
BRDF_EXPORT DirectionPair fromHalfDifference(const HalfDifference& angles);

/// Two tangents that complete the unit vector `n` to a right-handed orthonormal frame (t, b, n), without a branch at
/// the pole (Duff et al. 2017, "Building an Orthonormal Basis, Revisited", listing 3).
inline void orthonormalBasis(const Direction& n, Direction& t, Direction& b) {
  const double sign = std::copysign(1.0, n[2]);
  const double a = -1 / (sign + n[2]);
  const double c = n[0] * n[1] * a;
  t = {1 + sign * n[0] * n[0] * a, sign * c, -sign * n[0]};
  b = {c, sign + n[1] * n[1] * a, -n[1]};
}

}  // namespace brdf
