#pragma once
#include <brdf/brdf_export.h>

#include <string_view>
#include <utility>
#include <vector>

namespace brdf {

/// What an axis of a grid measures; radians. Which of them stand together is the Parametrisation's matter.
enum class AxisQuantity {
  ThetaI,         ///< "theta_i": polar angle of the light
  PhiI,           ///< "phi_i": azimuth of the light
  ThetaO,         ///< "theta_o": polar angle of the viewer
  PhiO,           ///< "phi_o": azimuth of the viewer
  PhiDifference,  ///< "phi_difference": phi_o - phi_i
  ThetaH,         ///< "theta_h": polar angle of the half vector
  PhiH,           ///< "phi_h": azimuth of the half vector
  ThetaD,         ///< "theta_d": angle between the light and the half vector
  PhiD,           ///< "phi_d": azimuth of the light about the half vector
  SpecularTheta,  ///< "specular_theta": angle between the viewer and the mirror direction of the light
  SpecularPhi     ///< "specular_phi": azimuth of the viewer about that direction, 0 towards the normal, right-handed
};
/// The name given above.
BRDF_EXPORT std::string_view axisName(AxisQuantity quantity);
/// Whether it is an azimuth, which comes back after 2 pi.
BRDF_EXPORT bool isAzimuth(AxisQuantity quantity);

/// In what of the angle steps are counted and values interpolated linearly.
enum class AxisScale {
  Linear,      ///< the angle
  Cosine,      ///< its cosine; polar angles only
  Sine,        ///< its sine; polar angles up to 90 degrees only
  SquareRoot,  ///< its square root, fine near 0 (MERL's theta_h); polar angles only
};
/// "linear", "cosine", "sine", "square_root".
BRDF_EXPORT std::string_view scaleName(AxisScale scale);

/// What a look-up beyond the ends of an axis gives.
enum class Outside {
  Clamp,   ///< the value at the end
  Invalid  ///< none
};

/// One axis of a grid: n values at n ascending nodes (radians).
///
/// Node-centred (`edges` empty): the axis ends at its first and last node, and the nearest look-up goes to the node
/// that is nearest in the scale. Cell-centred: value k belongs to the cell between edges[k] and edges[k + 1], its node
/// being the middle in the scale; the axis ends at the outer edges, and between them and the outer nodes the value is
/// that of the outer cell.
struct GridAxis {
  AxisQuantity quantity = AxisQuantity::ThetaI;
  std::vector<double> nodes;  ///< ascending; one node alone: the values do not depend on this axis
  AxisScale scale = AxisScale::Linear;
  std::vector<double> edges{};  ///< none, or nodes.size() + 1, ascending
  /// Of an azimuth: after how much the values come back, and interpolation crosses the seam: 2 pi for a full turn, less
  /// where a symmetry says so. 0: it does not (the ends are ends). Nodes may start anywhere; first and last may be the
  /// same direction.
  double period = 0;
  Outside outside = Outside::Clamp;

  std::size_t size() const { return nodes.size(); }
  friend bool operator==(const GridAxis&, const GridAxis&) = default;

  /// `count` nodes from `first` to `last` inclusive, equally spaced in the scale.
  BRDF_EXPORT static GridAxis uniformNodes(AxisQuantity quantity, double first, double last, std::size_t count,
                                           AxisScale scale = AxisScale::Linear);
  /// `count` cells that fill first to last, equally wide in the scale.
  BRDF_EXPORT static GridAxis uniformCells(AxisQuantity quantity, double first, double last, std::size_t count,
                                           AxisScale scale = AxisScale::Linear);
  /// Nodes as listed, in degrees.
  BRDF_EXPORT static GridAxis listedDegrees(AxisQuantity quantity, const std::vector<double>& degrees);
  /// Cells between edges as listed, in degrees.
  BRDF_EXPORT static GridAxis cellsDegrees(AxisQuantity quantity, const std::vector<double>& edges,
                                           AxisScale scale = AxisScale::Linear);
  /// The same axis with the period 2 pi, or another.
  GridAxis periodic(double radians = 6.283185307179586) && {
    period = radians;
    return std::move(*this);
  }
};

/// The angle in the scale, ascending with the angle (for Cosine that is minus the cosine), and back.
BRDF_EXPORT double toScale(AxisScale scale, double angle);
BRDF_EXPORT double fromScale(AxisScale scale, double scaled);

}  // namespace brdf
