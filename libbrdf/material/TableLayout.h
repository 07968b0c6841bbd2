#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/DirectionPairs.h>

#include <cstdint>
#include <vector>

namespace brdf {

/// The cells of an isotropic table in half/difference coordinates (Rusinkiewicz 1998), in MERL's order: cell
/// (p, d, h) = p + phiD * (d + thetaD * h). Along x, phi_d in equal steps over [0, pi) (reciprocal) or [0, 2 pi); along
/// y, theta_d in equal steps over [0, 90] degrees; along z, sqrt(theta_h / 90 degrees) in equal steps over [0, 1], fine
/// near the mirror direction. Cell i of an axis covers [i, i + 1) steps; its centre is at i + 1/2.
struct TableLayout {
  std::size_t phiD = 180;
  std::size_t thetaD = 90;
  std::size_t thetaH = 90;
  /// Whether phi_d spans [0, pi): f(phi_d) = f(phi_d + pi), which is Helmholtz reciprocity.
  bool reciprocal = true;

  std::size_t cells() const { return phiD * thetaD * thetaH; }
  friend bool operator==(const TableLayout&, const TableLayout&) = default;
};

/// The directions of the cell centres, half vector in the xz plane (phi_h = 0), made on the fly from the sines and
/// cosines of each axis.
class BRDF_EXPORT TableDirections {
 public:
  explicit TableDirections(const TableLayout& layout);

  const TableLayout& layout() const { return layout_; }

  /// Centres of the cells first .. first + length - 1; `pairs` is resized.
  void directions(std::size_t first, std::size_t length, DirectionPairBuffer<double>& pairs) const;

  /// 1 where both directions of the cell's centre are above the horizon.
  void aboveHorizon(std::size_t first, std::size_t length, std::uint8_t* above) const;

 private:
  /// Calls body(row constants, first phi_d, count, offset from `first`) for each stretch of one (theta_d, theta_h).
  template <class Body>
  void forRows(std::size_t first, std::size_t length, const Body& body) const;

  TableLayout layout_;
  std::vector<double> cosPhi_, sinPhi_, cosThetaD_, sinThetaD_, cosThetaH_, sinThetaH_;
};

}  // namespace brdf
