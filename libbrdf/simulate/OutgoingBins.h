#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/GridLayout.h>

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
  /// Integral of cos theta_o over the part of each bin above the horizon, sr; a bin and its mirror images that the
  /// layout's symmetry folds onto it are one. They sum to pi where the axes reach everywhere.
  const std::vector<double>& projectedSolidAngles() const { return measures_; }

  double thetaI() const { return thetaI_; }
  double phiI() const { return phiI_; }
  /// The light.
  Direction wi() const { return fromSpherical(thetaI_, phiI_); }

 private:
  struct Axis {
    std::vector<double> edges;  ///< of the cells: of a polar angle in its measure (see find()), of an azimuth radians
    std::vector<std::uint32_t> guide;  ///< first cell that may hold a value, by equal steps from first to last edge
    double scale = 0;                  ///< steps a unit
    std::size_t stride = 1;
    bool present = false, folded = false;
    std::size_t find(double value) const;
    void prepare();
  };
  void measure();
  double measureOf(double polar0, double polar1, double azimuth0, double azimuth1) const;

  double thetaI_, phiI_, reference_;  ///< reference_: azimuth from which the bins' azimuth counts
  bool specular_ = false;
  Direction mirror_, towardsNormal_, across_;  ///< specular: pole, and the axes of azimuth 0 and 90 degrees
  Axis polar_, azimuth_;
  std::size_t count_ = 1;
  std::vector<double> measures_;
};

}  // namespace brdf
