#include <brdf/simulate/wave/Roughness.h>

#include <cmath>
#include <numbers>

namespace brdf::wave {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kBlock = 64;

double square(double x) { return x * x; }

/// Models whose value is a scale times the squares of amplitudes that know nothing of the roughness.
class RoughModel : public ScatterModel {
 public:
  RoughModel(SpectrumPointer spectrum, double wavelength)
      : spectrum_(std::move(spectrum)), wavelength_(wavelength), variance_(spectrum_->variance()) {}

  void jones(const Geometry* geometry, std::size_t count, Jones* values) const override {
    double scales[kBlock];
    for (std::size_t first = 0; first < count; first += kBlock) {
      const std::size_t length = std::min(kBlock, count - first);
      scale(geometry + first, length, scales);
      for (std::size_t k = 0; k < length; ++k)
        values[first + k] = scales[k] > 0 ? std::sqrt(scales[k]) * amplitudes(geometry[first + k]) : Jones{};
    }
  }
  Symmetry symmetry() const override { return spectrum_->isotropic() ? Symmetry::Isotropic : Symmetry::Anisotropic; }
  /// Reflectance of the mean plane times exp(-g): Beckmann and Spizzichino (1963), section 5.3.
  double specular(double theta) const override {
    if (!std::isfinite(variance_)) return 0;
    const double g = square(4 * kPi * std::cos(theta) / wavelength_ * relevantShare(std::cos(theta))) * variance_;
    return planeReflectance(theta) * std::exp(-g);
  }

 protected:
  virtual void scale(const Geometry* geometry, std::size_t count, double* scales) const = 0;
  virtual Jones amplitudes(const Geometry& geometry) const = 0;
  virtual double planeReflectance(double theta) const = 0;
  /// Part of the rms height that counts at this cosine of incidence.
  virtual double relevantShare(double) const { return 1; }

  SpectrumPointer spectrum_;
  double wavelength_;  ///< um
  double variance_;    ///< um^2
};

class PerturbationModel : public RoughModel {
 public:
  PerturbationModel(SpectrumPointer spectrum, Complex index, double wavelength)
      : RoughModel(std::move(spectrum), wavelength), index_(index) {}

 protected:
  Jones amplitudes(const Geometry& geometry) const override { return perturbationAmplitudes(geometry, index_); }
  double planeReflectance(double theta) const override {
    Complex rs, rp;
    FilmStack({}, index_, wavelength_).reflection(std::sin(theta), std::cos(theta), rs, rp);
    return (std::norm(rs) + std::norm(rp)) / 2;
  }

 private:
  Complex index_;
};

class RayleighRice : public PerturbationModel {
 public:
  using PerturbationModel::PerturbationModel;
  std::string energyNote() const override {
    return "first order in the heights: the albedo grows with the spectrum without bound";
  }

 protected:
  void scale(const Geometry* geometry, std::size_t count, double* scales) const override {
    double fx[kBlock]{}, fy[kBlock]{};
    for (std::size_t k = 0; k < count; ++k) {
      fx[k] = geometry[k].qx / wavelength_;
      fy[k] = geometry[k].qy / wavelength_;
    }
    spectrum_->evaluate(fx, fy, scales, count);
    const double factor = square(4 * kPi / square(wavelength_));
    for (std::size_t k = 0; k < count; ++k) scales[k] *= factor * geometry[k].cosI * geometry[k].cosS;
  }
};

/// Phi(kappa, q / wavelength) / wavelength^2; `share(cosI)` of the rms height counts.
template <class Share>
void phaseScale(const PhaseTransform& transform, double wavelength, const Geometry* geometry, std::size_t count,
                Share&& share, double* scales) {
  double kappa[kBlock]{}, fx[kBlock]{}, fy[kBlock]{};
  for (std::size_t k = 0; k < count; ++k) {
    kappa[k] = 2 * kPi / wavelength * (geometry[k].cosI + geometry[k].cosS) * share(geometry[k].cosI);
    fx[k] = geometry[k].qx / wavelength;
    fy[k] = geometry[k].qy / wavelength;
  }
  transform.evaluate(kappa, fx, fy, scales, count);
  for (std::size_t k = 0; k < count; ++k) scales[k] /= square(wavelength);
}

class HarveyShack : public PerturbationModel {
 public:
  HarveyShack(SpectrumPointer spectrum, PhaseTransformPointer transform, Complex index, double wavelength,
              HarveyShackOptions options)
      : PerturbationModel(spectrum, index, wavelength),
        transform_(std::move(transform)),
        options_(options),
        normal_(spectrum, transform_, wavelength, options) {}
  bool reciprocal() const override { return !options_.relevant && !options_.renormalized; }
  std::string energyNote() const override {
    return options_.renormalized ? "the amplitudes of polarisation grow towards grazing angles: the albedo may exceed 1"
                                 : "not renormalised: very rough surfaces and grazing light may give an albedo above 1";
  }

 protected:
  void scale(const Geometry* geometry, std::size_t count, double* scales) const override {
    const auto share = [this](double cosI) { return relevantShare(cosI); };
    phaseScale(*transform_, wavelength_, geometry, count, share, scales);
    if (!options_.renormalized) return;
    for (std::size_t k = 0; k < count; ++k) scales[k] *= normal_.factor(geometry[k].cosI);
  }
  double relevantShare(double cosI) const override { return options_.relevant ? normal_.relevantShare(cosI) : 1; }

 private:
  PhaseTransformPointer transform_;
  HarveyShackOptions options_;
  Renormalization normal_;
};

class BeckmannKirchhoff : public RoughModel {
 public:
  BeckmannKirchhoff(SpectrumPointer spectrum, PhaseTransformPointer transform, FilmStack stack, double wavelength,
                    bool modified)
      : RoughModel(std::move(spectrum), wavelength),
        stack_(std::move(stack)),
        transform_(std::move(transform)),
        modified_(modified) {}
  std::string energyNote() const override {
    return modified_ ? "not renormalised: very rough surfaces and grazing light may give an albedo above 1"
                     : "the factor F grows without bound at grazing angles";
  }

 protected:
  void scale(const Geometry* geometry, std::size_t count, double* scales) const override {
    phaseScale(
        *transform_, wavelength_, geometry, count, [](double) { return 1.0; }, scales);
    if (modified_) return;
    for (std::size_t k = 0; k < count; ++k) {
      const Geometry& g = geometry[k];
      // sin_i sin_s cos phi is minus the tangential part of wi.wo: 1 + wi.wo = |wi + wo|^2 / 2.
      const double h = g.qx * g.qx + g.qy * g.qy + square(g.cosI + g.cosS);
      scales[k] *= square(h / (2 * (g.cosI + g.cosS))) / g.cosI / g.cosS;
    }
  }
  Jones amplitudes(const Geometry& geometry) const override { return facetAmplitudes(geometry, stack_); }
  double planeReflectance(double theta) const override {
    const FilmStack::Powers powers = stack_.powers(std::sin(theta), std::cos(theta));
    return (powers.reflectedS + powers.reflectedP) / 2;
  }

 private:
  FilmStack stack_;
  PhaseTransformPointer transform_;
  bool modified_;
};

}  // namespace

Jones perturbationAmplitudes(const Geometry& g, Complex index) {
  const Complex e = index * index, contrast = e - 1.0;
  const Complex qi = normalComponent(index, g.sinI), qs = normalComponent(index, g.sinS);
  const Complex is = g.cosI + qi, ip = e * g.cosI + qi, ss = g.cosS + qs, sp = e * g.cosS + qs;
  return {contrast * g.cosPhi / (is * ss), -contrast * qi * g.sinPhi / (ip * ss), -contrast * qs * g.sinPhi / (is * sp),
          contrast * (e * g.sinI * g.sinS - qi * qs * g.cosPhi) / (ip * sp)};
}

ScatterModelPointer rayleighRice(SpectrumPointer spectrum, Complex index, double wavelength) {
  return std::make_shared<RayleighRice>(std::move(spectrum), index, wavelength);
}

ScatterModelPointer harveyShack(SpectrumPointer spectrum, PhaseTransformPointer transform, Complex index,
                                double wavelength, HarveyShackOptions options) {
  return std::make_shared<HarveyShack>(std::move(spectrum), std::move(transform), index, wavelength, options);
}

ScatterModelPointer beckmannKirchhoff(SpectrumPointer spectrum, PhaseTransformPointer transform, FilmStack stack,
                                      double wavelength, bool modified) {
  return std::make_shared<BeckmannKirchhoff>(std::move(spectrum), std::move(transform), std::move(stack), wavelength,
                                             modified);
}

}  // namespace brdf::wave
