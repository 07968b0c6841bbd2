#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>
#include <brdf/measured/Warp2D.h>

#include <string>
#include <vector>

namespace brdf {

/// The arrays of an RGL file, all float, last index fastest (J. Dupuy, W. Jakob, "An Adaptive Parameterization for
/// Efficient Material Acquisition and Rendering", ACM TOG 37(6), 2018; their file format's field names). The
/// conditioning direction, theta_i and phi_i there, is the viewer here, whose partner, the light, is drawn.
struct RglData {
  std::vector<float> phi, theta;  ///< radians, ascending; of the conditioning directions
  struct Grid {
    std::size_t width = 0, height = 0;  ///< nodes along x (polar angle) and y (azimuth)
    std::vector<float> values;
  };
  Grid ndf, sigma;       ///< [y][x]
  Grid vndf, luminance;  ///< [phi][theta][y][x]
  Grid spectra;          ///< [phi][theta][channel][y][x]
  Channels channels;     ///< RGB, or the wavelengths
  bool jacobian = true;  ///< whether spectra is to be multiplied by ndf/(4 sigma)
};

/// A BRDF in the parametrisation of RGL's measurements: half vectors by the density of visible normals. Directions m
/// and the viewer go to the unit square by x = sqrt(2 theta/pi), y = (phi + pi)/(2 pi) (phi from the viewer's when
/// isotropic). m goes through the inverse of the visible-normal warp of the viewer; there the spectra are looked up,
/// bilinear in the square and in the viewer's angles. What is stored is f cos(theta_light); it is divided by the
/// cosine, but by no less than that of 85 degrees, beyond which the quotient of two numbers near 0 would be noise.
///
/// Draws by its own luminance and visible-normal warps: the density is exact.
class BRDF_EXPORT RglBrdf : public Brdf {
 public:
  /// Throws Error::Kind::Value when the arrays disagree in size.
  RglBrdf(RglData data, std::string description);

  const Channels& channels() const override { return channels_; }
  Symmetry symmetry() const override { return isotropic_ ? Symmetry::Bilateral : Symmetry::Anisotropic; }
  bool reciprocal() const override { return false; }
  std::string description() const override { return description_; }
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override;
  using Brdf::evaluate;
  void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
              const std::array<double*, 3>& wi, std::size_t count) const override;
  void pdf(const DirectionPairs<double>& pairs, double* density) const override;

  bool isotropic() const { return isotropic_; }
  /// How many times the measured azimuths cover a turn: 1, 2 (turned by 180 degrees) or 4 (mirrored); 1 if isotropic.
  int reduction() const { return reduction_; }

  /// ndf/(4 sigma) where light and viewer meet.
  double factor(const Direction& m, const Direction& viewer) const;
  /// The half vector that a point of the square of the viewer's spectra stands for; (0, 0, 0) for none.
  Direction halfVector(const Warp2D::Point& at, const Direction& viewer) const;

  /// Below this cosine of the light values are not divided further: that of 85 degrees.
  static constexpr double kLeastCosine = 0.08715574274765817;

 private:
  struct Turned;
  Turned turn(const Direction& viewer) const;
  Warp2D::Point halfPoint(const Direction& m, double phi) const;

  std::string description_;
  Channels channels_;
  bool isotropic_, jacobian_;
  int reduction_ = 1;
  double phiStart_ = 0, phiRange_ = 0;
  Warp2D ndf_, sigma_, vndf_, luminance_;
  std::vector<float> spectra_;
  std::size_t width_, height_;
};

}  // namespace brdf
