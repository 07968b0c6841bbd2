#pragma once
#include <brdf/brdf_export.h>
#include <brdf/simulate/HeightField.h>
#include <brdf/simulate/Spectrum.h>

#include <vector>

namespace brdf {

/// What multiplies the heights before they are transformed.
enum class SpectrumWindow {
  None,  ///< for tiles that repeat: generated surfaces
  Hann   ///< for cuttings of a larger surface, whose edges do not fit: both axes; the spectrum is divided by the mean
         ///< square of the window
};

/// The power spectral density of a height field at the frequencies of its tile, in the conventions of Spectrum.h:
/// two-sided, um^4, PSD(m / periodX, n / periodY) = periodX periodY |c_mn|^2 with the Fourier coefficients
/// c_mn = 1/N sum h exp(-2 pi i (m i / columns + n j / rows)) of the heights about their mean. The sum of the PSD times
/// the area of a cell of frequencies, 1 / (periodX periodY), is the variance of the nodes' heights exactly (Parseval).
/// J. M. Elson and J. M. Bennett, "Calculation of the power spectral density from surface profile data", Appl. Opt. 34,
/// 201-208 (1995), doi:10.1364/AO.34.000201, in two dimensions.
struct BRDF_EXPORT HeightSpectrum {
  std::size_t columns = 0, rows = 0;
  double periodX = 1, periodY = 1;  ///< micrometres
  std::vector<double> psd{};        ///< um^4; of (m, n) at [n columns + m], negative frequencies in the upper halves

  double frequencyX(std::size_t m) const;  ///< 1/um, in (-columns/2, columns/2] / periodX
  double frequencyY(std::size_t n) const;
  double variance() const;  ///< um^2: the integral
  /// Mean squares of the slopes, the integrals of (2 pi fx)^2 PSD and (2 pi fy)^2 PSD: of the smooth surface through
  /// the nodes, steeper than its triangles (HeightStatistics.h).
  double slopeVarianceX() const;
  double slopeVarianceY() const;
};
/// Throws Error::Kind::Value for a height field that is none (HeightField::check).
BRDF_EXPORT HeightSpectrum spectrumOf(const HeightField& field, SpectrumWindow window = SpectrumWindow::None);

/// The mean of the PSD over rings of frequencies as wide as the coarser step, from the first ring that is not f = 0 to
/// the lower of the two highest frequencies.
struct RadialSpectrum {
  std::vector<double> frequency{};    ///< 1/um: the mean of the ring's
  std::vector<double> psd{};          ///< um^4
  std::vector<std::size_t> counts{};  ///< of frequencies in the ring, at least 1
};
BRDF_EXPORT RadialSpectrum radialAverage(const HeightSpectrum& spectrum);

/// As a Spectrum. `radial`: the radial average, linear between rings, the lowest ring's value below it and 0 above
/// the highest; for what was measured on an isotropic surface. Else the cells about the
/// frequencies of the tile, constant in each; its integral is the variance exactly.
BRDF_EXPORT SpectrumPointer measuredSpectrum(const HeightField& field, SpectrumWindow window, bool radial);

/// The same by name, "measured(surface=heightfield(file=h.exr, spacing=0.1), window=hann, average=radial)": one of
/// spectrumKinds().
SpectrumKind measuredSpectrumKind();

}  // namespace brdf
