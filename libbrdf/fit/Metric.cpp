#include <brdf/base/Error.h>
#include <brdf/base/Plugins.h>
#include <brdf/base/Text.h>
#include <brdf/fit/Fit.h>
#include <brdf/fit/FormulaMetric.h>
#include <brdf/fit/Metric.h>
#include <brdf/fit/SpherePicture.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

// The logarithm needs 1 + f cos > 0. Measured noise below zero is far from -1; what is not is taken for this.
constexpr double kLowestForLog = -0.999999;
// Below this |f cos| (1/sr) the slope of the cube root is that at this value: a hundred thousandth of a white diffuser.
constexpr double kSmallestForCubeRootSlope = 1e-6;
// Where the target is below this (1/sr, a third of a percent of a white diffuser) the relative metric takes it for
// this: there the noise of measurements is as large as what they measure.
constexpr double kRelativeFloor = 1e-3;

/// r = w (f - t).
class RmsMetric final : public Metric {
 public:
  RmsMetric() {
    name_ = "rms";
    formula_ = "f - t";
    unit_ = "1/sr";
    source_ = "least squares";
    quadratic_ = true;
  }
  void residual(const double* f, const double* target, const DirectionPairs<double>& pairs, double* r) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) r[i] = f[i] - target[i];
  }
  void slope(const double*, const double*, const DirectionPairs<double>& pairs, double* slope) const override {
    std::fill_n(slope, pairs.count, 1.0);
  }
};

class CosineMetric final : public Metric {
 public:
  explicit CosineMetric(bool solidAngle) {
    name_ = solidAngle ? "ngan" : "rms_cos";
    unit_ = "1/sr";
    formula_ = solidAngle ? "(f - t) cos(theta_i), samples weighted by their solid angle" : "(f - t) cos(theta_i)";
    source_ =
        "Ngan, Durand, Matusik 2005, Experimental Analysis of BRDF Models, section 3, "
        "doi:10.2312/EGWR/EGSR05/117-126";
    if (!solidAngle) source_ += ", without its solid-angle weight";
    quadratic_ = true;
    bySolidAngle_ = solidAngle;
  }
  void residual(const double* f, const double* target, const DirectionPairs<double>& pairs, double* r) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) r[i] = (f[i] - target[i]) * pairs.wi[2][i];
  }
  void slope(const double*, const double*, const DirectionPairs<double>& pairs, double* slope) const override {
    std::copy_n(pairs.wi[2], pairs.count, slope);
  }
};

class RelativeMetric final : public Metric {
 public:
  RelativeMetric(std::string name, double floor) : floor_(floor) {
    name_ = std::move(name);
    formula_ = "(f - t) / max(|t|, " + formatNumber(floor) + "/sr)";
    source_ = "least squares with fixed weights";
    quadratic_ = weighsByTarget_ = true;
  }
  void residual(const double* f, const double* target, const DirectionPairs<double>& pairs, double* r) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) r[i] = (f[i] - target[i]) / std::max(std::abs(target[i]), floor_);
  }
  void slope(const double*, const double* target, const DirectionPairs<double>& pairs, double* slope) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) slope[i] = 1 / std::max(std::abs(target[i]), floor_);
  }

 private:
  double floor_;
};

class LogMetric final : public Metric {
 public:
  LogMetric() {
    name_ = "log";
    formula_ = "ln(1 + f cos(theta_i)) - ln(1 + t cos(theta_i))";
    source_ =
        "Low, Kronander, Ynnerman, Unger 2012, BRDF Models for Accurate and Efficient Rendering of Glossy Surfaces, "
        "doi:10.1145/2077341.2077350";
  }
  void prepare(const double* values, const DirectionPairs<double>& pairs, double* target) const override {
    for (std::size_t i = 0; i < pairs.count; ++i)
      target[i] = std::log1p(std::max(values[i] * pairs.wi[2][i], kLowestForLog));
  }
  void restore(const double* target, const DirectionPairs<double>& pairs, double* values) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) values[i] = std::expm1(target[i]) / pairs.wi[2][i];
  }
  void residual(const double* f, const double* target, const DirectionPairs<double>& pairs, double* r) const override {
    for (std::size_t i = 0; i < pairs.count; ++i)
      r[i] = std::log1p(std::max(f[i] * pairs.wi[2][i], kLowestForLog)) - target[i];
  }
  void slope(const double* f, const double*, const DirectionPairs<double>& pairs, double* slope) const override {
    for (std::size_t i = 0; i < pairs.count; ++i)
      slope[i] = pairs.wi[2][i] / (1 + std::max(f[i] * pairs.wi[2][i], kLowestForLog));
  }
};

class CubeRootMetric final : public Metric {
 public:
  CubeRootMetric() {
    name_ = "cuberoot";
    unit_ = "sr^-1/3";
    formula_ = "cbrt(f cos(theta_i)) - cbrt(t cos(theta_i))";
    source_ = "Fores, Ferwerda, Gu 2012, Toward a Perceptually Based Metric for BRDF Modeling, CIC20";
  }
  void prepare(const double* values, const DirectionPairs<double>& pairs, double* target) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) target[i] = std::cbrt(values[i] * pairs.wi[2][i]);
  }
  void restore(const double* target, const DirectionPairs<double>& pairs, double* values) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) values[i] = target[i] * target[i] * target[i] / pairs.wi[2][i];
  }
  void residual(const double* f, const double* target, const DirectionPairs<double>& pairs, double* r) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) r[i] = std::cbrt(f[i] * pairs.wi[2][i]) - target[i];
  }
  void slope(const double* f, const double*, const DirectionPairs<double>& pairs, double* slope) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const double root = std::cbrt(std::max(std::abs(f[i] * pairs.wi[2][i]), kSmallestForCubeRootSlope));
      slope[i] = pairs.wi[2][i] / (3 * root * root);
    }
  }
};

/// r^2 = 2 rho(f - t), rho Huber's function: a residual whose square grows linearly beyond delta.
class HuberMetric final : public Metric {
 public:
  /// `delta` 0: it is taken from the data.
  HuberMetric(std::string name, double delta) : delta_(delta) {
    name_ = std::move(name);
    const std::string text = delta > 0 ? formatNumber(delta) + "/sr" : "the median of |t|";
    formula_ = "d = f - t where |d| <= delta, beyond it sign(d) sqrt(2 delta |d| - delta^2); delta = " + text;
    unit_ = "1/sr";
    source_ = "Huber 1964, Robust Estimation of a Location Parameter, doi:10.1214/aoms/1177703732";
    needsScale_ = !(delta > 0);
  }
  MetricPointer scaledTo(double typical) const override { return std::make_shared<HuberMetric>(name_, typical); }
  void residual(const double* f, const double* target, const DirectionPairs<double>& pairs, double* r) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const double d = f[i] - target[i], size = std::abs(d);
      r[i] = size <= delta_ ? d : std::copysign(std::sqrt(delta_) * std::sqrt(size + (size - delta_)), d);
    }
  }
  void slope(const double* f, const double* target, const DirectionPairs<double>& pairs, double* slope) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const double size = std::abs(f[i] - target[i]);
      slope[i] = size <= delta_ ? 1 : std::sqrt(delta_ / (size + (size - delta_)));
    }
  }

 private:
  double delta_;
};

/// The number after the colon of "name:number".
double argumentOf(std::string_view text, const char* meaning) {
  const std::string_view argument = trimmed(text.substr(text.find(':') + 1));
  const auto number = parseNumber(argument);
  if (!number || !(*number > 0) || !std::isfinite(*number))
    throw Error(Error::Kind::Value, {std::string("unusable ") + meaning + " of a metric", std::string(text),
                                     std::string(argument), "a number above 0, 1/sr"});
  return *number;
}

}  // namespace

Metric::~Metric() = default;

void Metric::prepare(const double* values, const DirectionPairs<double>& pairs, double* target) const {
  std::copy_n(values, pairs.count, target);
}
void Metric::restore(const double* target, const DirectionPairs<double>& pairs, double* values) const {
  std::copy_n(target, pairs.count, values);
}
MetricPointer Metric::scaledTo(double) const { return nullptr; }

static std::vector<MetricPointer>& metricRegistry() {
  static std::vector<MetricPointer> metrics = {std::make_shared<RmsMetric>(),
                                               std::make_shared<CosineMetric>(false),
                                               std::make_shared<LogMetric>(),
                                               std::make_shared<CubeRootMetric>(),
                                               std::make_shared<CosineMetric>(true),
                                               std::make_shared<RelativeMetric>("relative", kRelativeFloor),
                                               std::make_shared<HuberMetric>("huber", 0)};
  return metrics;
}

const std::vector<MetricPointer>& allMetrics() {
  plugins();
  return metricRegistry();
}

void registerMetric(MetricPointer metric) {
  auto& metrics = metricRegistry();
  const auto same = std::ranges::find_if(metrics, [&](const MetricPointer& m) { return m->name() == metric->name(); });
  if (same != metrics.end())
    *same = std::move(metric);
  else
    metrics.push_back(std::move(metric));
}

std::vector<std::string> metricNames() {
  std::vector<std::string> names;
  for (const MetricPointer& metric : allMetrics()) names.push_back(metric->name());
  return names;
}

MetricPointer findMetric(std::string_view text) {
  const auto found = std::ranges::find_if(allMetrics(), [&](const MetricPointer& m) { return m->name() == text; });
  if (found != allMetrics().end()) return *found;
  if (text.starts_with("relative:"))
    return std::make_shared<RelativeMetric>(std::string(text), argumentOf(text, "floor"));
  if (text.starts_with("huber:")) return std::make_shared<HuberMetric>(std::string(text), argumentOf(text, "scale"));
  if (text == "sphere") return std::make_shared<SphereMetric>("sphere", nullptr);
  if (text.starts_with("sphere:")) {
    const std::string path(trimmed(text.substr(text.find(':') + 1)));
    return std::make_shared<SphereMetric>(std::string(text),
                                          std::make_shared<const EnvironmentMap>(EnvironmentMap::read(path)));
  }
  if (text.starts_with("formula:")) return makeFormulaMetric(text.substr(text.find(':') + 1));
  throw Error(Error::Kind::Value,
              {"unknown metric", "metric", std::string(text),
               joined(metricNames()) + ", relative:FLOOR, huber:DELTA, sphere, sphere:MAP, formula:TEXT"});
}

}  // namespace brdf
