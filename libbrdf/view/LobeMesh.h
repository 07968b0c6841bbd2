#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// How a value becomes a length: itself (1/sr), its cube root (sr^-1/3), or ln(1 + value). Negative values count as 0.
enum class LobeTransform { None, CubeRoot, Log };

BRDF_EXPORT double transformed(LobeTransform transform, double value);
/// "none", "cuberoot" or "log"; throws Error::Kind::Value for another name.
BRDF_EXPORT LobeTransform parseLobeTransform(std::string_view name);
/// What the length is, with its unit: "f_r (1/sr)", "cube root of f_r (sr^-1/3)", "ln(1 + f_r)" (f_r in 1/sr).
BRDF_EXPORT std::string lobeTransformLabel(LobeTransform transform);

struct LobeMeshOptions {
  double thetaI = radians(45);  ///< incident polar angle, [0, pi/2)
  double phiI = 0;              ///< incident azimuth
  LobeTransform transform = LobeTransform::None;
  std::vector<double> weights;  ///< the value shown is the sum of weight * channel; empty: the mean of all channels
  unsigned subdivisions = 5;    ///< of the starting mesh, [0, 9]: edges of 90 degrees / 2^subdivisions
  /// An edge is split while the surface leaves its chord by more than this share of the largest radius; 0 never splits.
  double tolerance = 1e-3;
  /// No edge is split for its bend below this length on the unit sphere: a step in the data (measured samples change
  /// neighbours) would otherwise be followed without end.
  double smallestBend = radians(0.25);
  double smallestPeak = radians(0.01);    ///< the same around the mirror and retro directions
  std::size_t maximumVertices = 200'000;  ///< refinement stops here
};

/// The lobe of a BRDF for one incident direction: a geodesic hemisphere of view directions, each moved out to the
/// transformed value. Finer where the surface bends, and around the mirror and retro-reflected directions, so that a
/// lobe of a hundredth of a degree is not missed.
struct LobeMesh {
  std::vector<Direction> directions;                    ///< unit; z = 0 exactly on the rim
  std::vector<double> values;                           ///< planar: channel c of vertex i at c * count + i, 1/sr
  std::vector<std::uint8_t> valid;                      ///< 0 where the BRDF has no value
  std::vector<double> radii;                            ///< transformed value, >= 0
  std::vector<Direction> normals;                       ///< unit, of the displaced surface
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside; none with an invalid corner
  double maximumRadius = 0;

  std::size_t vertexCount() const { return directions.size(); }
  Direction position(std::size_t i) const {
    return {radii[i] * directions[i][0], radii[i] * directions[i][1], radii[i] * directions[i][2]};
  }
};

/// Throws Error::Kind::Value when an option is out of its range. Vertices on the rim are evaluated 1e-4 above the
/// horizon, where every BRDF still has its limit instead of the 0 at the horizon itself.
BRDF_EXPORT LobeMesh makeLobeMesh(const Brdf& brdf, const LobeMeshOptions& options);

}  // namespace brdf
