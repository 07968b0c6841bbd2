#include <brdf/sampling/SamplingChart.h>

#include <algorithm>

namespace brdf {
namespace {

double positiveAngle(double y, double x) {
  const double angle = std::atan2(y, x);
  return angle < 0 ? std::min(angle + 2 * kPi, std::nextafter(2 * kPi, 0)) : angle;
}

}  // namespace

ChartViewer::ChartViewer(const Direction& viewer, bool turning) : wo(viewer) {
  sinTheta = std::hypot(wo[0], wo[1]);
  cosPhi = sinTheta > 0 ? wo[0] / sinTheta : 1;
  sinPhi = sinTheta > 0 ? wo[1] / sinTheta : 0;
  cosZero = turning ? cosPhi : 1;
  sinZero = turning ? sinPhi : 0;
}

ChartViewer::ChartViewer(double theta, double phi, bool turning)
    : wo(fromSpherical(theta, phi)), cosPhi(std::cos(phi)), sinPhi(std::sin(phi)), sinTheta(std::sin(theta)) {
  cosZero = turning ? cosPhi : 1;
  sinZero = turning ? sinPhi : 0;
}

ChartPoint toChart(Chart chart, const ChartViewer& viewer, const Direction& wi) {
  const Direction& wo = viewer.wo;
  const auto azimuth = [&](double x, double y) {
    return positiveAngle(viewer.cosZero * y - viewer.sinZero * x, viewer.cosZero * x + viewer.sinZero * y);
  };
  switch (chart) {
    case Chart::Half: {
      const double x = wi[0] + wo[0], y = wi[1] + wo[1], z = wi[2] + wo[2];
      const double xy = x * x + y * y, length = std::sqrt(xy + z * z);
      if (!(length > 0)) return {0, 0, 0};
      // d omega_i = 4 (wo.h) d omega_h (Walter et al. 2007, (14)), and wo.h = |wi + wo| / 2.
      return {xy / (2 * length * (length + z)), azimuth(x, y), 2 * length};
    }
    case Chart::Retro: {
      const double x = wi[0] - wo[0], y = wi[1] - wo[1], z = wi[2] - wo[2];
      const double along = wo[2] * (viewer.cosPhi * x + viewer.sinPhi * y) - viewer.sinTheta * z;
      const double across = viewer.cosPhi * y - viewer.sinPhi * x;
      return {std::min(1.0, (x * x + y * y + z * z) / 4), positiveAngle(across, along), 1};
    }
    default:
      return {(wi[0] * wi[0] + wi[1] * wi[1]) / (2 * (1 + wi[2])), azimuth(wi[0], wi[1]), 1};
  }
}

double fromChart(Chart chart, const ChartViewer& viewer, double x, double phi, Direction& wi) {
  const Direction& wo = viewer.wo;
  const double cosine = 1 - 2 * x, sine = 2 * std::sqrt(x * (1 - x));
  const double p = sine * std::cos(phi), q = sine * std::sin(phi);
  double jacobian = 1;
  if (chart == Chart::Retro) {
    const double along = viewer.wo[2] * p + viewer.sinTheta * cosine;  // in the plane of normal and viewer
    wi = {viewer.cosPhi * along - viewer.sinPhi * q, viewer.sinPhi * along + viewer.cosPhi * q,
          wo[2] * cosine - viewer.sinTheta * p};
  } else {
    wi = {viewer.cosZero * p - viewer.sinZero * q, viewer.sinZero * p + viewer.cosZero * q, cosine};
    if (chart == Chart::Half) {
      const double facing = dot(wi, wo);
      for (std::size_t axis = 0; axis < 3; ++axis) wi[axis] = 2 * facing * wi[axis] - wo[axis];
      jacobian = 4 * facing;
    }
  }
  if (jacobian > 0 && wi[2] > 0) return jacobian;
  wi = {0, 0, 0};
  return 0;
}

}  // namespace brdf
