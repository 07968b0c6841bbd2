#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/Fit.h>
#include <brdf/fit/Metric.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

// The logarithm needs 1 + f cos > 0. Measured noise below zero is far from -1; what is not is taken for this.
constexpr double kLowestForLog = -0.999999;
// Below this |f cos| (1/sr) the slope of the cube root is that at this value: a hundred thousandth of a white diffuser.
constexpr double kSmallestForCubeRootSlope = 1e-6;

void copyValues(const double* f, const double*, std::size_t count, double* g) { std::copy_n(f, count, g); }
void ones(const double*, const double*, std::size_t count, double* slope) { std::fill_n(slope, count, 1.0); }

void timesCosine(const double* f, const double* cosine, std::size_t count, double* g) {
  for (std::size_t i = 0; i < count; ++i) g[i] = f[i] * cosine[i];
}
void cosines(const double*, const double* cosine, std::size_t count, double* slope) {
  std::copy_n(cosine, count, slope);
}
void overCosine(const double* g, const double* cosine, std::size_t count, double* f) {
  for (std::size_t i = 0; i < count; ++i) f[i] = g[i] / cosine[i];
}

void logarithm(const double* f, const double* cosine, std::size_t count, double* g) {
  for (std::size_t i = 0; i < count; ++i) g[i] = std::log1p(std::max(f[i] * cosine[i], kLowestForLog));
}
void logarithmSlope(const double* f, const double* cosine, std::size_t count, double* slope) {
  for (std::size_t i = 0; i < count; ++i) slope[i] = cosine[i] / (1 + std::max(f[i] * cosine[i], kLowestForLog));
}
void logarithmInverse(const double* g, const double* cosine, std::size_t count, double* f) {
  for (std::size_t i = 0; i < count; ++i) f[i] = std::expm1(g[i]) / cosine[i];
}

void cubeRoot(const double* f, const double* cosine, std::size_t count, double* g) {
  for (std::size_t i = 0; i < count; ++i) g[i] = std::cbrt(f[i] * cosine[i]);
}
void cubeRootSlope(const double* f, const double* cosine, std::size_t count, double* slope) {
  for (std::size_t i = 0; i < count; ++i) {
    const double root = std::cbrt(std::max(std::abs(f[i] * cosine[i]), kSmallestForCubeRootSlope));
    slope[i] = cosine[i] / (3 * root * root);
  }
}
void cubeRootInverse(const double* g, const double* cosine, std::size_t count, double* f) {
  for (std::size_t i = 0; i < count; ++i) f[i] = g[i] * g[i] * g[i] / cosine[i];
}

constexpr Metric kMetrics[] = {
    {"rms", "f", "least squares", true, copyValues, ones, copyValues},
    {"rms_cos", "f cos(theta_i)",
     "Ngan, Durand, Matusik 2005, Experimental Analysis of BRDF Models, section 3, without "
     "its solid-angle weight",
     true, timesCosine, cosines, overCosine},
    {"log", "ln(1 + f cos(theta_i))",
     "Low, Kronander, Ynnerman, Unger 2012, BRDF Models for Accurate and Efficient "
     "Rendering of Glossy Surfaces, doi:10.1145/2077341.2077350",
     false, logarithm, logarithmSlope, logarithmInverse},
    {"cuberoot", "cbrt(f cos(theta_i))",
     "Fores, Ferwerda, Gu 2012, Toward a Perceptually Based Metric for BRDF "
     "Modeling, CIC20",
     false, cubeRoot, cubeRootSlope, cubeRootInverse},
};

}  // namespace

std::span<const Metric> allMetrics() { return kMetrics; }

std::vector<std::string> metricNames() {
  std::vector<std::string> names;
  for (const Metric& metric : kMetrics) names.emplace_back(metric.name);
  return names;
}

const Metric& findMetric(std::string_view name) {
  const auto found = std::ranges::find(kMetrics, name, &Metric::name);
  if (found == std::end(kMetrics))
    throw Error(Error::Kind::Value, {"unknown metric", "metric", std::string(name), joined(metricNames())});
  return *found;
}

}  // namespace brdf
