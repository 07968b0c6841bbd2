#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/wave/CubicWeights.h>
#include <brdf/simulate/wave/LogHankel.h>
#include <brdf/simulate/wave/PhaseTransform.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace brdf::wave {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLeastG = 1e-4;    // Below it the second order is proportional to g^2, to 1e-4 of itself.
constexpr double kLargestG = 1e10;  // (4 pi rms / wavelength)^2; rounding of rho to 1e-16 reaches 1e-6 of Phi.
constexpr double kRowStep = 0.07, kLogStep = 0.04;
constexpr std::size_t kMostDistances = 8192;

/// The integral over all frequencies of what is beyond the first order: 1 - exp(-g) (1 + g).
double secondShare(double g) {
  return g < 1e-3 ? g * g * (0.5 - g / 3 + g * g / 8) : -std::expm1(-g) - g * std::exp(-g);
}

/// ln(T / secondShare(g)), T = Phi - kappa^2 exp(-g) PSD, on a grid of ln g and ln f, cubic between.
class IsotropicTransform : public PhaseTransform {
 public:
  IsotropicTransform(SpectrumPointer spectrum, double wavelength)
      : spectrum_(std::move(spectrum)), variance_(spectrum_->variance()), highest_(2 / wavelength) {
    if (!std::isfinite(variance_))
      throw Error(Error::Kind::Value,
                  {"theories of any height need heights of finite variance", "wave model", spectrum_->description(),
                   "abc with c > 2, fractal with exponent > 2, or RayleighRice"});
    const double largest = 16 * kPi * kPi * variance_ / (wavelength * wavelength);
    if (largest > kLargestG)
      throw Error(Error::Kind::Value, {"heights too large for the wavelength", "wave model",
                                       "rms " + formatNumber(std::sqrt(variance_)) + " um",
                                       "at most " + formatNumber(std::sqrt(kLargestG) / (4 * kPi)) + " wavelengths"});
    if (variance_ > 0) makeTable(largest);
  }

  void evaluate(const double* kappa, const double* fx, const double* fy, double* phi,
                std::size_t count) const override {
    spectrum_->evaluate(fx, fy, phi, count);
    if (rows_ == 0) {
      std::fill_n(phi, count, 0.0);
      return;
    }
    const auto lastRow = static_cast<double>(rows_ - 1), lastColumn = static_cast<double>(columns_ - 1);
    for (std::size_t k = 0; k < count; ++k) {
      const double kk = kappa[k] * kappa[k], g = kk * variance_;
      if (!(g > 0)) {
        phi[k] = 0;
        continue;
      }
      const double ff = fx[k] * fx[k] + fy[k] * fy[k];
      const double row = std::clamp(std::log(g / kLeastG) / kRowStep, 0.0, lastRow);
      const double column = ff > 0 ? std::clamp(std::log(ff / leastSquare_) / (2 * step_), 0.0, lastColumn) : 0.0;
      phi[k] = kk * std::exp(-g) * phi[k] + secondShare(g) * std::exp(interpolated(row, column));
    }
  }

 private:
  double interpolated(double row, double column) const {
    const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(row), 1, rows_ - 3);
    const auto j = std::clamp<std::size_t>(static_cast<std::size_t>(column), 1, columns_ - 3);
    const auto u = cubicWeights(row - static_cast<double>(i)), v = cubicWeights(column - static_cast<double>(j));
    double sum = 0;
    for (std::size_t a = 0; a < 4; ++a) {
      const double* line = table_.data() + (i + a - 1) * columns_ + j - 1;
      sum += u[a] * (v[0] * line[0] + v[1] * line[1] + v[2] * line[2] + v[3] * line[3]);
    }
    return sum;
  }

  double rho(double r) const { return std::clamp(spectrum_->autocovariance(r, 0) / variance_, -1.0, 1.0); }

  /// Beyond it rho stays below 1e-3, over two decades at least.
  double correlationLength() const {
    double r = 1e-3 / highest_;
    for (int below = 0, k = 0; k < 400; ++k, r *= 2) {
      below = std::abs(rho(r)) < 1e-3 ? below + 1 : 0;
      if (below == 7) return r / 64;
    }
    throw Error(Error::Kind::Value,
                {"heights correlate without end", "wave model", spectrum_->description(), "a correlation length"});
  }

  /// Distance at which g (1 - rho) is 1.
  double phaseLength(double g, double correlation) const {
    double low = std::log(correlation) - 100, high = std::log(correlation);
    if (g * (1 - rho(correlation)) < 1) return correlation;
    while (high - low > 0.5) {
      const double middle = (low + high) / 2;
      (g * (1 - rho(std::exp(middle))) < 1 ? low : high) = middle;
    }
    return std::exp(low);
  }

  void makeTable(double largest) {
    const double correlation = correlationLength();
    // Below the first distance lies 1e-9 of the bias, and nothing of the integral.
    const double phase = phaseLength(largest, correlation), least = 1 / highest_;
    const double first = std::min({1e-12 * least, 1e-12 * std::max(phase, 1e-4 * least), 1e-8 * phase});
    const double range = std::log(1e4 * correlation / first);
    const std::size_t count = std::bit_ceil(static_cast<std::size_t>(range / kLogStep));
    if (count > kMostDistances)
      throw Error(Error::Kind::Value, {"the spectrum falls too slowly for its height", "wave model",
                                       spectrum_->description(), "smaller heights, or a steeper spectrum"});
    step_ = range / static_cast<double>(count);
    const LogHankel hankel(first, step_, count);
    std::vector<double> rhos(count);
    parallelFor(count, 32, [&](std::size_t begin, std::size_t end) {
      for (std::size_t j = begin; j < end; ++j) rhos[j] = rho(hankel.distances()[j]);
    });
    const std::vector<double>& frequencies = hankel.frequencies();
    const double lowest = 1e-3 / (2 * kPi * correlation);
    const auto start = static_cast<std::size_t>(std::ranges::lower_bound(frequencies, lowest) - frequencies.begin());
    const auto end = static_cast<std::size_t>(std::ranges::upper_bound(frequencies, highest_) - frequencies.begin());
    columns_ = std::clamp<std::size_t>(end + 2, start + 4, count) - start;
    leastSquare_ = frequencies[start] * frequencies[start];
    rows_ = static_cast<std::size_t>(std::max(0.0, std::log(largest / kLeastG)) / kRowStep) + 4;
    std::vector<double> psd(columns_), zero(columns_, 0.0);
    spectrum_->evaluate(frequencies.data() + start, zero.data(), psd.data(), columns_);
    table_.resize(rows_ * columns_);
    parallelFor(rows_, 4, [&](std::size_t begin, std::size_t stop) {
      std::vector<double> values(count);
      for (std::size_t row = begin; row < stop; ++row) {
        const double g = kLeastG * std::exp(kRowStep * static_cast<double>(row));
        const double scale = g * g / secondShare(g);
        for (std::size_t j = 0; j < count; ++j) values[j] = scale * beyondFirstOrder(g, rhos[j]);
        const std::vector<double> transformed = hankel.transform(values), noise = hankel.rounding(values);
        // At low frequencies by the moments of r: M0 - M2 (2 pi f)^2 / 4.
        double zeroth = 0, second = 0;
        for (std::size_t j = 0; j < count; ++j) {
          const double rr = hankel.distances()[j] * hankel.distances()[j];
          zeroth += 2 * kPi * step_ * rr * values[j];
          second += 2 * kPi * step_ * rr * rr * values[j];
        }
        for (std::size_t column = 0; column < columns_; ++column) {
          const double k = 2 * kPi * frequencies[start + column], bend = k * k * second / (4 * zeroth);
          const bool low = bend < 1e-3;
          const double value = low ? zeroth * (1 - bend) : transformed[start + column];
          const double limit = noise[start + column];
          // Far out one great order and the others about the mirror: Phi tends to g PSD / variance.
          const double far = -g * std::expm1(-g) / secondShare(g) * psd[column] / variance_;
          const bool lost = !low && value < 100 * limit && std::abs(value - far) < 0.05 * far;
          table_[row * columns_ + column] =
              std::log(lost || (!low && value < limit) ? std::max(far, 1e-2 * limit) : value);
        }
      }
    });
  }

  SpectrumPointer spectrum_;
  double variance_;  ///< um^2
  double highest_;   ///< frequency, 1/um
  std::size_t rows_ = 0, columns_ = 0;
  double leastSquare_ = 1;  ///< square of the first column's frequency
  double step_ = 1;         ///< of ln f
  std::vector<double> table_;
};

}  // namespace

double beyondFirstOrder(double g, double rho) {
  const double x = g * rho;
  if (std::abs(x) > 0.5) return (std::exp(g * (rho - 1)) - std::exp(-g) * (1 + x)) / (g * g);
  double sum = 0, term = rho * rho / 2;
  for (int n = 3; n < 17; ++n) {
    sum += term;
    term *= x / n;
  }
  return std::exp(-g) * sum;
}

PhaseTransformPointer isotropicTransform(const SpectrumPointer& spectrum, double wavelength) {
  return std::make_shared<IsotropicTransform>(spectrum, wavelength);
}

}  // namespace brdf::wave
