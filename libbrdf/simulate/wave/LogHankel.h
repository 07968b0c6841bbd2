#pragma once
#include <brdf/brdf_export.h>

#include <complex>
#include <cstddef>
#include <vector>

namespace brdf::wave {

/// The two-dimensional Fourier transform of functions of the distance r, on grids even in the logarithm:
///   F(f) = 2 pi integral of r a(r) J0(2 pi f r) dr
/// by the discrete transform of A. J. S. Hamilton, "Uncorrelated modes of the non-linear power spectrum", Mon. Not. R.
/// Astron. Soc. 312, 257-284 (2000), appendix B, doi:10.1046/j.1365-8711.2000.03071.x: as a convolution in ln r, with
/// the Mellin transform of the Bessel function (DLMF 10.22.43). Biased by r^0.75: for functions that are bounded at r =
/// 0 and fall to nothing at the upper end of the grid; the lower end has to lie some ten decades below what matters.
/// Rounding is about 1e-16 of max(r^0.75 |a|) / f^1.25 at every f.
class BRDF_EXPORT LogHankel {
 public:
  /// `count` distances, a power of two, from `first` (um) with ratio exp(step).
  LogHankel(double first, double step, std::size_t count);

  const std::vector<double>& distances() const { return distances_; }      ///< um, ascending
  const std::vector<double>& frequencies() const { return frequencies_; }  ///< 1/um, ascending
  /// Of values at the distances, at the frequencies. Safe from several threads.
  std::vector<double> transform(const std::vector<double>& values) const;
  /// How far rounding may reach at each frequency: see above, with `values` at the distances.
  std::vector<double> rounding(const std::vector<double>& values) const;

 private:
  std::vector<double> distances_, frequencies_, bias_, unbias_;
  std::vector<std::complex<double>> multiplier_;
};

}  // namespace brdf::wave
