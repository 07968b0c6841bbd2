#pragma once
#include <brdf/simulate/wave/FilmStack.h>
#include <brdf/simulate/wave/ScatterModel.h>

#include <memory>
#include <string>

namespace brdf::wave {

/// Density of the slopes (mx, my) = (-dz/dx, -dz/dy of the facet normal) over the plane of slopes; its integral is 1
/// unless said otherwise.
class BRDF_EXPORT SlopeDistribution {
 public:
  virtual ~SlopeDistribution();
  virtual double density(double mx, double my) const = 0;
  virtual bool isotropic() const { return true; }
};
using SlopePointer = std::shared_ptr<const SlopeDistribution>;

/// exp(-(mx/sx)^2 - (my/sy)^2) / (pi sx sy): Beckmann's, s its alpha, the two-dimensional rms slope.
BRDF_EXPORT SlopePointer gaussianSlopes(double sx, double sy);
/// 3 / (pi sx sy) exp(-sqrt(6) m), m^2 = (mx/sx)^2 + (my/sy)^2; rms slope s where both are equal.
BRDF_EXPORT SlopePointer exponentialSlopes(double sx, double sy);
/// Ellipsoidal bumps of half axes rx, ry, rz (um) and `count` a um^2: count (rx ry rz / (rz^2 + (rx mx)^2 + (ry
/// my)^2))^2, of integral count pi rx ry, the part of the surface that they cover.
BRDF_EXPORT SlopePointer ellipsoidSlopes(double rx, double ry, double rz, double count);
/// share * b + (1 - share) * a.
BRDF_EXPORT SlopePointer mixedSlopes(SlopePointer a, SlopePointer b, double share);

/// The part of the facets that light and viewer both see.
class BRDF_EXPORT Shadowing {
 public:
  virtual ~Shadowing();
  virtual double seen(const Geometry& geometry) const = 0;
};
using ShadowingPointer = std::shared_ptr<const Shadowing>;

/// Smith's for Gaussian slopes of one-dimensional rms `w`, light and viewer independent: S(theta_i) S(theta_s),
/// S = (1 - erfc(mu/(sqrt2 w))/2) / (1 + Lambda), mu = cot theta. B. G. Smith, IEEE Trans. Antennas Propag. 15, 668-671
/// (1967), doi:10.1109/TAP.1967.1138991.
BRDF_EXPORT ShadowingPointer smithShadowing(double w);
/// V-grooves: min(1, 2 hz cos_i / (h.wi), 2 hz cos_s / (h.wi)). K. E. Torrance and E. M. Sparrow, J. Opt. Soc. Am. 57,
/// 1105-1114 (1967), doi:10.1364/JOSA.57.001105; in this form R. L. Cook and K. E. Torrance, ACM Trans. Graph. 1, 7-24
/// (1982), doi:10.1145/357290.357293.
BRDF_EXPORT ShadowingPointer grooveShadowing();
/// An empirical form, (1 + theta_n/omega exp(-2 beta/tau)) / (1 + theta_n/omega), theta_n the polar angle of the
/// facet's normal, beta half of the angle between light and viewer; omega and tau in radians, > 0. J. R. Maxwell, J.
/// Beard, S. Weiner, D. Ladd and S. Ladd, Bidirectional Reflectance Model Validation and Utilization, AFAL-TR-73-303
/// (1973).
BRDF_EXPORT ShadowingPointer maxwellBeardShadowing(double omega, double tau);

/// Facets that reflect as mirrors: BRDF = P(slope) / cos^4 theta_n * R(half angle) / (4 cos_i cos_s), times the part
/// that is seen. D. E. Barrick, "Rough surface scattering based on the specular point theory", IEEE Trans. Antennas
/// Propag. 16, 449-454 (1968), doi:10.1109/TAP.1968.1139220. Without shadowing it grows without bound at grazing
/// angles. `shadowing` may be null.
BRDF_EXPORT ScatterModelPointer facets(SlopePointer slopes, ShadowingPointer shadowing, FilmStack stack);

}  // namespace brdf::wave
