#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/GridLayout.h>

#include <array>
#include <cstdint>
#include <vector>

namespace brdf {

/// The cells of a grid for one incident direction: where light that leaves is counted. Reflected light by its
/// direction; transmitted light by its direction mirrored through the surface, (x, y, -z) (material/Components.h).
///
/// The layout is spherical (theta_o, and phi_o or phi_difference) or specular (specular_theta, specular_phi), its
/// outgoing axes cell-centred; bins are numbered like the cells, the layout's first outgoing axis fastest. Axes that
/// the layout leaves out are one bin wide: a full turn of azimuth.
class BRDF_EXPORT OutgoingBins {
 public:
  /// Angles of the light, radians. Throws Error::Kind::Value, naming `where`, for a layout whose outgoing axes cannot
  /// count: half/difference, node-centred, or assuming reciprocity.
  OutgoingBins(const GridLayout& layout, double thetaI, double phiI, const std::string& where = "outgoing directions");

  std::size_t count() const { return count_; }
  /// The bin that holds a direction above the horizon, or count() where no axis reaches it.
  std::size_t find(const Direction& wo) const;
  /// Coordinates of a direction above the horizon on the outgoing axes, radians: polar angle about the pole, and
  /// azimuth within the range of its axis.
  std::array<double, 2> coordinates(const Direction& wo) const;
  /// Integral of cos theta_o over the part of each bin above the horizon, sr; a bin and its mirror images that the
  /// layout's symmetry folds onto it are one. They sum to pi where the axes reach everywhere.
  const std::vector<double>& projectedSolidAngles() const { return measures_; }

  /// A direction that is uniform in solid angle within a bin, for u and v uniform in [0, 1) and `image` in [0, 1),
  /// which chooses among the mirror images that are folded onto the bin; it may be below the horizon.
  Direction direction(std::size_t bin, double u, double v, double image) const;
  /// Of a bin and its mirror images, the parts below the horizon included, sr.
  double solidAngle(std::size_t bin) const;

  /// Rings of bins about the pole (the normal, or the mirror direction), and the one that a bin belongs to.
  std::size_t rings() const { return polar_.edges.size() - 1; }
  std::size_t ring(std::size_t bin) const { return bin / polar_.stride % rings(); }

  double thetaI() const { return thetaI_; }
  double phiI() const { return phiI_; }
  /// Specular: by how much the pole's polar angle exceeds theta_i (GridLayout::specularOffsets); else 0.
  double specularOffset() const { return specular_ ? poleTheta_ - thetaI_ : 0; }
  /// The light.
  Direction wi() const { return fromSpherical(thetaI_, phiI_); }

 private:
  struct Axis {
    std::vector<double> edges;  ///< of the cells: of a polar angle sin^2 of it (spherical) or of its half; radians
    std::vector<std::uint32_t> guide;  ///< by equal steps of the range, how many edges are not above the step's start
    double first = 0, steps = 0;       ///< of the range; steps a unit
    std::size_t stride = 1;
    void prepare();
    std::size_t find(double value) const;  ///< edges.size() where none
  };
  /// sin^2 of the polar angle (spherical) or of its half, as Axis::edges has it, and the azimuth within its range.
  std::array<double, 2> place(const Direction& wo) const;
  double measure(double polar0, double polar1, double azimuth0, double azimuth1) const;

  double thetaI_, phiI_;
  bool specular_ = false, folded_ = false;
  double reference_ = 0, period_ = 2 * kPi;    ///< of the azimuth
  double poleTheta_ = 0;                       ///< specular: of the mirror direction
  Direction pole_, towardsNormal_, across_{};  ///< specular: it, and the axes of azimuth 0 and 90 degrees
  Axis polar_, azimuth_;
  std::vector<double> cosines_;  ///< of the edges of the polar angle
  std::size_t count_ = 1;
  std::vector<double> measures_;
};

}  // namespace brdf
