#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/Fourier.h>
#include <brdf/simulate/MeasuredSpectrum.h>
#include <brdf/simulate/wave/CubicWeights.h>
#include <brdf/simulate/wave/PhaseTransform.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace brdf::wave {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLeastG = 1e-3, kRowStep = 0.25;
constexpr std::size_t kMostNodes = std::size_t{1} << 22;   // of the padded grid: 64 MiB a transform
constexpr std::size_t kMostValues = std::size_t{1} << 26;  // of the table: 256 MiB

/// The cells' autocovariance is periodic, and so are its powers: their transforms live at the same frequencies, also
/// beyond the highest that was measured. ln(T / g^2), T = Phi - kappa^2 exp(-g) PSD, cubic in ln g, constant in cells.
class CellTransform : public PhaseTransform {
 public:
  CellTransform(SpectrumPointer spectrum, const HeightSpectrum& cells, double wavelength)
      : spectrum_(std::move(spectrum)),
        variance_(spectrum_->variance()),
        periodX_(cells.periodX),
        periodY_(cells.periodY) {
    const double largest = 16 * kPi * kPi * variance_ / (wavelength * wavelength);
    if (!(largest > 0)) return;
    const std::size_t columns = paddedLength(cells.columns, cells.periodX, cells.slopeVarianceX(), wavelength);
    const std::size_t rows = paddedLength(cells.rows, cells.periodY, cells.slopeVarianceY(), wavelength);
    halfColumns_ = keptFrequencies(columns, cells.periodX, wavelength);
    halfRows_ = keptFrequencies(rows, cells.periodY, wavelength);
    levels_ = static_cast<std::size_t>(std::max(0.0, std::log(largest / kLeastG)) / kRowStep) + 4;
    const std::size_t kept = (halfColumns_ + 1) * (2 * halfRows_ + 1);
    if (columns > kMostNodes / rows || kept > kMostValues / levels_)
      throw Error(Error::Kind::Value, {"the grid of the measured spectrum is too fine for its heights", "wave model",
                                       std::to_string(columns) + " x " + std::to_string(rows) + " frequencies at " +
                                           std::to_string(levels_) + " heights",
                                       std::to_string(kMostNodes) + " frequencies, " + std::to_string(kMostValues) +
                                           " values; average=radial, or a coarser field"});
    makeTable(cells, columns, rows, kept);
  }

  void evaluate(const double* kappa, const double* fx, const double* fy, double* phi,
                std::size_t count) const override {
    spectrum_->evaluate(fx, fy, phi, count);
    for (std::size_t k = 0; k < count; ++k) {
      const double kk = kappa[k] * kappa[k], g = kk * variance_;
      phi[k] *= kk * std::exp(-g);
      if (!(g > 0)) continue;
      // Phi is even in (fx, fy): the half with fx >= 0 is kept.
      double m = std::floor(fx[k] * periodX_ + 0.5), n = std::floor(fy[k] * periodY_ + 0.5);
      if (m < 0) m = -m, n = -n;
      if (m > static_cast<double>(halfColumns_) || std::abs(n) > static_cast<double>(halfRows_)) continue;
      const std::size_t cell = static_cast<std::size_t>(m) * (2 * halfRows_ + 1) +
                               static_cast<std::size_t>(n + static_cast<double>(halfRows_));
      const double level = std::clamp(std::log(g / kLeastG) / kRowStep, 0.0, static_cast<double>(levels_ - 1));
      const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(level), 1, levels_ - 3);
      const auto w = cubicWeights(level - static_cast<double>(i));
      const float* line = table_.data() + cell * levels_ + i - 1;
      phi[k] += g * g * std::exp(w[0] * line[0] + w[1] * line[1] + w[2] * line[2] + w[3] * line[3]);
    }
  }

 private:
  /// Nodes along an axis, so that what is scattered beyond twice the highest frequency that counts stays out of it.
  std::size_t paddedLength(std::size_t nodes, double period, double slopeVariance, double wavelength) const {
    const double reach = 2 / wavelength, band = static_cast<double>(nodes / 2) / period;
    // The curvature of rho widens Phi to sqrt(g) times the rms frequency, 2 rms slope / wavelength at most.
    const double width = band + 12 * std::sqrt(slopeVariance) / wavelength;
    const double length = period * (width + std::min(width, reach));
    if (!(length < static_cast<double>(kMostNodes))) return kMostNodes + 1;
    return fastLength(std::max(nodes + 2, static_cast<std::size_t>(length) + 1));
  }
  static std::size_t keptFrequencies(std::size_t nodes, double period, double wavelength) {
    return std::min((nodes - 1) / 2, static_cast<std::size_t>(2 * period / wavelength + 0.5));
  }

  void makeTable(const HeightSpectrum& cells, std::size_t columns, std::size_t rows, std::size_t kept) {
    const std::size_t count = columns * rows;
    std::vector<std::complex<double>> values(count);
    // A highest frequency of an even number stands for both signs.
    const auto place = [](std::size_t index, std::size_t from, std::size_t to, bool mirrored) {
      if (2 * index == from) return mirrored ? to - index : index;
      return 2 * index < from ? index : to - (from - index);
    };
    for (std::size_t n = 0; n < cells.rows; ++n)
      for (std::size_t m = 0; m < cells.columns; ++m)
        for (const bool mirrorX : {false, true})
          for (const bool mirrorY : {false, true})
            values[place(n, cells.rows, rows, mirrorY) * columns + place(m, cells.columns, columns, mirrorX)] +=
                cells.psd[n * cells.columns + m] / 4;
    fourierTransform(values, columns, rows, false);
    std::vector<double> rho(count);
    for (std::size_t k = 0; k < count; ++k) rho[k] = std::clamp(values[k].real() / values[0].real(), -1.0, 1.0);
    table_.resize(kept * levels_);
    const double area = periodX_ * periodY_ / static_cast<double>(count);
    // rho is even, its transforms are real: two heights at a time, as real and imaginary part.
    for (std::size_t level = 0; level < levels_; level += 2) {
      const double g = kLeastG * std::exp(kRowStep * static_cast<double>(level)), next = g * std::exp(kRowStep);
      for (std::size_t k = 0; k < count; ++k) values[k] = {beyondFirstOrder(g, rho[k]), beyondFirstOrder(next, rho[k])};
      fourierTransform(values, columns, rows, false);
      keep(values, columns, rows, level, area, [](const std::complex<double>& value) { return value.real(); });
      if (level + 1 < levels_)
        keep(values, columns, rows, level + 1, area, [](const std::complex<double>& value) { return value.imag(); });
    }
  }

  template <class Part>
  void keep(const std::vector<std::complex<double>>& values, std::size_t columns, std::size_t rows, std::size_t level,
            double area, Part&& part) {
    double most = 0;
    for (const auto& value : values) most = std::max(most, part(value));
    const double least = std::max(1e-13 * most, 1e-30);  // rounding
    std::size_t cell = 0;
    for (std::size_t m = 0; m <= halfColumns_; ++m)
      for (std::size_t j = 0; j <= 2 * halfRows_; ++j, ++cell) {
        const std::size_t n = (j + rows - halfRows_) % rows;
        table_[cell * levels_ + level] =
            static_cast<float>(std::log(area * std::max(part(values[n * columns + m]), least)));
      }
  }

  SpectrumPointer spectrum_;
  double variance_, periodX_, periodY_;
  std::size_t halfColumns_ = 0, halfRows_ = 0, levels_ = 0;
  std::vector<float> table_;  ///< of (m >= 0, n, level)
};

}  // namespace

PhaseTransformPointer cellTransform(const SpectrumPointer& spectrum, double wavelength) {
  return std::make_shared<CellTransform>(spectrum, *spectrum->cells(), wavelength);
}

}  // namespace brdf::wave
