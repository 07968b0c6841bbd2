#include <brdf/simulate/wave/Particles.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdf::wave {
namespace {

constexpr double kPi = std::numbers::pi;
double square(double x) { return x * x; }

class MieScatterer : public Scatterer {
 public:
  MieScatterer(double radius, Complex sphere, double medium, double wavelength)
      : sphere_(2 * kPi * radius * medium / wavelength, sphere / medium), area_(kPi * radius * radius) {}
  void amplitudes(double cosine, Complex& s1, Complex& s2) const override { sphere_.amplitudes(cosine, s1, s2); }
  double scatteringCrossSection() const override { return sphere_.scattering() * area_; }
  double extinctionCrossSection() const override { return sphere_.extinction() * area_; }

 private:
  MieSphere sphere_;
  double area_;
};

class RayleighScatterer : public Scatterer {
 public:
  RayleighScatterer(double radius, Complex sphere, double medium, double wavelength)
      : x_(2 * kPi * radius * medium / wavelength), area_(kPi * radius * radius) {
    const Complex m = sphere / medium;
    contrast_ = (m * m - 1.0) / (m * m + 2.0);
  }
  void amplitudes(double cosine, Complex& s1, Complex& s2) const override {
    s1 = Complex(0, -x_ * x_ * x_) * contrast_;
    s2 = s1 * cosine;
  }
  double scatteringCrossSection() const override { return area_ * 8 / 3.0 * square(x_ * x_) * std::norm(contrast_); }
  double extinctionCrossSection() const override {
    return scatteringCrossSection() + area_ * 4 * x_ * contrast_.imag();
  }

 private:
  double x_, area_;
  Complex contrast_;
};

/// Light and viewer change places; the sign of amplitudes between s and p changes with that of sin phi.
Geometry exchanged(const Geometry& g) {
  return {g.cosS,
          g.sinS,
          g.cosI,
          g.sinI,
          g.cosPhi,
          -g.sinPhi,
          g.qx,
          g.qy,
          g.wo,
          g.wi,
          {-g.outgoing[0], -g.outgoing[1]},
          {-g.forward[0], -g.forward[1]}};
}

/// From the basis of light down the normal whose plane is along `from` into that of the plane along `to`.
Jones turned(const std::array<double, 2>& from, const std::array<double, 2>& to) {
  const double cosine = from[0] * to[0] + from[1] * to[1], sine = from[0] * to[1] - from[1] * to[0];
  return {cosine, -sine, sine, cosine};
}

/// Waves within a substrate of real index: the sine and cosine of refraction.
struct Refracted {
  double sine, cosine;
};
Refracted refracted(double sine, double index) { return {sine / index, std::sqrt(1 - square(sine / index))}; }

class DoubleInteraction : public ScatterModel {
 public:
  DoubleInteraction(ScattererPointer scatterer, FilmStack stack, double density, double distance, double wavelength)
      : scatterer_(std::move(scatterer)),
        stack_(std::move(stack)),
        density_(density),
        waveNumber_(2 * kPi / wavelength),
        distance_(distance) {}

  /// At grazing angles direct and reflected light cancel: the amplitude is proportional to either cosine. Where
  /// rounding would take over, within 6e-4 degrees of the horizon, the value there is scaled, to 1e-5 of it. The
  /// steeper direction is always the scattered one, so that exchanged directions round alike.
  void jones(const Geometry* geometry, std::size_t count, Jones* values) const override {
    constexpr double least = 1e-5;
    for (std::size_t k = 0; k < count; ++k) {
      Geometry g = geometry[k];
      const double scale = std::min(g.cosI / least, 1.0) * std::min(g.cosS / least, 1.0);
      // Light along the normal has no plane of its own: computed in that of the scattered light.
      const std::array<double, 2> plane = g.forward;
      const bool normal = g.sinI == 0;
      if (normal) {
        g.forward = g.outgoing;
        g.cosPhi = 1;
        g.sinPhi = 0;
      }
      g.cosI = g.wi[2] = std::max(g.cosI, least);
      g.cosS = g.wo[2] = std::max(g.cosS, least);
      if (geometry[k].cosI <= geometry[k].cosS) {
        values[k] = std::sqrt(scale) * one(g);
      } else {
        const Jones j = one(exchanged(g));
        values[k] = std::sqrt(scale) * Jones{j.ss, -j.sToP, -j.pToS, j.pp};
      }
      if (normal) values[k] = values[k] * turned(plane, g.forward);
    }
  }
  std::string energyNote() const override {
    return "independent particles: the albedo grows with their density without bound";
  }

 private:
  Jones one(const Geometry& g) const {
    const Ray in = g.incident(), out = g.scattered();
    const Ray inReflected = rayAlong({in.d[0], in.d[1], -in.d[2]}, g.forward);
    const Ray outReflected = rayAlong({out.d[0], out.d[1], -out.d[2]}, g.outgoing);
    // Turning both rays over leaves the angle between them: two angles for the four ways.
    Complex far1, far2, near1, near2;
    scatterer_->amplitudes(dot(in.d, out.d), far1, far2);
    scatterer_->amplitudes(dot(inReflected.d, out.d), near1, near2);
    Complex rsI, rpI, rsS, rpS;
    stack_.reflection(g.sinI, g.cosI, rsI, rpI);
    stack_.reflection(g.sinS, g.cosS, rsS, rpS);
    const Complex phaseI = std::polar(1.0, 2 * waveNumber_ * distance_ * g.cosI);
    const Complex phaseS = std::polar(1.0, 2 * waveNumber_ * distance_ * g.cosS);
    const Jones reflectI{rsI * phaseI, 0, 0, rpI * phaseI}, reflectS{rsS * phaseS, 0, 0, rpS * phaseS};
    const Jones sum = inPlane(in, out, far1, far2) + inPlane(inReflected, out, near1, near2) * reflectI +
                      reflectS * inPlane(in, outReflected, near1, near2) +
                      reflectS * inPlane(inReflected, outReflected, far1, far2) * reflectI;
    return std::sqrt(density_ / g.cosI / g.cosS) / waveNumber_ * sum;
  }

  ScattererPointer scatterer_;
  FilmStack stack_;
  double density_, waveNumber_, distance_;
};

class SubsurfaceParticle : public ScatterModel {
 public:
  SubsurfaceParticle(ScattererPointer scatterer, FilmStack stack, double density, double wavelength)
      : scatterer_(std::move(scatterer)),
        stack_(std::move(stack)),
        density_(density),
        waveNumber_(2 * kPi / wavelength) {}

  void jones(const Geometry* geometry, std::size_t count, Jones* values) const override {
    for (std::size_t k = 0; k < count; ++k) values[k] = one(geometry[k]);
  }
  std::string energyNote() const override {
    return "independent particles: the albedo grows with their density without bound";
  }

 private:
  Jones one(const Geometry& g) const {
    const double n = stack_.substrate().real();
    const Refracted i = refracted(g.sinI, n), s = refracted(g.sinS, n);
    const Ray in = rayAlong({g.forward[0] * i.sine, g.forward[1] * i.sine, -i.cosine}, g.forward);
    const Ray out = rayAlong({g.outgoing[0] * s.sine, g.outgoing[1] * s.sine, s.cosine}, g.outgoing);
    Complex s1, s2;
    scatterer_->amplitudes(dot(in.d, out.d), s1, s2);
    const FilmStack::Amplitudes entry = stack_.at(g.sinI, g.cosI), exit = stack_.at(g.sinS, g.cosS);
    // Irradiance within over that outside, n |t|^2; radiant intensity outside over that within, the transmittance
    // (the same both ways) n cos_within/cos_s |t|^2 times dOmega_within/dOmega = cos_s/(n^2 cos_within): but for the
    // |t|^2 they cancel.
    const Jones through = Jones{exit.ts, 0, 0, exit.tp} * inPlane(in, out, s1, s2) * Jones{entry.ts, 0, 0, entry.tp};
    return std::sqrt(density_ / g.cosI / g.cosS) / (waveNumber_ * n) * through;
  }

  ScattererPointer scatterer_;
  FilmStack stack_;
  double density_, waveNumber_;
};

class MovedIncidence : public ScatterModel {
 public:
  explicit MovedIncidence(ScatterModelPointer model) : model_(std::move(model)) {}

  void jones(const Geometry* geometry, std::size_t count, Jones* values) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const Geometry moved = movedFrom(geometry[k]);
      model_->jones(&moved, 1, values + k);
      values[k] = std::sqrt(moved.cosI / geometry[k].cosI * moved.cosS / geometry[k].cosS) * values[k];
    }
  }
  Symmetry symmetry() const override { return model_->symmetry(); }
  bool reciprocal() const override { return false; }
  std::string energyNote() const override { return model_->energyNote(); }

 private:
  static Geometry movedFrom(const Geometry& g) {
    double thetaI = std::atan2(g.sinI, g.cosI), thetaS = std::atan2(g.sinS, g.cosS);
    if (std::abs(std::sin(thetaI) - g.sinS * g.cosPhi) < 1e-5) thetaI += 2.5e-5;
    if (std::abs(std::sin(thetaI) + g.sinS * g.cosPhi) < 1e-5) thetaI += 2.5e-5;
    thetaI = std::max(thetaI, 1e-5);
    thetaS = std::max(thetaS, 1e-5);
    Geometry moved = g;
    moved.sinI = std::sin(thetaI);
    moved.cosI = std::cos(thetaI);
    moved.sinS = std::sin(thetaS);
    moved.cosS = std::cos(thetaS);
    moved.wi = {-g.forward[0] * moved.sinI, -g.forward[1] * moved.sinI, moved.cosI};
    moved.wo = {g.outgoing[0] * moved.sinS, g.outgoing[1] * moved.sinS, moved.cosS};
    moved.qx = moved.wi[0] + moved.wo[0];
    moved.qy = moved.wi[1] + moved.wo[1];
    return moved;
  }

  ScatterModelPointer model_;
};

class HenyeyGreenstein : public PhaseFunction {
 public:
  explicit HenyeyGreenstein(double g) : g_(g) {}
  double value(double cosine) const override {
    return (1 - g_ * g_) / (4 * kPi * std::pow(1 + g_ * g_ - 2 * g_ * cosine, 1.5));
  }

 private:
  double g_;
};

class IsotropicPhase : public PhaseFunction {
 public:
  double value(double) const override { return 1 / (4 * kPi); }
};

class RayleighPhase : public PhaseFunction {
 public:
  double value(double cosine) const override { return 3 / (16 * kPi) * (1 + cosine * cosine); }
};

class ReynoldsMcCormick : public PhaseFunction {
 public:
  ReynoldsMcCormick(double g, double alpha) : g_(g), alpha_(alpha) {
    // 1 over 2 pi times the integral of (1 + g^2 - 2 g cos)^-(alpha + 1) over the cosine.
    const double a = std::pow(1 - g, -2 * alpha), b = std::pow(1 + g, -2 * alpha);
    scale_ = std::abs(g) < 1e-9 ? 1 / (4 * kPi) : alpha * g / (kPi * (a - b));
  }
  double value(double cosine) const override { return scale_ * std::pow(1 + g_ * g_ - 2 * g_ * cosine, -(alpha_ + 1)); }

 private:
  double g_, alpha_, scale_;
};

class FirstDiffuse : public ScatterModel {
 public:
  FirstDiffuse(PhaseFunctionPointer phase, FilmStack stack, double scattering, double absorption)
      : phase_(std::move(phase)), stack_(std::move(stack)) {
    albedo_ = scattering > 0 ? scattering / (scattering + absorption) : 0;
  }
  bool deterministic() const override { return false; }

  /// Depolarised within the medium: M = (light out) x (power in), each (Ts + Tp)/2, (Ts - Tp)/2.
  void mueller(const Geometry* geometry, std::size_t count, Mueller* values) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const Geometry& g = geometry[k];
      const Passage in = passage(g.sinI, g.cosI), out = passage(g.sinS, g.cosS);
      const double value = common(g, in, out);
      values[k] = {};
      values[k].m[0] = value * in.mean * out.mean;
      values[k].m[1] = value * in.difference * out.mean;
      values[k].m[4] = value * in.mean * out.difference;
      values[k].m[5] = value * in.difference * out.difference;
    }
  }
  void unpolarized(const Geometry* geometry, std::size_t count, double* values) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const Geometry& g = geometry[k];
      const Passage in = passage(g.sinI, g.cosI), out = passage(g.sinS, g.cosS);
      values[k] = common(g, in, out) * in.mean * out.mean;
    }
  }

 private:
  struct Passage {
    Refracted within;
    double mean, difference;  ///< (Ts + Tp)/2, (Ts - Tp)/2: transmittances
  };
  Passage passage(double sine, double cosine) const {
    const FilmStack::Powers powers = stack_.powers(sine, cosine);
    return {refracted(sine, stack_.substrate().real()), (powers.transmittedS + powers.transmittedP) / 2,
            (powers.transmittedS - powers.transmittedP) / 2};
  }
  double common(const Geometry& g, const Passage& in, const Passage& out) const {
    const double n = stack_.substrate().real();
    const double cosine = g.cosPhi * in.within.sine * out.within.sine - in.within.cosine * out.within.cosine;
    // Radiance over irradiance within: albedo p / (mu_i + mu_s); dOmega changes by n^2.
    return albedo_ * phase_->value(cosine) / (in.within.cosine + out.within.cosine) / (n * n);
  }

  PhaseFunctionPointer phase_;
  FilmStack stack_;
  double albedo_;
};

class LambertianModel : public ScatterModel {
 public:
  explicit LambertianModel(double reflectance) : reflectance_(reflectance) {}
  bool deterministic() const override { return false; }
  void mueller(const Geometry*, std::size_t count, Mueller* values) const override {
    for (std::size_t k = 0; k < count; ++k) {
      values[k] = {};
      values[k].m[0] = reflectance_ / kPi;
    }
  }

 private:
  double reflectance_;
};

}  // namespace

Scatterer::~Scatterer() = default;
PhaseFunction::~PhaseFunction() = default;

ScattererPointer mieScatterer(double radius, Complex sphere, double medium, double wavelength) {
  return std::make_shared<MieScatterer>(radius, sphere, medium, wavelength);
}
ScattererPointer rayleighScatterer(double radius, Complex sphere, double medium, double wavelength) {
  return std::make_shared<RayleighScatterer>(radius, sphere, medium, wavelength);
}
ScatterModelPointer doubleInteraction(ScattererPointer scatterer, FilmStack stack, double density, double distance,
                                      double wavelength) {
  return std::make_shared<DoubleInteraction>(std::move(scatterer), std::move(stack), density, distance, wavelength);
}
ScatterModelPointer subsurfaceParticle(ScattererPointer scatterer, FilmStack stack, double density, double wavelength) {
  return std::make_shared<SubsurfaceParticle>(std::move(scatterer), std::move(stack), density, wavelength);
}
ScatterModelPointer movedIncidence(ScatterModelPointer model) {
  return std::make_shared<MovedIncidence>(std::move(model));
}
PhaseFunctionPointer henyeyGreenstein(double g) { return std::make_shared<HenyeyGreenstein>(g); }
PhaseFunctionPointer isotropicPhase() { return std::make_shared<IsotropicPhase>(); }
PhaseFunctionPointer rayleighPhase() { return std::make_shared<RayleighPhase>(); }
PhaseFunctionPointer reynoldsMcCormick(double g, double alpha) { return std::make_shared<ReynoldsMcCormick>(g, alpha); }
ScatterModelPointer firstDiffuse(PhaseFunctionPointer phase, FilmStack stack, double scattering, double absorption) {
  return std::make_shared<FirstDiffuse>(std::move(phase), std::move(stack), scattering, absorption);
}
ScatterModelPointer lambertian(double reflectance) { return std::make_shared<LambertianModel>(reflectance); }

}  // namespace brdf::wave
