#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// The angle that a curve runs over.
enum class CurveAngle {
  ThetaO,  ///< "theta_o", -90 to 90 degrees: the polar angle of the viewer in the plane that contains the normal, with
           ///< the azimuth phi_i + `phi` where positive and the opposite one where negative
  Phi,     ///< "phi", -180 to 180 degrees: phi_o - phi_i at fixed theta_i and theta_o
  ThetaH,  ///< "theta_h", 0 to 90 degrees at fixed theta_d, phi_d, phi_h
  ThetaD,  ///< "theta_d", 0 to 90 degrees at fixed theta_h, phi_d, phi_h
  PhiD     ///< "phi_d", -180 to 180 degrees at fixed theta_h, theta_d, phi_h
};
/// The name given above, and back; the latter throws Error::Kind::Value for another one.
BRDF_EXPORT std::string_view curveAngleName(CurveAngle angle);
BRDF_EXPORT CurveAngle parseCurveAngle(std::string_view name);

/// A line of direction pairs. Angles in radians; those that the curve does not use are ignored.
struct CurveOptions {
  CurveAngle angle = CurveAngle::ThetaO;
  double thetaI = radians(45);  ///< ThetaO, Phi: [0, pi/2)
  double phiI = 0;              ///< ThetaO, Phi
  double thetaO = radians(45);  ///< Phi: [0, pi/2)
  double phi = kPi;             ///< ThetaO: phi_o - phi_i of the positive side; pi: that of the mirror direction
  double thetaH = 0;            ///< ThetaD, PhiD: [0, pi/2)
  double phiH = 0;              ///< ThetaH, ThetaD, PhiD
  double thetaD = 0;            ///< ThetaH, PhiD: [0, pi/2)
  double phiD = kPi / 2;        ///< ThetaH, ThetaD; pi/2: light and viewer equally high
  std::size_t intervals = 360;  ///< equal ones between the ends, 1 to 100,000
  bool middles = false;         ///< values at the middles of the intervals only, instead of their ends and near peaks
};

/// The angles that stay, for people: "theta_i = 45 deg, phi_i = 0 deg, phi = 180 deg".
BRDF_EXPORT std::string fixedAngles(const CurveOptions& options);

/// Values along a line of direction pairs.
struct Curve {
  std::vector<double> angle;           ///< ascending, radians
  std::vector<double> values;          ///< planar: channel c of point i at [c * count() + i], 1/sr
  std::vector<std::uint8_t> states;    ///< CellState, or kBelowHorizon
  std::vector<double> cosThetaO;       ///< of the viewer
  std::vector<double> standardErrors;  ///< as values, NaN where unknown; empty where the BRDF has none

  std::size_t count() const { return angle.size(); }
};

/// State of a point one of whose directions is not above the horizon: there is no reflection, and no value is due.
constexpr std::uint8_t kBelowHorizon = 3;

/// The pair of directions at an angle (radians) of the curve.
BRDF_EXPORT DirectionPair curveDirections(const CurveOptions& options, double angle);

/// The BRDF at equal steps, and closer by the mirror and retro directions where the curve meets them (down to a
/// thousandth of a degree), so that no peak falls between. A point closer to the horizon than 1e-4 is evaluated at that
/// distance above it, where every BRDF still has its limit instead of the 0 of the horizon itself. What its values rest
/// on: material/ValueOrigins.h. Throws Error::Kind::Value when an option is out of its range.
BRDF_EXPORT Curve makeCurve(const Brdf& brdf, const CurveOptions& options);

/// Measured samples that lie by the curve.
struct CurveSamples {
  std::vector<double> angle;           ///< along the curve, radians, in no particular order
  std::vector<double> cosThetaO;       ///< of the sample's viewer
  std::vector<double> distance;        ///< from the curve: the larger one of both directions', radians
  std::vector<double> values;          ///< planar, 1/sr
  std::vector<double> standardErrors;  ///< as values, NaN where unknown; empty where the BRDF has none
  std::size_t leftOut = 0;             ///< more that lie as near, beyond `maximum`

  std::size_t count() const { return angle.size(); }
};

/// The valid samples of `brdf` (none where it has none) both of whose directions are within `tolerance` (radians, more
/// than 0) of the pair of the curve that has the same angle; those of isotropic BRDFs are turned and mirrored about the
/// normal to meet it. At most `maximum` samples, the nearest.
BRDF_EXPORT CurveSamples samplesByCurve(const Brdf& brdf, const CurveOptions& options, double tolerance,
                                        std::size_t maximum = 20'000);

}  // namespace brdf
