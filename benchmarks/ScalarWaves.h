#pragma once
#include <complex>
#include <cstddef>

/// Wave models as a straightforward programmer writes them: one pair at a time, std:: functions, angles by acos and
/// atan2, each series from its first term until it no longer grows. What brdf::WaveBrdf is measured against. Lengths in
/// um; `values` has `count` of them.
namespace scalar {

struct WavePairs {
  const double *wix, *wiy, *wiz, *wox, *woy, *woz;
  std::size_t count;
};

/// Rayleigh and Rice's perturbation with a K-correlation spectrum.
void rayleighRice(const WavePairs& pairs, std::complex<double> index, double wavelength, double a, double b, double c,
                  double* values);
/// Generalised Harvey-Shack, Gaussian spectrum.
void harveyShackGaussian(const WavePairs& pairs, std::complex<double> index, double wavelength, double rms,
                         double length, double* values);
/// Generalised Harvey-Shack, exponential autocovariance (K-correlation with c = 3).
void harveyShackExponential(const WavePairs& pairs, std::complex<double> index, double wavelength, double a, double b,
                            double* values);
/// Beckmann and Kirchhoff with Fresnel's reflectance at the half angle, Gaussian spectrum.
void beckmannKirchhoff(const WavePairs& pairs, std::complex<double> index, double wavelength, double rms, double length,
                       double* values);

}  // namespace scalar
