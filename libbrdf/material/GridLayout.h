#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/material/Brdf.h>
#include <brdf/material/GridAxis.h>
#include <brdf/material/TableLayout.h>

#include <cstdint>
#include <string>
#include <vector>

namespace brdf {

/// Which coordinates of a direction pair the axes of a grid are. A grid may leave some out: its values do not depend on
/// them, and its own directions have them at the value in brackets.
enum class Parametrisation {
  /// "spherical": theta_i [0], phi_i [0], theta_o [0], and phi_o or phi_difference [0]. An azimuth at a pole is 0.
  Spherical,
  /// "half_difference" (Rusinkiewicz 1998): theta_h [0], phi_h [0], theta_d [0], phi_d [90 degrees, where both
  /// directions are equally high].
  HalfDifference,
  /// "specular": theta_i [0], phi_i [0], specular_theta [0], specular_phi [0]. The mirror direction s of the light has
  /// the polar angle theta_i (plus GridLayout::specularOffsets) and the azimuth phi_i + 180 degrees. About it,
  /// specular_phi is 0 towards the normal (at normal incidence: towards the azimuth phi_i), right-handed about s:
  /// counter-clockwise for an observer at the tip of s who looks back at the surface. For transmission, whose viewer is
  /// mirrored through the surface (material/Components.h), s is the straight-through direction, mirrored likewise.
  Specular
};
/// The name given above.
BRDF_EXPORT std::string_view parametrisationName(Parametrisation parametrisation);

/// The symmetry by which a grid covers directions that its axes do not reach.
struct GridSymmetry {
  /// Mirrored pairs have the same value. Without phi_i or phi_h among the axes: mirrored in the plane of incidence, so
  /// that phi_difference, phi_d or specular_phi in [0, 180] degrees are enough (90 for phi_d of a reciprocal grid).
  /// With them: mirrored in the xz plane; phi_i or phi_h in [0, 180] degrees are enough.
  bool mirror = false;
  /// Light and viewer may change places. Half/difference: phi_d in half a turn is enough. Else: theta_i <= theta_o is
  /// enough.
  bool reciprocal = false;

  friend bool operator==(const GridSymmetry&, const GridSymmetry&) = default;
};

/// Where the values of a grid belong: the product of 1 to 4 axes, the first one fastest. Axes may stand in any order.
struct BRDF_EXPORT GridLayout {
  Parametrisation parametrisation = Parametrisation::Spherical;
  std::vector<GridAxis> axes;
  GridSymmetry symmetry{};
  /// Specular: what the polar angle of the reference direction exceeds theta_i by, one number for each node of theta_i
  /// (radians, linear in theta_i): refraction of the transmitted beam; -2 theta_i: back to the light. Empty: zero.
  std::vector<double> specularOffsets{};

  std::size_t cells() const;
  /// Index of the axis of this quantity, or axes.size().
  std::size_t find(AxisQuantity quantity) const;
  /// "phi_d 180 x theta_d 90 x theta_h 90, half_difference": for people.
  std::string text() const;
  /// Isotropic, Bilateral (the sign of the azimuth counts) or Anisotropic, by the axes and the symmetry.
  Symmetry surfaceSymmetry() const;
  /// Whether light and viewer may change places: by the symmetry, or because the axes cannot tell them apart.
  bool reciprocal() const;

  /// Throws Error::Kind::Value, naming `where`, for axes that do not belong together, nodes that are not ascending or
  /// out of their quantity's range, or more than 2^31 cells.
  void check(const std::string& where) const;

  /// Directions of the cells first .. first + length - 1; `pairs` is resized.
  void directions(std::size_t first, std::size_t length, DirectionPairBuffer<double>& pairs) const;
  /// 1 where both directions of a cell are above the horizon (by more than 1e-15: two roundings of a right angle are
  /// not).
  void aboveHorizon(std::size_t first, std::size_t length, std::uint8_t* above) const;

  friend bool operator==(const GridLayout&, const GridLayout&) = default;

  /// MERL's layout as a grid: cells (phi_d, theta_d, sqrt(theta_h)) in the same order.
  static GridLayout fromTable(const TableLayout& table);
};

}  // namespace brdf
