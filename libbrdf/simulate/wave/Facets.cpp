#include <brdf/simulate/wave/Facets.h>
#include <brdf/simulate/wave/Roughness.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdf::wave {
namespace {

constexpr double kPi = std::numbers::pi;
double square(double x) { return x * x; }

class GaussianSlopes : public SlopeDistribution {
 public:
  GaussianSlopes(double sx, double sy) : sx_(sx), sy_(sy) {}
  double density(double mx, double my) const override {
    return std::exp(-square(mx / sx_) - square(my / sy_)) / (kPi * sx_ * sy_);
  }
  bool isotropic() const override { return sx_ == sy_; }

 private:
  double sx_, sy_;
};

class ExponentialSlopes : public SlopeDistribution {
 public:
  ExponentialSlopes(double sx, double sy) : sx_(sx), sy_(sy) {}
  double density(double mx, double my) const override {
    return 3 / (kPi * sx_ * sy_) * std::exp(-std::sqrt(6.0) * std::hypot(mx / sx_, my / sy_));
  }
  bool isotropic() const override { return sx_ == sy_; }

 private:
  double sx_, sy_;
};

class EllipsoidSlopes : public SlopeDistribution {
 public:
  EllipsoidSlopes(double rx, double ry, double rz, double count) : rx_(rx), ry_(ry), rz_(rz), count_(count) {}
  double density(double mx, double my) const override {
    return count_ * square(rx_ * ry_ * rz_ / (rz_ * rz_ + square(rx_ * mx) + square(ry_ * my)));
  }
  bool isotropic() const override { return rx_ == ry_; }

 private:
  double rx_, ry_, rz_, count_;
};

class MixedSlopes : public SlopeDistribution {
 public:
  MixedSlopes(SlopePointer a, SlopePointer b, double share) : a_(std::move(a)), b_(std::move(b)), share_(share) {}
  double density(double mx, double my) const override {
    return (1 - share_) * a_->density(mx, my) + share_ * b_->density(mx, my);
  }
  bool isotropic() const override { return a_->isotropic() && b_->isotropic(); }

 private:
  SlopePointer a_, b_;
  double share_;
};

class SmithShadowing : public Shadowing {
 public:
  explicit SmithShadowing(double w) : w_(w) {}
  double seen(const Geometry& g) const override { return one(g.cosI, g.sinI) * one(g.cosS, g.sinS); }

 private:
  double one(double cosine, double sine) const {
    const double nu = cosine / (w_ * sine);  // cot(theta)/w; infinite at the normal
    if (!(nu < 26 * std::numbers::sqrt2)) return 1;
    const double tail = std::erfc(nu / std::numbers::sqrt2) / 2;
    const double lambda = nu > 0 ? std::exp(-nu * nu / 2) / (nu * std::sqrt(2 * kPi)) - tail : 0;
    return nu > 0 ? (1 - tail) / (1 + std::max(0.0, lambda)) : 0;
  }
  double w_;
};

class GrooveShadowing : public Shadowing {
 public:
  double seen(const Geometry& g) const override {
    const Vector h{g.wi[0] + g.wo[0], g.wi[1] + g.wo[1], g.wi[2] + g.wo[2]};
    const double twice = 2 * h[2] / dot(h, g.wi);  // the length of h drops out
    return std::min({1.0, twice * g.cosI, twice * g.cosS});
  }
};

class MaxwellBeardShadowing : public Shadowing {
 public:
  MaxwellBeardShadowing(double omega, double tau) : omega_(omega), tau_(tau) {}
  double seen(const Geometry& g) const override {
    const double tilt = std::atan2(std::hypot(g.qx, g.qy), g.cosI + g.cosS) / omega_;
    const Vector h{g.qx, g.qy, g.cosI + g.cosS}, across = cross(g.wi, h);
    const double beta = std::atan2(std::sqrt(dot(across, across)), dot(g.wi, h));
    return (1 + tilt * std::exp(-2 * beta / tau_)) / (1 + tilt);
  }

 private:
  double omega_, tau_;
};

class FacetModel : public ScatterModel {
 public:
  FacetModel(SlopePointer slopes, ShadowingPointer shadowing, FilmStack stack)
      : slopes_(std::move(slopes)), shadowing_(std::move(shadowing)), stack_(std::move(stack)) {}

  void jones(const Geometry* geometry, std::size_t count, Jones* values) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const Geometry& g = geometry[k];
      const double scale = weight(g);
      values[k] = scale > 0 ? std::sqrt(scale) * facetAmplitudes(g, stack_) : Jones{};
    }
  }
  void unpolarized(const Geometry* geometry, std::size_t count, double* values) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const Geometry& g = geometry[k];
      const double scale = weight(g);
      const Vector h{g.qx, g.qy, g.cosI + g.cosS}, across = cross(g.wi, h);
      const double length = std::sqrt(dot(h, h));
      Complex rs, rp;
      stack_.reflection(std::sqrt(dot(across, across)) / length, length / 2, rs, rp);
      values[k] = scale / 2 * (std::norm(rs) + std::norm(rp));
    }
  }
  Symmetry symmetry() const override { return slopes_->isotropic() ? Symmetry::Isotropic : Symmetry::Anisotropic; }
  std::string energyNote() const override {
    return shadowing_ ? "single reflection by facets: slopes, shadowing and substrate are independent choices"
                      : "facets without shadowing grow without bound at grazing angles";
  }

 private:
  double weight(const Geometry& g) const {
    const double hz = g.cosI + g.cosS, mx = -g.qx / hz, my = -g.qy / hz;
    const double slopes = slopes_->density(mx, my);
    if (!(slopes > 0)) return 0;
    const double secant = 1 + mx * mx + my * my;
    const double value = slopes * secant * secant / 4 / g.cosI / g.cosS;
    return shadowing_ ? value * shadowing_->seen(g) : value;
  }

  SlopePointer slopes_;
  ShadowingPointer shadowing_;
  FilmStack stack_;
};

}  // namespace

SlopeDistribution::~SlopeDistribution() = default;
Shadowing::~Shadowing() = default;

SlopePointer gaussianSlopes(double sx, double sy) { return std::make_shared<GaussianSlopes>(sx, sy); }
SlopePointer exponentialSlopes(double sx, double sy) { return std::make_shared<ExponentialSlopes>(sx, sy); }
SlopePointer ellipsoidSlopes(double rx, double ry, double rz, double count) {
  return std::make_shared<EllipsoidSlopes>(rx, ry, rz, count);
}
SlopePointer mixedSlopes(SlopePointer a, SlopePointer b, double share) {
  return std::make_shared<MixedSlopes>(std::move(a), std::move(b), share);
}
ShadowingPointer smithShadowing(double w) { return std::make_shared<SmithShadowing>(w); }
ShadowingPointer grooveShadowing() { return std::make_shared<GrooveShadowing>(); }
ShadowingPointer maxwellBeardShadowing(double omega, double tau) {
  return std::make_shared<MaxwellBeardShadowing>(omega, tau);
}
ScatterModelPointer facets(SlopePointer slopes, ShadowingPointer shadowing, FilmStack stack) {
  return std::make_shared<FacetModel>(std::move(slopes), std::move(shadowing), std::move(stack));
}

Jones facetAmplitudes(const Geometry& g, const FilmStack& stack) {
  const Vector h{g.qx, g.qy, g.cosI + g.cosS}, across = cross(g.wi, h);
  const double length = std::sqrt(dot(h, h));
  Complex rs, rp;
  stack.reflection(std::sqrt(dot(across, across)) / length, length / 2, rs, rp);
  return inPlane(g.incident(), g.scattered(), rs, rp);
}

}  // namespace brdf::wave
