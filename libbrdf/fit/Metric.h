#pragma once
#include <brdf/brdf_export.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace brdf {

/// A measure of the difference between two BRDFs: the root mean square of g(a) - g(b) over samples and channels, where
/// g(f, cos theta_i) is given here for arrays of `count` values f in 1/sr and cosines > 0. The same records serve fit
/// and compare. All functions are finite for every finite f.
struct Metric {
  std::string_view name;     ///< as on the command line
  std::string_view formula;  ///< g, for people
  std::string_view source;   ///< who proposed it
  /// g is linear in f: g = w(cos theta_i) f, so that scale factors follow by linear least squares.
  bool quadratic;
  void (*transform)(const double* f, const double* cosine, std::size_t count, double* g);
  /// dg/df. Where g' is infinite (cube root at 0) it is capped: it then only shapes the steps of the optimizer, and the
  /// value of the metric stays exact.
  void (*derivative)(const double* f, const double* cosine, std::size_t count, double* slope);
  /// f of which g is the transform.
  void (*inverse)(const double* g, const double* cosine, std::size_t count, double* f);
};

/// All metrics, the plain one first.
BRDF_EXPORT std::span<const Metric> allMetrics();
/// The metric called `name`; throws Error::Kind::Value with the allowed names.
BRDF_EXPORT const Metric& findMetric(std::string_view name);

}  // namespace brdf
