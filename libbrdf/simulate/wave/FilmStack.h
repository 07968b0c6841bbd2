#pragma once
#include <brdf/brdf_export.h>
#include <brdf/simulate/wave/Polarization.h>

#include <vector>

namespace brdf::wave {

/// Homogeneous films on a substrate, in air (index 1), at one wavelength: Fresnel's amplitudes of the whole.
///
/// Computed by the recursion of Airy's sums from the substrate outwards, whose exponentials decay only, so that thick
/// absorbing films do not overflow. M. Born and E. Wolf, Principles of Optics, 7th ed. (1999), sections 1.5.2
/// (Fresnel's formulae) and 1.6.4 (a film); fields exp(-i omega t). The amplitude rp is that of the
/// electric field along p of the incident to p of the reflected light (Polarization.h): rp = -rs at normal incidence.
class BRDF_EXPORT FilmStack {
 public:
  struct Film {
    double thickness;  ///< micrometres, >= 0
    Complex index;     ///< n + i k
  };
  /// `films` from the outermost to the substrate; `wavelength` in micrometres, in vacuum.
  FilmStack(std::vector<Film> films, Complex substrate, double wavelength);

  struct Amplitudes {
    Complex rs, rp;  ///< reflected
    Complex ts, tp;  ///< in the substrate, relative to the incident electric field
  };
  /// `sine` of the angle of incidence in air, and its cosine.
  Amplitudes at(double sine, double cosine) const;
  /// The reflected ones only.
  void reflection(double sine, double cosine, Complex& rs, Complex& rp) const;

  /// Fractions of the incident power, s and p, of light from the air. What is transmitted is what crosses into the
  /// substrate; for an absorbing substrate the normal component of the Poynting vector right below its surface.
  struct Powers {
    double reflectedS, reflectedP, transmittedS, transmittedP;
  };
  Powers powers(double sine, double cosine) const;

  Complex substrate() const { return substrate_; }
  const std::vector<Film>& films() const { return films_; }

 private:
  std::vector<Film> films_;
  Complex substrate_;
  double waveNumber_;  ///< 2 pi / wavelength, 1/um
};

/// sqrt(index^2 - sine^2) with the root that decays into the medium: index times the cosine of refraction.
inline Complex normalComponent(Complex index, double sine) {
  const Complex root = std::sqrt(index * index - sine * sine);
  return root.imag() < 0 ? -root : root;
}

}  // namespace brdf::wave
