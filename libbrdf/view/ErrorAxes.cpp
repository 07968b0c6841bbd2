#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/view/ErrorAxes.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdf {
namespace {

template <class Value, std::size_t Count>
using Names = std::array<std::pair<std::string_view, Value>, Count>;

constexpr Names<ErrorAxes, 4> kAxes{{{"theta_i,theta_o", ErrorAxes::IncidentOutgoing},
                                     {"theta_h,theta_d", ErrorAxes::HalfDifference},
                                     {"theta_d,phi_d", ErrorAxes::DifferenceAzimuth},
                                     {"hemisphere", ErrorAxes::Hemisphere}}};
constexpr Names<DiskProjection, 2> kProjections{
    {{"equal-area", DiskProjection::EqualArea}, {"orthographic", DiskProjection::Orthographic}}};

template <class Value, std::size_t Count>
std::vector<std::string> namesOf(const Names<Value, Count>& names) {
  std::vector<std::string> list;
  for (const auto& [name, value] : names) list.emplace_back(name);
  return list;
}

template <class Value, std::size_t Count>
Value find(const Names<Value, Count>& names, std::string_view name, const char* what) {
  for (const auto& [known, value] : names)
    if (known == name) return value;
  throw Error(Error::Kind::Value, {what, "error map", std::string(name), joined(namesOf(names))});
}

struct Interval {
  double low, high;
  double middle() const { return (low + high) / 2; }
  /// Integral of sin.
  double ring() const { return std::cos(low) - std::cos(high); }
};

/// What node `k` of `intervals` over [0, pi/2] stands for: the first and the last have half an interval.
Interval polarInterval(std::size_t k, std::size_t intervals) {
  const double step = kPi / 2 / static_cast<double>(intervals);
  return {std::max((static_cast<double>(k) - 0.5) * step, 0.0),
          std::min((static_cast<double>(k) + 0.5) * step, kPi / 2)};
}

/// The angle that stands for a node: itself, but for the first and the last the middle of their half interval.
double polarAngle(std::size_t k, std::size_t intervals) {
  if (k > 0 && k < intervals) return static_cast<double>(k) * (kPi / 2 / static_cast<double>(intervals));
  return polarInterval(k, intervals).middle();
}

std::size_t nearestNode(double value, double low, double high, std::size_t intervals) {
  const double scaled = (value - low) / (high - low) * static_cast<double>(intervals) + 0.5;
  return std::min(static_cast<std::size_t>(std::max(scaled, 0.0)), intervals);
}

Direction turned(const Direction& w, double phi) {
  const double c = std::cos(phi), s = std::sin(phi);
  return {c * w[0] - s * w[1], s * w[0] + c * w[1], w[2]};
}

/// How `azimuths` pairs are shared between the azimuth that isotropic and bilateral BRDFs do not depend on and another.
struct Share {
  std::size_t turns = 1, others = 1;
  Share(std::size_t azimuths, Symmetry symmetry) : others(azimuths) {
    if (symmetry != Symmetry::Anisotropic) return;
    turns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(azimuths))));
    others = (azimuths + turns - 1) / turns;
  }
};

double midpoint(std::size_t k, std::size_t count, double range) {
  return (static_cast<double>(k) + 0.5) * range / static_cast<double>(count);
}

}  // namespace

ErrorAxes parseErrorAxes(std::string_view name) { return find(kAxes, name, "unknown axes"); }
std::vector<std::string> errorAxesNames() { return namesOf(kAxes); }
DiskProjection parseDiskProjection(std::string_view name) { return find(kProjections, name, "unknown projection"); }
std::vector<std::string> diskProjectionNames() { return namesOf(kProjections); }

double diskRadius(DiskProjection projection, double theta) {
  return projection == DiskProjection::Orthographic ? std::sin(theta) : std::numbers::sqrt2 * std::sin(theta / 2);
}

double diskTheta(DiskProjection projection, double r) {
  const double clamped = std::clamp(r, 0.0, 1.0);
  return projection == DiskProjection::Orthographic ? std::asin(clamped) : 2 * std::asin(clamped / std::numbers::sqrt2);
}

std::array<ErrorGrid::Range, 2> ErrorGrid::ranges() const {
  switch (axes) {
    case ErrorAxes::DifferenceAzimuth:
      return {{{0, 90}, {0, 180}}};
    case ErrorAxes::Hemisphere:
      return {{{-1, 1}, {-1, 1}}};
    default:
      return {{{0, 90}, {0, 90}}};
  }
}

std::size_t ErrorGrid::nodeOf(const Direction& wi, const Direction& wo, Symmetry symmetry) const {
  double x = 0, y = 0;
  if (axes == ErrorAxes::IncidentOutgoing) {
    x = degrees(toSpherical(wi).theta);
    y = degrees(toSpherical(wo).theta);
  } else if (axes == ErrorAxes::Hemisphere) {
    const double turn = symmetry == Symmetry::Anisotropic ? 0 : phiI - toSpherical(wi).phi;
    const Direction light = turned(wi, turn), incident = fromSpherical(thetaI, phiI);
    const Direction across = cross(light, incident);
    if (std::atan2(std::sqrt(dot(across, across)), dot(light, incident)) > within) return kNowhere;
    const Spherical view = toSpherical(turned(wo, turn));
    x = diskRadius(projection, view.theta) * std::cos(view.phi);
    y = diskRadius(projection, view.theta) * std::sin(view.phi);
  } else {
    const HalfDifference angles = toHalfDifference(wi, wo);
    if (axes == ErrorAxes::HalfDifference) {
      x = degrees(angles.thetaH);
      y = degrees(angles.thetaD);
    } else {
      x = degrees(angles.thetaD);
      y = degrees(angles.phiD);
      if (y < 0) y += 180;
      if (y >= 180) y -= 180;
    }
  }
  const auto [rangeX, rangeY] = ranges();
  return nearestNode(y, rangeY.low, rangeY.high, intervals) * nodes() +
         nearestNode(x, rangeX.low, rangeX.high, intervals);
}

void ErrorGrid::visit(std::size_t azimuths, Symmetry symmetry, const Visit& visit) const {
  const auto above = [&](const DirectionPair& pair, double weight) {
    if (pair.wi[2] > 0 && pair.wo[2] > 0) visit(pair, weight);
  };
  const Share share(azimuths, symmetry);
  const double otherRange = symmetry == Symmetry::Isotropic ? kPi : 2 * kPi;
  for (std::size_t node = 0; node < nodes() * nodes(); ++node) {
    const std::size_t x = node % nodes(), y = node / nodes();
    if (axes == ErrorAxes::Hemisphere) {
      const double u = 2 * static_cast<double>(x) / static_cast<double>(intervals) - 1;
      const double v = 2 * static_cast<double>(y) / static_cast<double>(intervals) - 1;
      const double r = std::hypot(u, v);
      if (r >= 1) continue;
      const Direction wo = fromSpherical(diskTheta(projection, r), r > 0 ? std::atan2(v, u) : 0);
      above({fromSpherical(thetaI, phiI), wo}, projection == DiskProjection::EqualArea ? 1 : 1 / wo[2]);
      continue;
    }
    const Interval xs = polarInterval(x, intervals), ys = polarInterval(y, intervals);
    const double atX = polarAngle(x, intervals), atY = polarAngle(y, intervals);
    for (std::size_t turn = 0; turn < share.turns; ++turn) {
      const double turnedBy = 2 * kPi * static_cast<double>(turn) / static_cast<double>(share.turns);
      for (std::size_t k = 0; k < share.others; ++k) {
        if (axes == ErrorAxes::IncidentOutgoing) {
          above({fromSpherical(atX, turnedBy), fromSpherical(atY, turnedBy + midpoint(k, share.others, otherRange))},
                xs.ring() * ys.ring());
        } else if (axes == ErrorAxes::HalfDifference) {
          // d omega_i d omega_o = 4 cos(theta_d) d omega_h d omega_d.
          const double sinLow = std::sin(ys.low), sinHigh = std::sin(ys.high);
          above(fromHalfDifference({atX, turnedBy, atY, midpoint(k, share.others, otherRange)}),
                xs.ring() * (sinHigh * sinHigh - sinLow * sinLow));
        } else {
          const double thetaH = midpoint(k, share.others, kPi / 2);
          const double sinLow = std::sin(xs.low), sinHigh = std::sin(xs.high);
          above(fromHalfDifference({thetaH, turnedBy, atX, 2 * atY + (k % 2 == 0 ? 0 : kPi)}),
                std::sin(thetaH) * (sinHigh * sinHigh - sinLow * sinLow) * (ys.high - ys.low));
        }
      }
    }
  }
}

}  // namespace brdf
