// The integral of a microfacet distribution.
#include <brdf/check/Normalisation.h>

#include <brdf/geometry/Directions.h>

#include <cmath>
#include <vector>

namespace brdf {
namespace {

// The range of log tan: 1e-11 of a lobe stretched by 1e6 lies outside. The step: analytic within pi/4 of the real axis,
// as exp(-tan^2) is, the rule errs by exp(-2 pi (pi/4)/step), 2e-11. A distribution may fall as exp(-tan^10), analytic
// within pi/20 only: a quarter of the step in theta, 3e-9.
constexpr double kLow = -40, kHigh = 40, kStep = 0.2, kPolarStep = 0.05;
constexpr auto kSteps = static_cast<std::size_t>((kHigh - kLow) / kStep);
constexpr auto kPolarSteps = static_cast<std::size_t>((kHigh - kLow) / kPolarStep);

double logarithm(std::size_t k, double step) { return kLow + (static_cast<double>(k) + 0.5) * step; }

}  // namespace

double distributionIntegral(const FormulaModel& model, std::size_t which, std::span<const double> parameters) {
  // d theta cos sin = t^2/(1 + t^2)^2 d log t for t = tan theta, and d phi = T/(1 + T^2) d log T for T = tan phi.
  const std::size_t turns = model.isotropic() ? 1 : 4 * kSteps;
  std::vector<double> h[3], weights, values;
  for (auto& axis : h) axis.resize(turns);
  weights.resize(turns);
  values.resize(turns);
  double sum = 0;
  for (std::size_t k = 0; k < kPolarSteps; ++k) {
    const double t = std::exp(logarithm(k, kPolarStep)), cosine = 1 / std::sqrt(1 + t * t), sine = t * cosine;
    for (std::size_t j = 0; j < turns; ++j) {
      double c = 1, s = 0, arc = 2 * kPi;
      if (turns > 1) {
        const double T = std::exp(logarithm(j / 4, kStep));
        c = 1 / std::sqrt(1 + T * T);
        s = T * c;
        arc = s * c * kStep;
        if (j % 4 > 1) c = -c;
        if (j % 2 > 0) s = -s;
      }
      h[0][j] = sine * c;
      h[1][j] = sine * s;
      h[2][j] = cosine;
      weights[j] = sine * sine * cosine * cosine * kPolarStep * arc;
    }
    model.evaluateDistribution(which, {h[0].data(), h[1].data(), h[2].data()}, parameters, values.data(), turns);
    for (std::size_t j = 0; j < turns; ++j) sum += weights[j] * values[j];
  }
  return sum;
}

}  // namespace brdf
