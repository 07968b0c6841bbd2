#pragma once
#include <brdf/brdf_export.h>
#include <brdf/simulate/wave/Polarization.h>

#include <vector>

namespace brdf::wave {

/// Scattering by one homogeneous sphere: Mie's series. C. F. Bohren and D. R. Huffman, Absorption and Scattering of
/// Light by Small Particles (Wiley 1983), doi:10.1002/9783527618156: coefficients (4.88), amplitudes (4.74), angular
/// functions (4.47), efficiencies (4.61), (4.62), backscattering section 4.6. Fields exp(-i omega t).
///
/// Stable from Rayleigh's limit to large and strongly absorbing spheres: logarithmic derivatives go downwards from
/// beyond the turning point; psi goes upwards to the size parameter and by downward ratios beyond (W. J. Wiscombe,
/// Appl. Opt. 19, 1505-1509 (1980), doi:10.1364/AO.19.001505).
class BRDF_EXPORT MieSphere {
 public:
  /// `size`: 2 pi radius n_medium / wavelength, in [1e-12, 1e6]; `index`: of the sphere relative to the medium, its
  /// modulus times `size` at most 4e6. Throws Error::Kind::Value outside.
  MieSphere(double size, Complex index);

  /// Amplitudes S1 (perpendicular to the plane of scattering) and S2 (parallel) at the cosine of the scattering angle;
  /// the scattered field is exp(i k (r - z)) / (-i k r) S times the incident one.
  void amplitudes(double cosine, Complex& s1, Complex& s2) const;

  double size() const { return size_; }
  /// Cross sections over the geometric cross section.
  double extinction() const { return extinction_; }
  double scattering() const { return scattering_; }
  double backscattering() const { return backscattering_; }  ///< 4 pi dC/dOmega(180 degrees) over the geometric one
  double asymmetry() const { return asymmetry_; }            ///< mean cosine of the scattering angle
  std::size_t terms() const { return a_.size(); }

 private:
  double size_;
  std::vector<Complex> a_, b_;  ///< the coefficients n = 1, 2, ... times (2n + 1) / (n (n + 1))
  double extinction_ = 0, scattering_ = 0, backscattering_ = 0, asymmetry_ = 0;
};

}  // namespace brdf::wave
