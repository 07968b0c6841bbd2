#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// What a map of directions spans.
enum class ErrorAxes {
  IncidentOutgoing,   ///< x = theta_i, y = theta_o, 0 to 90 degrees; over both azimuths
  HalfDifference,     ///< x = theta_h, y = theta_d, 0 to 90 degrees; over phi_h and phi_d
  DifferenceAzimuth,  ///< x = theta_d, 0 to 90 degrees, y = phi_d, 0 to 180 (phi_d and phi_d + 180 degrees exchange
                      ///< light and viewer and count together); over theta_h and phi_h
  Hemisphere          ///< the view directions of one incident direction as a disk seen from above, +x to the right
};
/// "theta_i,theta_o", "theta_h,theta_d", "theta_d,phi_d" or "hemisphere"; throws Error::Kind::Value for another name.
BRDF_EXPORT ErrorAxes parseErrorAxes(std::string_view name);
BRDF_EXPORT std::vector<std::string> errorAxesNames();

/// The hemisphere as the unit disk: r is the distance from its centre, the azimuth is kept.
enum class DiskProjection {
  EqualArea,    ///< Lambert's azimuthal: r = sqrt(2) sin(theta / 2); equal areas are equal solid angles
  Orthographic  ///< r = sin(theta); equal areas are equal projected solid angles
};
/// "equal-area" or "orthographic"; throws Error::Kind::Value for another name.
BRDF_EXPORT DiskProjection parseDiskProjection(std::string_view name);
BRDF_EXPORT std::vector<std::string> diskProjectionNames();
BRDF_EXPORT double diskRadius(DiskProjection projection, double theta);  ///< of theta in [0, pi/2], [0, 1]
BRDF_EXPORT double diskTheta(DiskProjection projection, double r);       ///< its inverse

/// The nodes of a map, row after row: node (x, y) stands for what is within half an interval of it.
struct ErrorGrid {
  ErrorAxes axes = ErrorAxes::IncidentOutgoing;
  std::size_t intervals = 90;   ///< along each axis
  double thetaI = radians(45);  ///< Hemisphere: the incident direction, [0, pi/2)
  double phiI = 0;
  DiskProjection projection = DiskProjection::EqualArea;
  /// Hemisphere: pairs whose incident direction lies within this angle count; of isotropic and bilateral BRDFs the pair
  /// is turned about the normal to the incident azimuth first.
  double within = radians(2.5);

  std::size_t nodes() const { return intervals + 1; }  ///< along each axis
  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

  /// The node that a pair counts at; kNowhere for pairs of another incident direction (Hemisphere).
  BRDF_EXPORT std::size_t nodeOf(const Direction& wi, const Direction& wo, Symmetry symmetry) const;

  /// First and last value along each axis: degrees, or -1 to 1 on the disk.
  struct Range {
    double low, high;
  };
  BRDF_EXPORT std::array<Range, 2> ranges() const;

  /// A pair of directions at a node with the measure d omega_i d omega_o that it stands for, up to a common factor.
  using Visit = std::function<void(const DirectionPair& pair, double weight)>;
  /// Pairs at every node: `azimuths` for what the axes leave free (less where an isotropic symmetry needs less), 1 on
  /// the hemisphere. Those below the horizon are left out.
  BRDF_EXPORT void visit(std::size_t azimuths, Symmetry symmetry, const Visit& visit) const;
};

}  // namespace brdf
