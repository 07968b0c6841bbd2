#pragma once
#include <brdf/simulate/wave/PhaseTransform.h>

#include <vector>

namespace brdf::wave {

/// What generalised Harvey-Shack may take from the angle of incidence, both for isotropic spectra: A. Krywonos, J. E.
/// Harvey and N. Choi, J. Opt. Soc. Am. A 28, 1121-1138 (2011), doi:10.1364/JOSAA.28.001121, as written by V. E.
/// Johansen, J. Opt. Soc. Am. A 32, 186-194 (2015), doi:10.1364/JOSAA.32.000186, equations (7) and (15) to (20) of the
/// preprint.
struct HarveyShackOptions {
  /// Only frequencies that scatter light of this incidence count as roughness: g times sigma_rel^2 / sigma^2, where
  /// sigma_rel^2 is the integral of the PSD over the disk of radius 1 / wavelength about sin theta_i / wavelength (7).
  /// The autocovariance remains that of all heights.
  bool relevant = false;
  /// What does not leave in the mirror direction is scattered into the hemisphere: values are multiplied by
  /// K = (1 - exp(-g)) / (integral of Phi / wavelength^2 over the direction cosines of the hemisphere), g at
  /// cos_s = cos_i (20).
  bool renormalized = false;
};

/// Both as functions of the cosine of incidence, from tables; 1 where they are not asked for.
class BRDF_EXPORT Renormalization {
 public:
  /// Throws Error::Kind::Value for anisotropic spectra, and for infinite variance with `relevant`.
  Renormalization(const SpectrumPointer& spectrum, const PhaseTransformPointer& transform, double wavelength,
                  HarveyShackOptions options);
  /// sigma_rel / sigma, in (0, 1].
  double relevantShare(double cosI) const { return interpolated(shares_, cosI); }
  /// K.
  double factor(double cosI) const { return interpolated(factors_, cosI); }

 private:
  static double interpolated(const std::vector<double>& values, double cosI);
  void findShares(const Spectrum& spectrum, double wavelength);
  void findFactors(const PhaseTransform& transform, double variance, double wavelength);

  std::vector<double> shares_, factors_;  ///< at even steps of sqrt(cosI)
};

}  // namespace brdf::wave
