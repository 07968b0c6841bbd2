#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/models/CallArguments.h>
#include <brdf/simulate/BesselIntegral.h>
#include <brdf/simulate/MeasuredSpectrum.h>
#include <brdf/simulate/Spectrum.h>

#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace brdf {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double square(double x) { return x * x; }

void demand(bool good, const char* what, const char* where, double found, const char* allowed) {
  if (!good) throw Error(Error::Kind::Value, {what, where, formatNumber(found), allowed});
}

class AbcSpectrum : public Spectrum {
 public:
  AbcSpectrum(double a, double b, double c) : a_(a), b_(b), c_(c) {}

  void evaluate(const double* fx, const double* fy, double* psd, std::size_t count) const override {
    const double bb = b_ * b_, exponent = -c_ / 2;
    for (std::size_t k = 0; k < count; ++k)
      psd[k] = a_ * std::exp(exponent * std::log1p(bb * (fx[k] * fx[k] + fy[k] * fy[k])));
  }
  double variance() const override {
    if (a_ == 0) return 0;
    return c_ > 2 && b_ > 0 ? 2 * kPi * a_ / (b_ * b_ * (c_ - 2)) : kInfinity;
  }
  double autocovariance(double x, double y) const override {
    const double total = variance();
    demand(std::isfinite(total), "no autocovariance: infinite variance", "spectrum abc", c_, "c > 2");
    const double u = 2 * kPi * std::hypot(x, y) / b_, nu = c_ / 2 - 1;
    // (u/2)^nu K_nu(u) tends to Gamma(nu)/2 and underflows beyond u = 700.
    if (u == 0 || total == 0) return total;
    if (u > 700) return 0;
    if (nu * std::log(2 / u) + std::lgamma(nu) > 700) return total;
    return total * 2 * std::exp(nu * std::log(u / 2) - std::lgamma(nu)) * boost::math::cyl_bessel_k(nu, u);
  }
  bool isotropic() const override { return true; }
  std::string description() const override {
    return "abc(a=" + formatNumber(a_) + ", b=" + formatNumber(b_) + ", c=" + formatNumber(c_) + ")";
  }

 private:
  double a_, b_, c_;
};

class GaussianSpectrum : public Spectrum {
 public:
  GaussianSpectrum(double rms, double lengthX, double lengthY) : rms_(rms), lengthX_(lengthX), lengthY_(lengthY) {}

  void evaluate(const double* fx, const double* fy, double* psd, std::size_t count) const override {
    const double peak = kPi * rms_ * rms_ * lengthX_ * lengthY_;
    const double xx = square(kPi * lengthX_), yy = square(kPi * lengthY_);
    for (std::size_t k = 0; k < count; ++k) psd[k] = peak * std::exp(-xx * fx[k] * fx[k] - yy * fy[k] * fy[k]);
  }
  double variance() const override { return rms_ * rms_; }
  double autocovariance(double x, double y) const override {
    return rms_ * rms_ * std::exp(-square(x / lengthX_) - square(y / lengthY_));
  }
  std::optional<Gaussian> gaussian() const override { return Gaussian{rms_, lengthX_, lengthY_}; }
  bool isotropic() const override { return lengthX_ == lengthY_; }
  std::string description() const override {
    return "gaussian(rms=" + formatNumber(rms_) + ", correlation=" + formatNumber(lengthX_) +
           (isotropic() ? "" : ", correlation_y=" + formatNumber(lengthY_)) + ")";
  }

 private:
  double rms_, lengthX_, lengthY_;
};

class FractalSpectrum : public Spectrum {
 public:
  FractalSpectrum(double a, double exponent, double corner) : a_(a), exponent_(exponent), corner_(corner) {}

  void evaluate(const double* fx, const double* fy, double* psd, std::size_t count) const override {
    for (std::size_t k = 0; k < count; ++k)
      psd[k] = a_ == 0 ? 0 : a_ * std::pow(std::max(std::hypot(fx[k], fy[k]), corner_), -exponent_);
  }
  double variance() const override {
    if (a_ == 0) return 0;
    // A disk of the corner's value, and the power law outside.
    if (!(exponent_ > 2 && corner_ > 0)) return kInfinity;
    return kPi * a_ * std::pow(corner_, 2 - exponent_) * (1 + 2 / (exponent_ - 2));
  }
  /// Of the disk below the corner and of the power law beyond.
  double autocovariance(double x, double y) const override {
    const double total = variance();
    demand(std::isfinite(total), "no autocovariance: infinite variance", "spectrum fractal", exponent_,
           "exponent > 2 and corner > 0");
    const double r = std::hypot(x, y), u = 2 * kPi * corner_ * r, m = exponent_ - 1;
    // 1 - rho is of the order of u^2 or u^(exponent - 2).
    if (total == 0 || std::pow(u, std::min(2.0, exponent_ - 2)) < 1e-18) return total;
    const double disk = u < 1e-8 ? 1 : 2 * std::cyl_bessel_j(1.0, u) / u;
    const double power = 2 / u * besselIntegralBeyond(m, u);
    return kPi * a_ * std::pow(corner_, 2 - exponent_) * (disk + power);
  }
  std::optional<PowerLaw> powerLaw() const override {
    if (corner_ > 0) return {};
    return PowerLaw{a_, exponent_};
  }
  bool isotropic() const override { return true; }
  std::string description() const override {
    return "fractal(a=" + formatNumber(a_) + ", exponent=" + formatNumber(exponent_) +
           ", corner=" + formatNumber(corner_) + ")";
  }

 private:
  double a_, exponent_, corner_;
};

class SpectrumSum : public Spectrum {
 public:
  explicit SpectrumSum(std::vector<SpectrumPointer> parts) : parts_(std::move(parts)) {}

  void evaluate(const double* fx, const double* fy, double* psd, std::size_t count) const override {
    constexpr std::size_t block = 256;
    double part[block];
    std::fill_n(psd, count, 0.0);
    for (const SpectrumPointer& one : parts_)
      for (std::size_t first = 0; first < count; first += block) {
        const std::size_t length = std::min(block, count - first);
        one->evaluate(fx + first, fy + first, part, length);
        for (std::size_t k = 0; k < length; ++k) psd[first + k] += part[k];
      }
  }
  double variance() const override {
    double sum = 0;
    for (const SpectrumPointer& one : parts_) sum += one->variance();
    return sum;
  }
  double autocovariance(double x, double y) const override {
    double sum = 0;
    for (const SpectrumPointer& one : parts_) sum += one->autocovariance(x, y);
    return sum;
  }
  bool isotropic() const override {
    return std::ranges::all_of(parts_, [](const SpectrumPointer& one) { return one->isotropic(); });
  }
  std::string description() const override {
    std::vector<std::string> texts;
    for (const SpectrumPointer& one : parts_) texts.push_back(one->description());
    return "sum(" + joined(texts) + ")";
  }

 private:
  std::vector<SpectrumPointer> parts_;
};

Parameter record(std::string name, std::string symbol, std::string unit, std::string description, double value,
                 double minimum, double maximum, double softMinimum, double softMaximum, std::string follows = {}) {
  Parameter p;
  p.name = p.label = std::move(name);
  p.symbol = std::move(symbol);
  p.unit = std::move(unit);
  p.description = std::move(description);
  p.defaultValue = value;
  p.minimum = minimum;
  p.maximum = maximum;
  p.softMinimum = softMinimum;
  p.softMaximum = softMaximum;
  p.follows = std::move(follows);
  p.scale = Parameter::Scale::Logarithmic;
  return p;
}

SpectrumKind abcKind() {
  SpectrumKind kind{"abc", "K-correlation: a / (1 + (b f)^2)^(c/2)", {}, {}, {}, {}};
  kind.parameters = {
      record("a", "A", "um^4", "PSD at low frequencies.", 0.01, 0, 1e12, 1e-8, 10),
      record("b", "B", "um", "2 pi times the correlation length: frequencies above 1/b fall off.", 5, 0, 1e9, 0.1,
             1000),
      record("c", "C", "1", "Exponent of the fall-off; the variance is finite above 2.", 3, 1e-3, 1000, 2.05, 6)};
  kind.references = {{"E. L. Church and P. Z. Takacs", 1991, "The optimal estimation of finish parameters",
                      "Proc. SPIE 1530, 71-85", "10.1117/12.50498", ""}};
  kind.make = [parameters = kind.parameters](const Call& call) {
    CallArguments arguments(call);
    const double a = arguments.number(parameters[0]), b = arguments.number(parameters[1]),
                 c = arguments.number(parameters[2]);
    arguments.finish();
    return abcSpectrum(a, b, c);
  };
  return kind;
}

SpectrumKind gaussianKind() {
  SpectrumKind kind{"gaussian", "Gaussian autocovariance rms^2 exp(-(r/correlation)^2)", {}, {}, {}, {}};
  kind.parameters = {record("rms", "sigma", "um", "Root mean square height.", 0.005, 0, 1e6, 1e-4, 1),
                     record("correlation", "L", "um", "Distance at which the autocovariance falls to 1/e, along x.", 1,
                            1e-6, 1e6, 0.05, 100),
                     record("correlation_y", "L_y", "um", "The same along y; as along x where it is not given.", 1,
                            1e-6, 1e6, 0.05, 100, "correlation")};
  kind.references = {{"P. Beckmann and A. Spizzichino", 1963,
                      "The Scattering of Electromagnetic Waves from Rough Surfaces", "Pergamon Press, section 5.3", "",
                      ""}};
  kind.make = [parameters = kind.parameters](const Call& call) {
    CallArguments arguments(call);
    const double rms = arguments.number(parameters[0]), x = arguments.number(parameters[1]);
    const double y = arguments.number(parameters[2]);
    arguments.finish();
    return gaussianSpectrum(rms, x, arguments.given("correlation_y") ? y : x);
  };
  return kind;
}

SpectrumKind fractalKind() {
  SpectrumKind kind{"fractal", "Power law a / max(f, corner)^exponent", {}, {}, {}, {}};
  kind.parameters = {
      record("a", "A", "um^(4-exponent)", "PSD at f = 1/um.", 0.01, 0, 1e12, 1e-8, 10),
      record("exponent", "n", "1", "Power of the frequency.", 2.5, 1e-3, 100, 1, 4),
      record("corner", "f_0", "1/um", "Frequency below which it is flat; 0: nowhere, and infinite at 0.", 0.01, 0, 1e6,
             1e-4, 1),
  };
  kind.references = {
      {"E. L. Church", 1988, "Fractal surface finish", "Appl. Opt. 27, 1518-1526", "10.1364/AO.27.001518", ""}};
  kind.make = [parameters = kind.parameters](const Call& call) {
    CallArguments arguments(call);
    const double a = arguments.number(parameters[0]), exponent = arguments.number(parameters[1]);
    const double corner = arguments.number(parameters[2]);
    arguments.finish();
    return fractalSpectrum(a, exponent, corner);
  };
  return kind;
}

SpectrumKind sumKind() {
  SpectrumKind kind{"sum", "Sum of spectra: uncorrelated kinds of roughness on one surface", {}, {}, {}, {}};
  kind.arguments = {"SPECTRUM, ...: the parts"};
  kind.make = [](const Call& call) {
    CallArguments arguments(call);
    std::vector<SpectrumPointer> parts;
    for (const Call::Argument& argument : arguments.unnamed())
      parts.push_back(makeSpectrum(parseCall(argument.text, call.what, argument.column)));
    arguments.finish();
    return sumOfSpectra(std::move(parts));
  };
  return kind;
}

std::vector<SpectrumKind>& kinds() {
  static std::vector<SpectrumKind> all{abcKind(), gaussianKind(), fractalKind(), sumKind(), measuredSpectrumKind()};
  return all;
}

}  // namespace

Spectrum::~Spectrum() = default;

SpectrumPointer abcSpectrum(double a, double b, double c) {
  demand(a >= 0 && std::isfinite(a), "a of the spectrum out of bounds", "spectrum abc", a, ">= 0 um^4");
  demand(b >= 0 && std::isfinite(b), "b of the spectrum out of bounds", "spectrum abc", b, ">= 0 um");
  demand(c > 0 && std::isfinite(c), "c of the spectrum out of bounds", "spectrum abc", c, "> 0");
  return std::make_shared<AbcSpectrum>(a, b, c);
}

SpectrumPointer gaussianSpectrum(double rms, double correlationX, double correlationY) {
  demand(rms >= 0 && std::isfinite(rms), "rms of the spectrum out of bounds", "spectrum gaussian", rms, ">= 0 um");
  for (const double length : {correlationX, correlationY})
    demand(length > 0 && std::isfinite(length), "correlation length out of bounds", "spectrum gaussian", length,
           "> 0 um");
  return std::make_shared<GaussianSpectrum>(rms, correlationX, correlationY);
}

SpectrumPointer fractalSpectrum(double a, double exponent, double corner) {
  demand(a >= 0 && std::isfinite(a), "a of the spectrum out of bounds", "spectrum fractal", a, ">= 0");
  demand(exponent > 0 && std::isfinite(exponent), "exponent of the spectrum out of bounds", "spectrum fractal",
         exponent, "> 0");
  demand(corner >= 0 && std::isfinite(corner), "corner of the spectrum out of bounds", "spectrum fractal", corner,
         ">= 0 1/um");
  return std::make_shared<FractalSpectrum>(a, exponent, corner);
}

SpectrumPointer sumOfSpectra(std::vector<SpectrumPointer> parts) {
  if (parts.empty()) throw Error(Error::Kind::Value, {"no parts", "spectrum sum", "none", "at least one spectrum"});
  return std::make_shared<SpectrumSum>(std::move(parts));
}

const std::vector<SpectrumKind>& spectrumKinds() { return kinds(); }

void registerSpectrumKind(SpectrumKind kind) {
  const auto same = std::ranges::find(kinds(), kind.name, &SpectrumKind::name);
  if (same != kinds().end())
    *same = std::move(kind);
  else
    kinds().push_back(std::move(kind));
}

SpectrumPointer makeSpectrum(const Call& call) {
  std::vector<std::string> names;
  for (const SpectrumKind& kind : spectrumKinds()) {
    if (kind.name == call.name) return kind.make(call);
    names.push_back(kind.name);
  }
  const std::string nearest = closestName(call.name, names);
  throw Error(Error::Kind::Value, {"unknown spectrum", call.where(call.column), "'" + call.name + "'",
                                   joined(names) + (nearest.empty() ? "" : " (did you mean " + nearest + "?)")});
}

SpectrumPointer makeSpectrum(std::string_view expression) { return makeSpectrum(parseCall(expression, "spectrum")); }

}  // namespace brdf
