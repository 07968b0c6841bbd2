#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/simulate/wave/CubicWeights.h>
#include <brdf/simulate/wave/Renormalization.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

namespace brdf::wave {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kAngles = 65, kAzimuths = 32;
constexpr double kPanel = 0.7, kLeast = 1e-10;  // of logarithms of direction cosines

double square(double x) { return x * x; }
double cosineOf(std::size_t k) { return square(static_cast<double>(k) / (kAngles - 1)); }
/// From a point at distance s < 1 of the centre of the unit disk to its edge, at azimuth phi.
double edgeOf(double s, double cosPhi) { return s * cosPhi + std::sqrt(1 - s * s * (1 - cosPhi * cosPhi)); }

}  // namespace

Renormalization::Renormalization(const SpectrumPointer& spectrum, const PhaseTransformPointer& transform,
                                 double wavelength, HarveyShackOptions options)
    : shares_(kAngles, 1.0), factors_(kAngles, 1.0) {
  if (!options.relevant && !options.renormalized) return;
  const char* what = options.relevant ? "relevant roughness" : "renormalisation";
  if (!spectrum->isotropic())
    throw Error(Error::Kind::Value, {std::string(what) + " is offered for isotropic spectra", "wave model",
                                     spectrum->description(), "an isotropic spectrum, or neither"});
  const double variance = spectrum->variance();
  if (variance == 0) return;
  if (options.relevant) {
    if (!std::isfinite(variance))
      throw Error(Error::Kind::Value, {"relevant roughness needs a finite variance", "wave model",
                                       spectrum->description(), "a spectrum of finite variance, or roughness=total"});
    findShares(*spectrum, wavelength);
  }
  if (options.renormalized) findFactors(*transform, variance, wavelength);
}

double Renormalization::interpolated(const std::vector<double>& values, double cosI) {
  const double place = std::sqrt(std::clamp(cosI, 0.0, 1.0)) * (kAngles - 1);
  const auto j = std::clamp<std::size_t>(static_cast<std::size_t>(place), 1, kAngles - 3);
  const auto w = cubicWeights(place - static_cast<double>(j));
  return std::max(0.0, w[0] * values[j - 1] + w[1] * values[j] + w[2] * values[j + 1] + w[3] * values[j + 2]);
}

void Renormalization::findShares(const Spectrum& spectrum, double wavelength) {
  // Variance within every frequency up to 2 / wavelength, at ends of panels of the logarithm.
  using Rule = boost::math::quadrature::gauss<double, 10>;
  const double top = std::log(2 / wavelength);
  const auto panels = static_cast<std::size_t>(std::log(1 / kLeast) / (kPanel / 4));
  const double width = kPanel / 4, bottom = top - width * static_cast<double>(panels);
  const auto ring = [&](double logF) {
    const double f = std::exp(logF);
    return 2 * kPi * f * f * spectrum.psd(f, 0);
  };
  std::vector<double> within{ring(bottom) / 2};
  for (std::size_t k = 0; k < panels; ++k) {
    const double start = bottom + width * static_cast<double>(k);
    within.push_back(within.back() + Rule::integrate(ring, start, start + width));
  }
  const auto varianceWithin = [&](double f) {
    const double place = std::max(0.0, (std::log(f) - bottom) / width);
    const auto j = std::clamp<std::size_t>(static_cast<std::size_t>(place), 1, within.size() - 3);
    const auto w = cubicWeights(place - static_cast<double>(j));
    return w[0] * within[j - 1] + w[1] * within[j] + w[2] * within[j + 1] + w[3] * within[j + 2];
  };
  for (std::size_t k = 0; k < kAngles; ++k) {
    const double sine = std::sqrt(1 - square(cosineOf(k)));
    double sum = 0;
    for (std::size_t a = 0; a < 4 * kAzimuths; ++a)
      sum += varianceWithin(
          std::max(kLeast, edgeOf(sine, std::cos(kPi * (static_cast<double>(a) + 0.5) / (4 * kAzimuths)))) /
          wavelength);
    shares_[k] = std::sqrt(std::clamp(sum / (4 * kAzimuths) / spectrum.variance(), 0.0, 1.0));
  }
}

void Renormalization::findFactors(const PhaseTransform& transform, double variance, double wavelength) {
  using Rule = boost::math::quadrature::gauss<double, 8>;
  parallelFor(kAngles, 1, [&](std::size_t begin, std::size_t end) {
    std::vector<double> kappa, fx, fy, weight, phi;
    for (std::size_t k = begin; k < end; ++k) {
      const double cosI = cosineOf(k), sine = std::sqrt(1 - cosI * cosI), share = shares_[k];
      kappa.clear(), fx.clear(), fy.clear(), weight.clear();
      const auto add = [&](double u, double azimuth, double w) {
        const double x = sine + u * std::cos(azimuth), y = u * std::sin(azimuth);
        const double cosS = std::sqrt(std::max(0.0, 1 - x * x - y * y));
        kappa.push_back(2 * kPi * (cosI + cosS) / wavelength * share);
        fx.push_back(u * std::cos(azimuth) / wavelength);
        fy.push_back(u * std::sin(azimuth) / wavelength);
        weight.push_back(w * u * 2 * kPi / kAzimuths / square(wavelength));
      };
      // Half the disk by rays from the mirror direction (sine, 0) to its edge: panels of the logarithm of their length
      // up to the middle, and one to the edge, where the cosine falls as a root.
      for (std::size_t a = 0; a < kAzimuths; ++a) {
        const double azimuth = kPi * (static_cast<double>(a) + 0.5) / kAzimuths;
        const double edge = edgeOf(sine, -std::cos(azimuth)), last = std::log(edge / 2);
        if (!(edge > 2 * kLeast)) continue;
        const auto panels = static_cast<std::size_t>(std::ceil((last - std::log(kLeast)) / kPanel));
        for (std::size_t node = 0; node < 8; ++node) {
          const double x = (node % 2 ? 1 : -1) * Rule::abscissa()[node / 2], w = Rule::weights()[node / 2] / 2;
          for (std::size_t panel = 0; panel < panels; ++panel) {
            const double u = std::exp(last - kPanel * (static_cast<double>(panel) + 0.5 + x / 2));
            add(u, azimuth, w * kPanel * u);
          }
          const double v = (1 + x) / 2;
          add(edge * (1 - v * v / 2), azimuth, w * edge * v);
        }
      }
      phi.resize(kappa.size());
      transform.evaluate(kappa.data(), fx.data(), fy.data(), phi.data(), kappa.size());
      double scattered = 0;
      for (std::size_t j = 0; j < phi.size(); ++j) scattered += weight[j] * phi[j];
      const double all = cosI > 0 ? -std::expm1(-square(4 * kPi * cosI * share / wavelength) * variance) : 0;
      factors_[k] = scattered > 0 ? all / scattered : 1;
    }
  });
}

}  // namespace brdf::wave
