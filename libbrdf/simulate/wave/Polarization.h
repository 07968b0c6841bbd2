#pragma once
#include <brdf/brdf_export.h>

#include <array>
#include <complex>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::wave {

/// Conventions of polarisation, those of ../shared/reference/wave_models.csv (SCATMECH), pinned by
/// tests/simulate/PolarizationTest.cpp:
/// - fields vary as exp(-i omega t); refractive indices are n + i k, k >= 0;
/// - each direction of travel d has its own basis about the surface normal z: s along d x z, p along d x s, so that
///   {s, p, d} is right-handed. Light along the normal takes the plane of the other direction's azimuth as given: where
///   both are normal, and for incident light always, the plane xz;
/// - Stokes vectors are (I, Q, U, V) = (Is + Ip, Is - Ip, I(s+p) - I(s-p), Ilcp - Ircp), where left circular turns
///   counter-clockwise for who looks at the source: the second element is s minus p.
using Complex = std::complex<double>;

/// Amplitudes of the scattered field: Es' = ss Es + pToS Ep, Ep' = sToP Es + pp Ep.
struct Jones {
  Complex ss{}, pToS{}, sToP{}, pp{};
};
inline Jones operator*(const Jones& a, const Jones& b) {
  return {a.ss * b.ss + a.pToS * b.sToP, a.ss * b.pToS + a.pToS * b.pp, a.sToP * b.ss + a.pp * b.sToP,
          a.sToP * b.pToS + a.pp * b.pp};
}
inline Jones operator*(Complex factor, const Jones& a) {
  return {factor * a.ss, factor * a.pToS, factor * a.sToP, factor * a.pp};
}
inline Jones operator+(const Jones& a, const Jones& b) {
  return {a.ss + b.ss, a.pToS + b.pToS, a.sToP + b.sToP, a.pp + b.pp};
}

/// Half the squared amplitudes: m00 of the Mueller matrix, what unpolarised light gives to a detector of all light.
inline double unpolarized(const Jones& j) {
  return 0.5 * (std::norm(j.ss) + std::norm(j.pToS) + std::norm(j.sToP) + std::norm(j.pp));
}

/// A Mueller matrix: element (row, column) is m[4 row + column]; acts on the Stokes vectors above.
struct Mueller {
  std::array<double, 16> m{};
  double operator()(std::size_t row, std::size_t column) const { return m[4 * row + column]; }
};
BRDF_EXPORT Mueller operator*(const Mueller& a, const Mueller& b);
BRDF_EXPORT Mueller operator*(double factor, const Mueller& a);
BRDF_EXPORT Mueller operator+(const Mueller& a, const Mueller& b);
/// Of a deterministic (not depolarising) scatterer.
BRDF_EXPORT Mueller muellerOf(const Jones& jones);

/// The least eigenvalue of the coherency matrix of `m` (Cloude) over its trace: a matrix is a sum of those of Jones
/// matrices, and so physically possible, where it is not negative. 0 for a matrix of zeros. S. R. Cloude, "Group theory
/// and polarisation algebra", Optik 75, 26-36 (1986).
BRDF_EXPORT double leastCoherency(const Mueller& m);

/// A polarisation state, or the analyser that passes it: (I, Q, U, V) with I = 1.
struct PolarizationState {
  std::string name;
  std::array<double, 4> stokes;
};
/// unpolarized, s, p, s+p, s-p, lcp, rcp.
BRDF_EXPORT const std::vector<PolarizationState>& polarizationStates();

}  // namespace brdf::wave
