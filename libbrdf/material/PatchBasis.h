#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>

#include <cstddef>
#include <string>
#include <vector>

namespace brdf {

/// Directions of the hemisphere in patches: rings between polar angles, each cut into equal azimuths. Patches are
/// numbered ring by ring from the pole; patch k of a ring of n is centred at the azimuth 360 k/n degrees, so that patch
/// 0 straddles the azimuth 0. (J. H. Klems 1994, "A New Method for Predicting the Solar Heat Gain of Complex
/// Fenestration Systems: 1. Overview and Derivation of the Matrix Layer Calculation", ASHRAE Transactions 100(1), whose
/// bases are rings of this kind.)
class BRDF_EXPORT PatchBasis {
 public:
  struct Ring {
    double upperTheta;  ///< radians; the lower bound is the ring's before, 0 for the first
    std::size_t count;  ///< of patches
    friend bool operator==(const Ring&, const Ring&) = default;
  };
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);

  /// Throws Error::Kind::Value unless the bounds ascend within (0, 90] degrees, there are at most 1000 rings, and each
  /// has 1 to 100000 patches.
  PatchBasis(std::string name, std::vector<Ring> rings);

  /// The bases that Radiance and WINDOW call "LBNL/Klems Full" (145 patches), "LBNL/Klems Half" (77, as Radiance has
  /// it) and "LBNL/Klems Quarter" (41).
  static const PatchBasis& klemsFull();
  static const PatchBasis& klemsHalf();
  static const PatchBasis& klemsQuarter();

  const std::string& name() const { return name_; }
  const std::vector<Ring>& rings() const { return rings_; }
  std::size_t count() const { return first_.back(); }
  double lowerTheta(std::size_t ring) const { return ring == 0 ? 0 : rings_[ring - 1].upperTheta; }

  /// The patch that holds a direction (unit); lower bounds belong to a patch, upper ones to the next. npos below the
  /// horizon and beyond the last ring.
  std::size_t find(double x, double y, double z) const;
  /// The integral of the cosine over the patch, sr: pi (cos^2 lower - cos^2 upper)/n.
  double projectedSolidAngle(std::size_t patch) const { return projected_[ringOf(patch)]; }
  /// Its solid angle, sr: 2 pi (cos lower - cos upper)/n.
  double solidAngle(std::size_t patch) const;
  /// The direction of the mean polar angle (0 for a ring of one patch at the pole) and the mean azimuth.
  Direction centre(std::size_t patch) const;
  /// The direction at u, v in [0, 1] of the patch, uniform in projected solid angle: u from the lower to the upper
  /// polar angle, v along the azimuth.
  Direction at(std::size_t patch, double u, double v) const;
  /// The patch whose azimuths are this one's negated.
  std::size_t mirrored(std::size_t patch) const;

  /// Same rings; names do not count.
  friend bool operator==(const PatchBasis& a, const PatchBasis& b) { return a.rings_ == b.rings_; }

 private:
  std::size_t ringOf(std::size_t patch) const;

  std::string name_;
  std::vector<Ring> rings_;
  std::vector<std::size_t> first_;  ///< patch of each ring, and the end
  std::vector<double> upperCos_;    ///< cosine of each ring's upper bound
  std::vector<double> projected_;   ///< solid angle of a patch of each ring, sr
};

}  // namespace brdf
