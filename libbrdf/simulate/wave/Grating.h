#pragma once
#include <brdf/simulate/wave/FilmStack.h>
#include <brdf/simulate/wave/ScatterModel.h>

#include <memory>
#include <vector>

namespace brdf::wave {

/// A grating in scalar diffraction: a phase screen, whose orders m leave with the tangential parts
/// wi + wo = m wavelength/period along the grating vector and carry the share |c_m|^2 of the light, by the Fourier
/// coefficients of exp(i phi h(x)/depth), phi = 2 pi depth (cos_i + cos_s) / wavelength. J. W. Goodman, Introduction to
/// Fourier Optics, 2nd ed. (1996), section 4.4.4 (sinusoidal); lamellar: the coefficients of a two-valued screen.
/// Shadowing, polarisation by the grooves and evanescent orders are left out: periods of many wavelengths.
struct GratingShape {
  enum class Profile { Sinusoidal, Lamellar };
  Profile profile = Profile::Sinusoidal;
  double period = 1;  ///< um, > 0
  double depth = 0;   ///< um, from valley to peak, >= 0
  double duty = 0.5;  ///< lamellar: the part of the period that is ridge, in [0, 1]
  double angle = 0;   ///< of the grating vector from the tangent +x, radians; grooves run across it
};

/// Share |c_m|^2 of the order m of a screen whose phase differs by `phase` between valley and peak: for a sinusoid
/// J_m(phase/2)^2; for a lamella 1 - 4 d (1 - d) sin^2(phase/2) at m = 0, else 4 sin^2(phase/2) (sin(pi m d)/(pi m))^2.
/// The shares of all orders sum to 1.
BRDF_EXPORT double orderShare(const GratingShape& shape, int order, double phase);

/// An order that leaves above the horizon.
struct GratingOrder {
  int order;
  double theta, phi;  ///< of its direction, radians
  double share;       ///< |c_m|^2
  double efficiency;  ///< share times Fresnel's reflectance at the half angle, unpolarised light
};
/// The orders of light from `wi` (to the light), by their number.
BRDF_EXPORT std::vector<GratingOrder> gratingOrders(const GratingShape& shape, const FilmStack& stack,
                                                    double wavelength, const Vector& wi);

/// As a BRDF: each order seen by an instrument of Gaussian response, standard deviation `width` in direction cosines,
/// so that the integral of BRDF cos over one order is its efficiency. Throws Error::Kind::Value where more than 200
/// orders lie within the response.
BRDF_EXPORT ScatterModelPointer grating(const GratingShape& shape, FilmStack stack, double wavelength, double width);

/// A smooth surface or stack of films seen by the same instrument: Fresnel's reflectance at the half angle.
BRDF_EXPORT ScatterModelPointer mirror(FilmStack stack, double width);

}  // namespace brdf::wave
