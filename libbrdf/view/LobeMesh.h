#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>
#include <brdf/view/LobeTransform.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace brdf {

/// What the distance of the surface from the origin stands for, T being the transform.
enum class LobeShape {
  Value,       ///< T(f)
  Difference,  ///< |T(f) - T(g)|, g another BRDF
  Displaced    ///< R + T(f) - T(g): a hemisphere of radius R, the largest |T(f) - T(g)|, dented and raised
};

struct LobeMeshOptions {
  double thetaI = radians(45);  ///< incident polar angle, [0, pi/2)
  double phiI = 0;              ///< incident azimuth
  LobeScale scale;
  std::vector<double> weights;  ///< the value shown is the sum of weight * channel; empty: the mean of all channels
  unsigned subdivisions = 5;    ///< of the starting mesh, [0, 9]: edges of 90 degrees / 2^subdivisions
  /// An edge is split while the surface leaves it by more than this share of the largest radius (judged at its
  /// quarters); 0 never splits.
  double tolerance = 1e-3;
  /// No edge is split for its bend below this length on the unit sphere (below a sixteenth of its distance to the
  /// mirror and retro directions, near those): a step in the data (measured samples change neighbours) would otherwise
  /// be followed without end.
  double smallestBend = radians(0.25);
  /// Edges are a quarter of their distance to the mirror and retro directions, down to this length on the unit sphere.
  double smallestPeak = radians(0.001);
  /// Refinement stops before there are more, the largest errors first; the starting mesh is always whole.
  std::size_t maximumTriangles = 200'000;
  LobeShape shape = LobeShape::Value;
};

/// The lobe of a BRDF for one incident direction: a geodesic hemisphere of view directions, each moved out to the
/// transformed value. Finer where the surface bends, and around the mirror and retro-reflected directions, which are
/// vertices (but for tolerance 0): a lobe of a thousandth of a degree there is not missed. A peak elsewhere is found
/// when the starting mesh shows a trace of it.
struct LobeMesh {
  std::vector<Direction> directions;                    ///< unit; z = 0 exactly on the rim
  std::vector<double> values;                           ///< planar: channel c of vertex i at c * count + i, 1/sr
  std::vector<std::uint8_t> valid;                      ///< 0 where a BRDF has no value, or none that is finite
  std::vector<double> lengths;                          ///< T(f) or T(f) - T(g); 0 where invalid
  std::vector<double> radii;                            ///< >= 0
  std::vector<Direction> normals;                       ///< unit, of the displaced surface
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside; none with an invalid corner
  double maximumRadius = 0;
  double maximumLength = 0;    ///< the largest |length|
  double referenceRadius = 0;  ///< R of LobeShape::Displaced, else 0
  double chordError = 0;       ///< the largest seen at the quarters of the edges left whole, share of maximumRadius
  bool complete = true;        ///< false when refinement stopped for maximumTriangles before the tolerance was met

  std::size_t vertexCount() const { return directions.size(); }
  Direction position(std::size_t i) const {
    return {radii[i] * directions[i][0], radii[i] * directions[i][1], radii[i] * directions[i][2]};
  }
};

/// `other` is g, with the channels of `brdf`; null for LobeShape::Value only. `values` of differences are f - g.
/// Throws Error::Kind::Value when an option is out of its range. Vertices on the rim are evaluated 1e-4 above the
/// horizon, where every BRDF still has its limit instead of the 0 at the horizon itself.
BRDF_EXPORT LobeMesh makeLobeMesh(const Brdf& brdf, const LobeMeshOptions& options, const Brdf* other = nullptr);

/// Values (planar, 1/sr) for one incident direction at view directions, those on the rim as makeLobeMesh() has them;
/// not finite is 0 and invalid.
BRDF_EXPORT std::vector<double> valuesOverHemisphere(const Brdf& brdf, const Direction& wi,
                                                     const std::vector<Direction>& wo,
                                                     std::vector<std::uint8_t>& valid);

}  // namespace brdf
