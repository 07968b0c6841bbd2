#pragma once
#include <brdf/brdf_export.h>
#include <brdf/render/Scene.h>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace brdf {

/// A piece of a profile: from one place to another on a straight line or an arc. The profile runs from bottom to top on
/// the right of the axis, so that the outside is on its right; pieces meet at edges, sharp where their directions
/// differ.
struct ProfilePiece {
  std::array<double, 2> from, to;                 ///< distance from the axis (>= 0) and height
  std::optional<std::array<double, 2>> centre{};  ///< of an arc, as far from one end as from the other; empty: straight
  bool counterClockwise = true;                   ///< the way the arc runs
};

/// The surface that a profile sweeps around the y axis, with exact normals, tangents around the axis, and `around`
/// corners to a circle.
BRDF_EXPORT TriangleMesh makeLathed(std::span<const ProfilePiece> profile, std::size_t around);

/// A shape of the core: see shapeNames. Empty for a name that is none.
BRDF_EXPORT std::optional<TriangleMesh> makeShape(std::string_view name);

struct ShapeName {
  std::string_view name, meaning;
};
/// Shapes about the origin: "sphere" aside, which scenes draw exactly round without a mesh.
BRDF_EXPORT std::span<const ShapeName> shapeNames();

}  // namespace brdf
