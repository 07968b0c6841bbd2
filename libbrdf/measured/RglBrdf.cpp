#include <brdf/base/Error.h>
#include <brdf/measured/RglBrdf.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

double toX(double theta) { return std::sqrt(theta * (2 / kPi)); }
double toTheta(double x) { return x * x * (kPi / 2); }

/// The polar angle with its digits near 0: from the chord to the pole.
double polarAngle(const Direction& w) {
  const double z = w[2] - 1;
  return 2 * std::asin(std::min(1.0, 0.5 * std::sqrt(w[0] * w[0] + w[1] * w[1] + z * z)));
}
double azimuth(const Direction& w) { return std::atan2(w[1], w[0]); }

/// d omega_light of an area of the square of half vectors: d omega_m/(dx dy) = 2 pi^2 x sin(theta_m), and 4 (v.m) from
/// half vectors to lights; bounded below as the database's own reader bounds it.
double squareToLight(double x, double sinTheta, double cosine) {
  return std::max(2 * kPi * kPi * x * sinTheta, 1e-6) * 4 * cosine;
}

void check(const RglData& d) {
  const auto fail = [](const char* what, std::size_t found, std::size_t allowed) {
    throw Error(Error::Kind::Value, {what, "RGL data", std::to_string(found), std::to_string(allowed)});
  };
  const std::size_t slices = d.phi.size() * d.theta.size();
  if (slices == 0) fail("no conditioning direction", 0, 1);
  for (const std::vector<float>* angles : {&d.phi, &d.theta})
    for (std::size_t k = 1; k < angles->size(); ++k)
      if (!((*angles)[k] > (*angles)[k - 1]))
        throw Error(Error::Kind::Value, {"angles out of order", "RGL data", std::to_string((*angles)[k]), "ascending"});
  const auto checkGrid = [&](const RglData::Grid& grid, std::size_t count, const char* what) {
    if (grid.width < 2 || grid.height < 2) fail("a grid is too small", std::min(grid.width, grid.height), 2);
    if (grid.values.size() != count * grid.width * grid.height)
      fail(what, grid.values.size(), count * grid.width * grid.height);
  };
  checkGrid(d.ndf, 1, "wrong size of ndf");
  checkGrid(d.sigma, 1, "wrong size of sigma");
  checkGrid(d.vndf, slices, "wrong size of vndf");
  checkGrid(d.luminance, slices, "wrong size of luminance");
  checkGrid(d.spectra, slices * d.channels.count(), "wrong size of spectra");
  for (const RglData::Grid* grid : {&d.ndf, &d.sigma, &d.vndf, &d.luminance})
    for (const float v : grid->values)
      if (!(v >= 0) || std::isinf(v))
        throw Error(Error::Kind::Value,
                    {"a density is not finite, or negative", "RGL data", std::to_string(v), "0 or more"});
}

}  // namespace

/// A viewer brought into the measured azimuths by a turn or a mirror about the normal, and what brings others with it.
struct RglBrdf::Turned {
  double phi = 0, theta = 0;
  double xx = 1, xy = 0, yx = 0, yy = 1;  ///< orthogonal
  Direction viewer{};

  Direction forward(const Direction& w) const { return {xx * w[0] + xy * w[1], yx * w[0] + yy * w[1], w[2]}; }
  Direction back(const Direction& w) const { return {xx * w[0] + yx * w[1], xy * w[0] + yy * w[1], w[2]}; }
};

RglBrdf::RglBrdf(RglData data, std::string description)
    : description_(std::move(description)), channels_(data.channels), jacobian_(data.jacobian) {
  check(data);
  isotropic_ = data.phi.size() <= 2;
  if (!isotropic_) {
    phiStart_ = data.phi.front();
    phiRange_ = data.phi.back() - data.phi.front();
    reduction_ = std::clamp(static_cast<int>(std::lround(2 * kPi / phiRange_)), 1, 4);
    if (reduction_ == 3) reduction_ = 2;
  }
  width_ = data.spectra.width;
  height_ = data.spectra.height;
  ndf_ = Warp2D(data.ndf.width, data.ndf.height, {}, {}, std::move(data.ndf.values), false);
  sigma_ = Warp2D(data.sigma.width, data.sigma.height, {}, {}, std::move(data.sigma.values), false);
  vndf_ = Warp2D(data.vndf.width, data.vndf.height, data.phi, data.theta, std::move(data.vndf.values), true);
  luminance_ =
      Warp2D(data.luminance.width, data.luminance.height, data.phi, data.theta, std::move(data.luminance.values), true);
  spectra_ = std::move(data.spectra.values);
}

RglBrdf::Turned RglBrdf::turn(const Direction& viewer) const {
  Turned turned;
  if (reduction_ > 1) {
    double relative = azimuth(viewer) - phiStart_;
    relative -= 2 * kPi * std::floor(relative / (2 * kPi));
    if (reduction_ == 2) {
      if (relative > kPi) turned.xx = turned.yy = -1;
    } else {
      const int quarter = std::min(static_cast<int>(relative / (kPi / 2)), 3);
      if (quarter == 2) turned.xx = turned.yy = -1;
      if (quarter == 1 || quarter == 3) {
        // Mirrored in the line at azimuth phiStart (+ 90 degrees): matrix of the double angle.
        const double twice = 2 * (phiStart_ + (quarter == 1 ? kPi / 2 : 0));
        turned.xx = std::cos(twice);
        turned.xy = turned.yx = std::sin(twice);
        turned.yy = -turned.xx;
      }
    }
  }
  turned.viewer = turned.forward(viewer);
  turned.theta = polarAngle(turned.viewer);
  turned.phi = azimuth(turned.viewer);
  // A range that does not start at -180 degrees: the azimuth as the file counts it.
  if (!isotropic_)
    turned.phi = phiStart_ + (turned.phi - phiStart_ - 2 * kPi * std::floor((turned.phi - phiStart_) / (2 * kPi)));
  return turned;
}

Warp2D::Point RglBrdf::halfPoint(const Direction& m, double phi) const {
  const double phiM = azimuth(m) - (isotropic_ ? phi : 0);
  const double y = (phiM + kPi) / (2 * kPi);
  return {toX(polarAngle(m)), y - std::floor(y)};
}

double RglBrdf::factor(const Direction& m, const Direction& viewer) const {
  if (!jacobian_) return 1;
  const Turned turned = turn(viewer);
  const double phi = std::remainder(turned.phi, 2 * kPi);
  const double s = sigma_.evaluate({toX(turned.theta), (phi + kPi) / (2 * kPi)}, sigma_.locate(0, 0));
  const double n = ndf_.evaluate(halfPoint(turned.forward(m), turned.phi), ndf_.locate(0, 0));
  return s > 0 ? n / (4 * s) : 0;
}

Direction RglBrdf::halfVector(const Warp2D::Point& at, const Direction& viewer) const {
  const Turned turned = turn(viewer);
  const Warp2D::Point u = vndf_.draw(at, vndf_.locate(turned.phi, turned.theta)).at;
  const double phi = (2 * u.y - 1) * kPi + (isotropic_ ? turned.phi : 0);
  return turned.back(fromSpherical(toTheta(u.x), phi));
}

void RglBrdf::evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  const std::size_t count = channels_.count(), area = width_ * height_;
  for (std::size_t i = 0; i < pairs.count; ++i) {
    if (valid) valid[i] = 1;
    for (std::size_t c = 0; c < count; ++c) values[c * pairs.count + i] = 0;
    const Direction light{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]},
        viewer{pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
    if (!(light[2] > 0 && viewer[2] > 0)) continue;
    const Direction m = normalized({light[0] + viewer[0], light[1] + viewer[1], light[2] + viewer[2]});
    const Turned turned = turn(viewer);
    const Warp2D::Condition condition = vndf_.locate(turned.phi, turned.theta);
    const Warp2D::Point at = vndf_.invert(halfPoint(turned.forward(m), turned.phi), condition).at;
    const double scale = factor(m, viewer) / std::max(light[2], kLeastCosine);
    const double sx = at.x * static_cast<double>(width_ - 1), sy = at.y * static_cast<double>(height_ - 1);
    const std::size_t x = std::min(static_cast<std::size_t>(sx), width_ - 2),
                      y = std::min(static_cast<std::size_t>(sy), height_ - 2);
    const double tx = sx - static_cast<double>(x), ty = sy - static_cast<double>(y);
    for (std::size_t k = 0; k < condition.count; ++k) {
      const float* slice = spectra_.data() + condition.slice[k] * count * area + y * width_ + x;
      for (std::size_t c = 0; c < count; ++c, slice += area)
        values[c * pairs.count + i] += scale * condition.weight[k] *
                                       ((1 - ty) * ((1 - tx) * slice[0] + tx * slice[1]) +
                                        ty * ((1 - tx) * slice[width_] + tx * slice[width_ + 1]));
    }
  }
}

void RglBrdf::sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
                     const std::array<double*, 3>& wi, std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) wi[axis][i] = 0;
    const Direction viewer{wo[0][i], wo[1][i], wo[2][i]};
    if (!(viewer[2] > 0)) continue;
    const Turned turned = turn(viewer);
    const Warp2D::Point at = luminance_.draw({u[1][i], u[0][i]}, luminance_.locate(turned.phi, turned.theta)).at;
    const Direction m = halfVector(at, viewer);
    const double cosine = dot(m, viewer);
    if (!(cosine > 0)) continue;
    const Direction light{2 * cosine * m[0] - viewer[0], 2 * cosine * m[1] - viewer[1], 2 * cosine * m[2] - viewer[2]};
    if (!(light[2] > 0)) continue;
    const Direction unit = normalized(light);
    for (std::size_t axis = 0; axis < 3; ++axis) wi[axis][i] = unit[axis];
  }
}

void RglBrdf::pdf(const DirectionPairs<double>& pairs, double* density) const {
  for (std::size_t i = 0; i < pairs.count; ++i) {
    density[i] = 0;
    const Direction light{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]},
        viewer{pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
    if (!(light[2] > 0 && viewer[2] > 0)) continue;
    const Direction m = normalized({light[0] + viewer[0], light[1] + viewer[1], light[2] + viewer[2]});
    const Turned turned = turn(viewer);
    const Warp2D::Condition condition = vndf_.locate(turned.phi, turned.theta);
    const Warp2D::Point u = halfPoint(turned.forward(m), turned.phi);
    const Warp2D::Drawn inverted = vndf_.invert(u, condition);
    density[i] = inverted.density * luminance_.evaluate(inverted.at, condition) /
                 squareToLight(u.x, std::hypot(m[0], m[1]), dot(m, viewer));
  }
}

}  // namespace brdf
