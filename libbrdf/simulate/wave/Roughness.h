#pragma once
#include <brdf/simulate/Spectrum.h>
#include <brdf/simulate/wave/FilmStack.h>
#include <brdf/simulate/wave/Renormalization.h>
#include <brdf/simulate/wave/ScatterModel.h>

#include <memory>

namespace brdf::wave {

/// Scattering amplitudes of a slightly rough interface of relative index `index`, first order in the height, over
/// 4 pi sqrt(cos_i cos_s PSD) / wavelength^2: S. O. Rice, Commun. Pure Appl. Math. 4, 351-378 (1951),
/// doi:10.1002/cpa.3160040206; D. E. Barrick, Radar Cross Section Handbook (1970), chapter 9;
/// J. C. Stover, Optical Scattering (1995), chapter 4. With e = index^2, q = sqrt(e - sin^2), c = cos:
///   ss = (e-1) cos phi / ((ci + qi) (cs + qs)),       pToS = -(e-1) qi sin phi / ((e ci + qi) (cs + qs)),
///   sToP = -(e-1) qs sin phi / ((ci + qi) (e cs + qs)),
///   pp = (e-1) (e sin_i sin_s - qi qs cos phi) / ((e ci + qi) (e cs + qs)).
BRDF_EXPORT Jones perturbationAmplitudes(const Geometry& geometry, Complex index);

/// Rayleigh-Rice: BRDF = 16 pi^2 / wavelength^4 cos_i cos_s |amplitudes|^2 PSD(q / wavelength). Valid for heights
/// small against the wavelength, (4 pi rms cos_i / wavelength)^2 << 1. Where the PSD is infinite, so is the value.
BRDF_EXPORT ScatterModelPointer rayleighRice(SpectrumPointer spectrum, Complex index, double wavelength);

/// Generalised Harvey-Shack: BRDF = |perturbationAmplitudes|^2 Phi(kappa, q / wavelength) / wavelength^2,
/// kappa = 2 pi (cos_i + cos_s) / wavelength. A. Krywonos, J. E. Harvey and N. Choi, J. Opt. Soc. Am. A 28, 1121-1138
/// (2011), doi:10.1364/JOSAA.28.001121: the surface transfer function exp(-g (1 - rho)) of two parameters. By default
/// the whole spectrum counts as roughness and nothing is renormalised, so that the model is reciprocal; with either
/// option it is not. `transform` is of the spectrum, for this wavelength or shorter.
BRDF_EXPORT ScatterModelPointer harveyShack(SpectrumPointer spectrum, PhaseTransformPointer transform, Complex index,
                                            double wavelength, HarveyShackOptions options = {});

/// Beckmann-Kirchhoff: BRDF = R F Phi(kappa, q / wavelength) / wavelength^2 with Fresnel's R at the half angle and
/// F = (1 + cos_i cos_s - sin_i sin_s cos phi)^2 / (cos_i cos_s (cos_i + cos_s)^2) as in P. Beckmann and A.
/// Spizzichino, The Scattering of Electromagnetic Waves from Rough Surfaces (1963), section 5.3; or F = 1, for large
/// angles: J. E. Harvey, A. Krywonos and C. L. Vernold, Opt. Eng. 46, 078002 (2007), doi:10.1117/1.2752180 (without
/// their renormalisation K).
BRDF_EXPORT ScatterModelPointer beckmannKirchhoff(SpectrumPointer spectrum, PhaseTransformPointer transform,
                                                  FilmStack stack, double wavelength, bool modified);

/// Amplitudes of a facet that reflects wi into wo: Fresnel's at the half angle, turned into the bases of the rays.
BRDF_EXPORT Jones facetAmplitudes(const Geometry& geometry, const FilmStack& stack);

}  // namespace brdf::wave
