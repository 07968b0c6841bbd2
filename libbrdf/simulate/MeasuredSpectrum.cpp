#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/models/CallArguments.h>
#include <brdf/simulate/BesselIntegral.h>
#include <brdf/simulate/Fourier.h>
#include <brdf/simulate/HeightStatistics.h>
#include <brdf/simulate/MeasuredSpectrum.h>
#include <brdf/simulate/SurfaceKinds.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <mutex>

namespace brdf {
namespace {

/// sin(pi x) / (pi x).
double sinc(double x) { return x == 0 ? 1 : std::sin(kPi * x) / (kPi * x); }

/// Whether index m is the highest frequency of an even number, which stands for both signs.
bool isHighest(std::size_t m, std::size_t count) { return count % 2 == 0 && m == count / 2; }

std::string textOf(const char* average, const HeightSpectrum& spectrum) {
  return std::string("measured(tile ") + formatNumber(spectrum.periodX, 6) + " um x " +
         formatNumber(spectrum.periodY, 6) + " um, average=" + average + ")";
}

/// Constant in the cell about every frequency of the tile.
class CellSpectrum : public Spectrum {
 public:
  explicit CellSpectrum(HeightSpectrum spectrum) : spectrum_(std::move(spectrum)), variance_(spectrum_.variance()) {}

  void evaluate(const double* fx, const double* fy, double* psd, std::size_t count) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const auto [m, shareX] = cellOf(fx[k] * spectrum_.periodX, spectrum_.columns);
      const auto [n, shareY] = cellOf(fy[k] * spectrum_.periodY, spectrum_.rows);
      psd[k] = shareX * shareY == 0 ? 0 : shareX * shareY * spectrum_.psd[n * spectrum_.columns + m];
    }
  }
  double variance() const override { return variance_; }
  /// The transform of the cells is that of their centres times sinc(x / periodX) sinc(y / periodY); the former is taken
  /// at the lags of the nodes and is bilinear between.
  double autocovariance(double x, double y) const override {
    std::call_once(once_, [this] { transform(); });
    const auto columns = static_cast<double>(spectrum_.columns), rows = static_cast<double>(spectrum_.rows);
    const double u = (x / spectrum_.periodX - std::floor(x / spectrum_.periodX)) * columns;
    const double v = (y / spectrum_.periodY - std::floor(y / spectrum_.periodY)) * rows;
    const auto i = std::min(static_cast<std::size_t>(u), spectrum_.columns - 1);
    const auto j = std::min(static_cast<std::size_t>(v), spectrum_.rows - 1);
    const std::size_t i1 = (i + 1) % spectrum_.columns, j1 = (j + 1) % spectrum_.rows;
    const double s = u - static_cast<double>(i), t = v - static_cast<double>(j);
    const auto at = [&](std::size_t column, std::size_t row) { return covariance_[row * spectrum_.columns + column]; };
    const double value = (1 - t) * ((1 - s) * at(i, j) + s * at(i1, j)) + t * ((1 - s) * at(i, j1) + s * at(i1, j1));
    return value * sinc(x / spectrum_.periodX) * sinc(y / spectrum_.periodY);
  }
  const HeightSpectrum* cells() const override { return &spectrum_; }
  bool isotropic() const override { return false; }
  std::string description() const override { return textOf("none", spectrum_); }

 private:
  struct Cell {
    std::size_t index;
    double share;  ///< of the cell's value: 1, 1/2 where the highest frequency stands for both signs, 0 beyond
  };
  static Cell cellOf(double frequency, std::size_t count) {
    const double nearest = std::floor(frequency + 0.5), size = std::abs(nearest);
    if (!(2 * size <= static_cast<double>(count))) return {0, 0};
    const auto index = static_cast<std::size_t>(size);
    return {nearest >= 0 || index == 0 ? index : count - index, isHighest(index, count) ? 0.5 : 1.0};
  }
  void transform() const {
    std::vector<std::complex<double>> values(spectrum_.psd.begin(), spectrum_.psd.end());
    fourierTransform(values, spectrum_.columns, spectrum_.rows, false);
    const double cell = 1 / (spectrum_.periodX * spectrum_.periodY);
    for (const std::complex<double>& value : values) covariance_.push_back(value.real() * cell);
  }

  HeightSpectrum spectrum_;
  double variance_;
  mutable std::once_flag once_;
  mutable std::vector<double> covariance_;
};

/// The average over rings, linear between them.
class RingSpectrum : public Spectrum {
 public:
  RingSpectrum(const HeightSpectrum& spectrum, RadialSpectrum rings)
      : rings_(std::move(rings)), description_(textOf("radial", spectrum)) {
    rings_.frequency.insert(rings_.frequency.begin(), 0);
    rings_.psd.insert(rings_.psd.begin(), rings_.psd.front());
  }

  void evaluate(const double* fx, const double* fy, double* psd, std::size_t count) const override {
    for (std::size_t k = 0; k < count; ++k) psd[k] = at(std::hypot(fx[k], fy[k]));
  }
  double variance() const override {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < rings_.frequency.size(); ++k) {
      const double low = rings_.frequency[k], high = rings_.frequency[k + 1];
      sum += kPi / 3 * (high - low) * (rings_.psd[k] * (2 * low + high) + rings_.psd[k + 1] * (low + 2 * high));
    }
    return sum;
  }
  /// By parts: the slopes of the PSD and its end, each with an integral of t J1(t), exact.
  double autocovariance(double x, double y) const override {
    const double k = 2 * kPi * std::hypot(x, y), end = rings_.frequency.back();
    if (k * end < 1e-6) return variance();
    double sum = rings_.psd.back() * end * std::cyl_bessel_j(1.0, k * end) / k, below = 0;
    for (std::size_t j = 0; j + 1 < rings_.frequency.size(); ++j) {
      const double width = rings_.frequency[j + 1] - rings_.frequency[j];
      const double above = besselMoment(k * rings_.frequency[j + 1]);
      sum -= (rings_.psd[j + 1] - rings_.psd[j]) / width * (above - below) / (k * k * k);
      below = above;
    }
    return 2 * kPi * sum;
  }
  bool isotropic() const override { return true; }
  std::string description() const override { return description_; }

 private:
  double at(double f) const {
    const auto above = std::ranges::upper_bound(rings_.frequency, f);
    if (above == rings_.frequency.end()) return f == rings_.frequency.back() ? rings_.psd.back() : 0;
    const auto k = static_cast<std::size_t>(above - rings_.frequency.begin());
    const double part = (f - rings_.frequency[k - 1]) / (rings_.frequency[k] - rings_.frequency[k - 1]);
    return (1 - part) * rings_.psd[k - 1] + part * rings_.psd[k];
  }

  RadialSpectrum rings_;
  std::string description_;
};

/// The Hann window of `count` nodes, periodic.
std::vector<double> hann(std::size_t count) {
  std::vector<double> window(count);
  for (std::size_t i = 0; i < count; ++i)
    window[i] = 0.5 - 0.5 * std::cos(2 * kPi * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
  return window;
}

}  // namespace

double HeightSpectrum::frequencyX(std::size_t m) const { return frequencyOf(m, columns, periodX); }
double HeightSpectrum::frequencyY(std::size_t n) const { return frequencyOf(n, rows, periodY); }

double HeightSpectrum::variance() const {
  double sum = 0;
  for (const double value : psd) sum += value;
  return sum / (periodX * periodY);
}

double HeightSpectrum::slopeVarianceX() const {
  double sum = 0;
  for (std::size_t k = 0; k < psd.size(); ++k) sum += psd[k] * std::pow(2 * kPi * frequencyX(k % columns), 2);
  return sum / (periodX * periodY);
}

double HeightSpectrum::slopeVarianceY() const {
  double sum = 0;
  for (std::size_t k = 0; k < psd.size(); ++k) sum += psd[k] * std::pow(2 * kPi * frequencyY(k / columns), 2);
  return sum / (periodX * periodY);
}

HeightSpectrum spectrumOf(const HeightField& field, SpectrumWindow window) {
  field.check("spectrum of a height field");
  HeightSpectrum result{field.columns, field.rows, field.periodX(), field.periodY(), {}};
  const double mean = statisticsOf(field).mean, nodes = static_cast<double>(field.heights.size());
  std::vector<std::complex<double>> values(field.heights.size());
  double weight = nodes;
  if (window == SpectrumWindow::None) {
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = field.heights[k] - mean;
  } else {
    const std::vector<double> x = hann(field.columns), y = hann(field.rows);
    // About the mean that the window sees: no power at f = 0.
    double sum = 0, total = 0;
    weight = 0;
    for (std::size_t j = 0, k = 0; j < field.rows; ++j)
      for (std::size_t i = 0; i < field.columns; ++i, ++k) {
        const double w = x[i] * y[j];
        sum += w * (field.heights[k] - mean);
        total += w;
        weight += w * w;
      }
    for (std::size_t j = 0, k = 0; j < field.rows; ++j)
      for (std::size_t i = 0; i < field.columns; ++i, ++k)
        values[k] = x[i] * y[j] * (field.heights[k] - mean - sum / total);
  }
  fourierTransform(values, field.columns, field.rows, false);
  const double scale = result.periodX * result.periodY / (nodes * weight);
  result.psd.reserve(values.size());
  for (const std::complex<double>& value : values) result.psd.push_back(std::norm(value) * scale);
  return result;
}

RadialSpectrum radialAverage(const HeightSpectrum& spectrum) {
  const double step = std::max(1 / spectrum.periodX, 1 / spectrum.periodY);
  const double highest = std::min(static_cast<double>(spectrum.columns / 2) / spectrum.periodX,
                                  static_cast<double>(spectrum.rows / 2) / spectrum.periodY);
  const std::size_t rings = static_cast<std::size_t>(highest / step + 0.5) + 1;
  RadialSpectrum all{std::vector<double>(rings), std::vector<double>(rings), std::vector<std::size_t>(rings)};
  for (std::size_t n = 0, k = 0; n < spectrum.rows; ++n)
    for (std::size_t m = 0; m < spectrum.columns; ++m, ++k) {
      const double f = std::hypot(spectrum.frequencyX(m), spectrum.frequencyY(n));
      const auto ring = static_cast<std::size_t>(f / step + 0.5);
      if (k == 0 || f > highest * (1 + 1e-12) || ring >= rings) continue;
      // The highest frequency of an even number stands for two of half its value.
      const double share = (isHighest(m, spectrum.columns) ? 0.5 : 1) * (isHighest(n, spectrum.rows) ? 0.5 : 1);
      all.frequency[ring] += f;
      all.psd[ring] += share * spectrum.psd[k];
      ++all.counts[ring];
    }
  RadialSpectrum result;
  for (std::size_t ring = 0; ring < rings; ++ring) {
    if (all.counts[ring] == 0) continue;
    const auto count = static_cast<double>(all.counts[ring]);
    result.frequency.push_back(all.frequency[ring] / count);
    result.psd.push_back(all.psd[ring] / count);
    result.counts.push_back(all.counts[ring]);
  }
  return result;
}

SpectrumPointer measuredSpectrum(const HeightField& field, SpectrumWindow window, bool radial) {
  HeightSpectrum spectrum = spectrumOf(field, window);
  if (radial) return std::make_shared<RingSpectrum>(spectrum, radialAverage(spectrum));
  return std::make_shared<CellSpectrum>(std::move(spectrum));
}

SpectrumKind measuredSpectrumKind() {
  SpectrumKind kind{"measured", "Of the heights of a surface, by Fourier transform", {}, {}, {}, {}};
  kind.arguments = {"surface=SURFACE: a height field, such as heightfield(file=h.exr, depth=1, spacing=0.1)",
                    "window=none|hann: hann where the edges of the surface do not fit",
                    "average=radial|none: over all directions, of isotropic surfaces"};
  kind.references = {{"J. M. Elson and J. M. Bennett", 1995,
                      "Calculation of the power spectral density from surface profile data", "Appl. Opt. 34, 201-208",
                      "10.1364/AO.34.000201", ""}};
  kind.make = [](const Call& call) {
    CallArguments arguments(call);
    const auto expression = arguments.text("surface");
    const std::string window = arguments.choice("window", {"none", "hann"});
    const std::string average = arguments.choice("average", {"radial", "none"});
    arguments.finish();
    if (!expression) arguments.fail("surface", "must be given", "nothing", "surface=SURFACE");
    const MadeSurface made = makeSurface(*expression);
    const auto* field = std::get_if<HeightField>(&made.surface.shape);
    if (!field) arguments.fail("surface", "no height field", "'" + *expression + "'", "a surface of heights at nodes");
    return measuredSpectrum(*field, window == "hann" ? SpectrumWindow::Hann : SpectrumWindow::None,
                            average == "radial");
  };
  return kind;
}

}  // namespace brdf
