#include "Workshop.h"

#include <algorithm>
#include <cmath>

namespace workshop {
namespace {

// Below this f cos (1/sr) the slope is that at this value: the root's own is infinite at 0.
constexpr double kSmallestForSlope = 1e-6;

double fourthRoot(double x) { return std::copysign(std::sqrt(std::sqrt(std::abs(x))), x); }

class FourthRootMetric final : public brdf::Metric {
 public:
  FourthRootMetric() {
    name_ = "fourth_root";
    formula_ = "(f cos(theta_i))^(1/4) - (t cos(theta_i))^(1/4)";
    source_ = "an example";
  }
  void residual(const double* f, const double* target, const brdf::DirectionPairs<double>& pairs,
                double* r) const override {
    for (std::size_t i = 0; i < pairs.count; ++i)
      r[i] = fourthRoot(f[i] * pairs.wi[2][i]) - fourthRoot(target[i] * pairs.wi[2][i]);
  }
  void slope(const double* f, const double*, const brdf::DirectionPairs<double>& pairs, double* slope) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const double x = std::max(std::abs(f[i] * pairs.wi[2][i]), kSmallestForSlope);
      slope[i] = 0.25 * std::sqrt(std::sqrt(x)) / x * pairs.wi[2][i];
    }
  }
};

}  // namespace

brdf::MetricPointer fourthRootMetric() { return std::make_shared<FourthRootMetric>(); }

}  // namespace workshop
