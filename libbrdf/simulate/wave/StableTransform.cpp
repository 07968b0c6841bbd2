#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/wave/CubicWeights.h>
#include <brdf/simulate/wave/LogHankel.h>
#include <brdf/simulate/wave/PhaseTransform.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace brdf::wave {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLeastAlpha = 0.02;
constexpr double kFirst = 1e-16;
constexpr double kFar = 60;  // where the series begins: 2 pi R f
constexpr std::size_t kCount = 1024;

/// PSD = a / f^(alpha + 2): kappa^2 times half the mean square difference of heights is (r / R)^alpha, so that Phi is
/// R^2 psi(R f), psi the transform of exp(-r^alpha): the density of a stable law of index alpha in two dimensions.
class StableTransform : public PhaseTransform {
 public:
  explicit StableTransform(const Spectrum::PowerLaw& law) : alpha_(law.exponent - 2) {
    // 2 pi times the integral of a f^(-1 - alpha) (1 - J0(2 pi f r)) df is growth r^alpha (DLMF 10.22.43, continued).
    growth_ =
        2 * std::pow(kPi, 1 + alpha_) * law.a * std::tgamma(1 - alpha_ / 2) / (alpha_ * std::tgamma(1 + alpha_ / 2));
    // r^2 exp(-r^alpha) d ln r is a Gamma law of r^alpha with shape 2/alpha, gone to 1e-16; below the frequencies of
    // three decades beyond that psi is level.
    const double shape = 2 / alpha_, last = 1e3 * std::pow(shape + 10 * std::sqrt(shape) + 40, 1 / alpha_);
    step_ = std::log(last / kFirst) / (kCount - 1);
    const LogHankel hankel(kFirst, step_, kCount);
    std::vector<double> values;
    for (const double r : hankel.distances()) values.push_back(std::exp(-std::pow(r, alpha_)));
    const std::vector<double> transformed = hankel.transform(values);
    least_ = std::log(2 * kPi * hankel.frequencies().front());
    for (std::size_t j = 0; j < kCount && 2 * kPi * hankel.frequencies()[j] < 2 * kFar; ++j)
      logs_.push_back(std::log(std::max(transformed[j], 1e-300)));
  }

  void evaluate(const double* kappa, const double* fx, const double* fy, double* phi,
                std::size_t count) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const double growth = growth_ * kappa[k] * kappa[k];
      if (!(growth > 0)) {
        phi[k] = 0;
        continue;
      }
      const double logScale = -std::log(growth) / alpha_;
      const double q = std::log(2 * kPi * std::hypot(fx[k], fy[k])) + logScale;
      const double value = q < std::log(kFar) ? std::exp(2 * logScale + interpolated(q))
                                              : series(q) / (4 * kPi * kPi * (fx[k] * fx[k] + fy[k] * fy[k]));
      phi[k] = std::min(value, std::numeric_limits<double>::max());
    }
  }

 private:
  double interpolated(double q) const {
    const double place = std::clamp((q - least_) / step_, 0.0, static_cast<double>(logs_.size() - 1));
    const auto j = std::clamp<std::size_t>(static_cast<std::size_t>(place), 1, logs_.size() - 3);
    const auto w = cubicWeights(place - static_cast<double>(j));
    return w[0] * logs_[j - 1] + w[1] * logs_[j] + w[2] * logs_[j + 1] + w[3] * logs_[j + 2];
  }

  /// Of exp(-r^alpha) term by term: sum of (-1)^(m + 1) / m! 4 Gamma(1 + z)^2 sin(pi z) (2 / q)^(2 z) / q^2, z = alpha
  /// m/2; convergent for alpha < 1, asymptotic beyond (H. Bergstrom, Ark. Mat. 2, 375-378 (1952), in two dimensions).
  double series(double logQ) const {
    const double x = std::log(2.0) - logQ;
    double sum = 0, least = 1e300;
    for (int m = 1; m < 200; ++m) {
      const double z = alpha_ * m / 2, size = std::exp(2 * std::lgamma(1 + z) - std::lgamma(m + 1.0) + 2 * z * x);
      if (size > least || size < 1e-17 * std::abs(sum)) break;
      least = size;
      sum += (m % 2 ? size : -size) * std::sin(kPi * z);
    }
    return 4 * sum;
  }

  double alpha_, growth_;
  double step_ = 1, least_ = 0;  ///< of ln(2 pi R f)
  std::vector<double> logs_;     ///< ln psi
};

}  // namespace

PhaseTransformPointer stableTransform(const SpectrumPointer& spectrum) {
  const auto law = spectrum->powerLaw();
  if (!law || !(law->exponent >= 2 + kLeastAlpha && law->exponent < 4))
    throw Error(Error::Kind::Value,
                {"theories of any height need heights whose differences are finite", "wave model",
                 spectrum->description(), "an exponent from 2.02 to 4 (exclusive) where corner = 0, or RayleighRice"});
  return std::make_shared<StableTransform>(*law);
}

}  // namespace brdf::wave
