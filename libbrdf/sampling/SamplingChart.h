#pragma once
#include <brdf/geometry/Directions.h>

namespace brdf {

/// Coordinates of the light direction for a fixed viewer, each polar about a pole where some kind of BRDF has its peak.
/// The pole angle enters as x = sin^2(theta/2), which keeps its digits near the pole and is uniform in solid angle:
/// d omega = 2 dx dphi.
enum class Chart {
  Half,   ///< the half vector about the normal: mirror-like peaks, x in [0, 1/2]
  Retro,  ///< the light about the viewer: retro-reflective peaks, x in [0, 1]
  Light   ///< the light about the normal: all the rest, x in [0, 1/2]
};

constexpr double maximumX(Chart chart) { return chart == Chart::Retro ? 1.0 : 0.5; }

/// A viewer above the horizon with what the charts need of it.
struct ChartViewer {
  Direction wo;
  double cosPhi, sinPhi;    ///< azimuth of wo; where it is undefined, 0
  double cosZero, sinZero;  ///< azimuth at which phi starts in the charts about the normal
  double sinTheta;          ///< of wo

  /// `turning`: phi is counted from the viewer's azimuth (surfaces that may be turned), else from the tangent.
  ChartViewer(const Direction& wo, bool turning);
  /// At polar angle `theta` and azimuth `phi` (radians), which counts at the pole too.
  ChartViewer(double theta, double phi, bool turning);
};

struct ChartPoint {
  double x;
  double phi;       ///< [0, 2 pi)
  double jacobian;  ///< d omega_i / (2 dx dphi); 0 where there is no such direction above the horizon
};

ChartPoint toChart(Chart chart, const ChartViewer& viewer, const Direction& wi);

/// The light direction at (x, phi); jacobian as in ChartPoint and wi = (0, 0, 0) where it is 0.
double fromChart(Chart chart, const ChartViewer& viewer, double x, double phi, Direction& wi);

}  // namespace brdf
