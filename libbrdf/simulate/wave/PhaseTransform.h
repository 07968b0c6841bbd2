#pragma once
#include <brdf/simulate/Spectrum.h>

namespace brdf::wave {

/// The transform of the characteristic function of a Gaussian random surface,
///   Phi(kappa, f) = integral of [exp(-g (1 - rho(r))) - exp(-g)] exp(-2 pi i f r) d^2r   (um^2),
/// g = kappa^2 variance, rho the autocovariance over the variance; kappa is 2 pi (cos_i + cos_s) / wavelength in 1/um.
/// Tends to kappa^2 PSD(f) for small g. As a series, exp(-g) times the sum of g^n / n! times the transform of rho^n, it
/// has no negative part.
class BRDF_EXPORT PhaseTransform {
 public:
  virtual ~PhaseTransform();
  /// Of `count` values of kappa >= 0, up to 4 pi / wavelength, and frequencies up to 2 / wavelength.
  virtual void evaluate(const double* kappa, const double* fx, const double* fy, double* phi,
                        std::size_t count) const = 0;

  /// For wavelengths from `wavelength` (um) on. Which method takes which spectrum:
  /// - Gaussian: Beckmann's series, summed about its largest term, at any height; to 1e-11;
  /// - a power law of exponent between 2 and 4 at all frequencies: a stable law, exact by its scaling; to 1e-9;
  /// - isotropic of finite variance: its first order is kappa^2 exp(-g) PSD, and the rest comes from a table made here
  ///   (10 ms to 1 s); to 2e-5 of Phi down to 1e-3 of its largest value over f, to 2e-4 down to 1e-8, to 1e-3 down to
  ///   1e-11, and below that to 1e-2 where the PSD is a power law and to 1e-12 of the largest value where it falls
  ///   faster; rms up to 8000 wavelengths;
  /// - the cells of a measured one (average=none): the rest by Fourier transform on their grid, to 1e-3.
  /// Throws Error::Kind::Value for any other: infinite variance, anisotropic sums, grids too fine for their heights.
  static std::shared_ptr<const PhaseTransform> of(const SpectrumPointer& spectrum, double wavelength);
};
using PhaseTransformPointer = std::shared_ptr<const PhaseTransform>;

/// exp(-g) (exp(g rho) - 1 - g rho) / g^2 = the part beyond the first order, without cancellation; g > 0, |rho| <= 1.
double beyondFirstOrder(double g, double rho);

/// As PhaseTransform::of; each throws for what is not its own.
PhaseTransformPointer isotropicTransform(const SpectrumPointer& spectrum, double wavelength);
PhaseTransformPointer stableTransform(const SpectrumPointer& spectrum);
PhaseTransformPointer cellTransform(const SpectrumPointer& spectrum, double wavelength);

}  // namespace brdf::wave
