#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>
#include <brdf/view/Curve.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// The two angles that a slice spans, both from 0 to 90 degrees: x to the right, y upwards.
enum class SliceAxes {
  HalfDifference,   ///< "theta_h,theta_d" at fixed phi_d and phi_h: the image slices of Burley 2012, "Physically-Based
                    ///< Shading at Disney", figure 3: highlight left, grazing retro-reflection ("Fresnel") top
  IncidentOutgoing  ///< "theta_i,theta_o" at fixed phi_i and phi_o - phi_i
};
/// By the names given above; throws Error::Kind::Value for another one.
BRDF_EXPORT SliceAxes parseSliceAxes(std::string_view name);

/// Angles in radians; those that the axes do not use are ignored.
struct SliceOptions {
  SliceAxes axes = SliceAxes::HalfDifference;
  double phiD = kPi / 2;  ///< pi/2: light and viewer equally high, no pair of the slice below the horizon
  double phiH = 0;        ///< for anisotropic BRDFs
  double phiI = 0;        ///< for anisotropic BRDFs
  double phi = kPi;       ///< phi_o - phi_i; pi: the plane of incidence, mirror direction on the diagonal
  /// Along x, equal steps of the picture are equal steps of (angle / 90 degrees)^(1 / warp): 1 linear, 2 MERL's own
  /// spacing of theta_h, which widens the highlight. [0.1, 10].
  double warp = 1;
  std::size_t columns = 360, rows = 360;  ///< cells along x and y, 1 to 8192; a value is that of its cell's middle
};

/// The angles that stay, for people: "phi_d = 90 deg, phi_h = 0 deg".
BRDF_EXPORT std::string fixedAngles(const SliceOptions& options);

/// A plane of direction pairs, row after row, the first one at the bottom.
struct BRDF_EXPORT Slice {
  std::size_t columns = 0, rows = 0;
  std::vector<double> x, y;          ///< angles of the columns and of the rows, radians
  std::vector<double> values;        ///< planar: channel c of cell i at [c * count() + i], 1/sr
  std::vector<std::uint8_t> states;  ///< CellState (material/ValueOrigins.h), or kBelowHorizon

  std::size_t count() const { return columns * rows; }
  std::size_t countOf(std::uint8_t state) const;
};

/// Throws Error::Kind::Value when an option is out of its range.
BRDF_EXPORT Slice makeSlice(const Brdf& brdf, const SliceOptions& options);

}  // namespace brdf
