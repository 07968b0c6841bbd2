#pragma once
#include <brdf/brdf_export.h>
#include <brdf/render/Scene.h>

namespace brdf {

/// Drops triangles without an area: with a corner twice, or corners on a line to within rounding. Returns how many.
/// Points stay.
BRDF_EXPORT std::size_t removeDegenerateTriangles(TriangleMesh& mesh);

/// Makes the normals of a mesh unit (where one is zero, the mean of its triangles' takes its place) and turns the
/// corners of triangles around that face against their normals: front and back are told by the corners.
BRDF_EXPORT void settleNormals(TriangleMesh& mesh);

/// Gives a mesh with normals its tangents, unit and across the normals, where it has none: what both renderers use.
/// With texture coordinates they point to where u grows: dp/du of each triangle (E. Lengyel 2001, "Computing Tangent
/// Space Basis Vectors for an Arbitrary Mesh", Terathon Software), its parts at a point weighted by the angles of the
/// triangles there (as M. Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited", University of Copenhagen, does).
/// Else, and where texture coordinates tell nothing, around the object's y axis, as on the sphere: y x n, or +x where
/// the normal is vertical; smooth but there.
BRDF_EXPORT void addTangents(TriangleMesh& mesh);

}  // namespace brdf
