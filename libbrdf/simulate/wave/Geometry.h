#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/simulate/wave/Polarization.h>

#include <array>

namespace brdf::wave {

using Vector = std::array<double, 3>;

inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A direction of travel with its basis (Polarization.h).
struct Ray {
  Vector d, s, p;
};

/// One pair of directions as the formulas of scattering want it. Angles are named as there: i of incidence, s of
/// scattering, phi the azimuth of the scattered light from the forward direction.
struct Geometry {
  double cosI, sinI, cosS, sinS;  ///< both cosines > 0
  double cosPhi, sinPhi;          ///< mirror direction: theta_s = theta_i, phi = 0
  double qx, qy;  ///< tangential parts of wi + wo: 0 in the mirror direction; frequencies are q / wavelength
  Vector wi, wo;
  std::array<double, 2> forward;   ///< unit vector along the tangential travel of the incident light
  std::array<double, 2> outgoing;  ///< the same of the scattered light

  Ray incident() const {
    const Vector s{forward[1], -forward[0], 0}, d{-wi[0], -wi[1], -wi[2]};
    return {d, s, cross(d, s)};
  }
  Ray scattered() const {
    const Vector s{outgoing[1], -outgoing[0], 0};
    return {wo, s, cross(wo, s)};
  }
};

/// The geometry of pair `k`; false where a direction is not above the horizon.
BRDF_EXPORT bool geometryOf(const DirectionPairs<double>& pairs, std::size_t k, Geometry& geometry);

/// The basis of light that travels along `d`, whose tangential part is along `tangent`.
inline Ray rayAlong(const Vector& d, const std::array<double, 2>& tangent) {
  const Vector s{tangent[1], -tangent[0], 0};
  return {d, s, cross(d, s)};
}

/// Scattering from `in` to `out` whose amplitudes are known for fields perpendicular and parallel to the plane of the
/// two directions, in the bases of the rays. The parallel fields are along d x perpendicular of either ray. For
/// parallel or opposite directions the amplitudes must not depend on the plane.
BRDF_EXPORT Jones inPlane(const Ray& in, const Ray& out, Complex perpendicular, Complex parallel);

}  // namespace brdf::wave
