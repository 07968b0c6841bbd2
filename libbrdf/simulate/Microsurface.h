#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>
#include <brdf/simulate/HeightField.h>

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace brdf {

/// What a point of a microsurface does with light. The outside has the refractive index 1. A dielectric fills what its
/// facets enclose (of a height field and of the plane of a packing: all below). Where several overlap, the first of
/// Microsurface::facets is there (J. Schmidt and B. Budge 2002, "Simple Nested Dielectrics in Ray Traced Images", DOI
/// 10.1080/10867651.2002.10487555).
struct Facet {
  enum class Kind {
    Mirror,      ///< reflects everything
    Conductor,   ///< mirror with Fresnel's reflectance of the index eta + i k; the rest is absorbed
    Dielectric,  ///< reflects and refracts by Fresnel with the index eta; inside, absorbs by `absorption`
    Lambertian,  ///< reflects `albedo`, cosine-distributed; the rest is absorbed
    Scattering   ///< reflects by `brdf` in the frame of the facet; the rest is absorbed
  };
  Kind kind = Kind::Mirror;
  std::vector<double> eta{}, k{};    ///< refractive index: one number, or one a channel
  std::vector<double> albedo{};      ///< in [0, 1]: one number, or one a channel
  std::vector<double> absorption{};  ///< 1 / micrometre inside a dielectric (Beer-Lambert): one, one a channel, or none
  BrdfPointer brdf{};                ///< Scattering; channels as the simulation's, or one
};

constexpr std::size_t kMostDielectrics = 8;  ///< among the facets of one microsurface

/// Triangles in a tile that repeats without end along x and y. +z is outwards; triangles may reach beyond the tile.
struct TiledMesh {
  std::vector<std::array<float, 3>> points{};             ///< micrometres
  std::vector<std::array<std::uint32_t, 3>> triangles{};  ///< indices of points, counter-clockwise seen from outside
  std::vector<std::uint8_t> facets{};                     ///< index in Microsurface::facets, one a triangle; empty: 0
  double periodX = 1, periodY = 1;                        ///< micrometres, > 0
};

/// Spheres in a tile that repeats without end along x and y, above a plane or in the air.
struct SpherePacking {
  struct Sphere {
    std::array<float, 3> centre;  ///< micrometres
    float radius;                 ///< micrometres, > 0
  };
  std::vector<Sphere> spheres{};
  double periodX = 1, periodY = 1;  ///< micrometres, > 0
  /// Whether the plane z = 0 is there, with the second of Microsurface::facets. Spheres may lie partly or wholly below
  /// it: then, of an opaque plane, what is above counts; of a dielectric plane all.
  bool substrate = true;
};

/// A surface too small to be seen, whose reflection as a whole is a BRDF: one tile of it, repeated without end. The
/// mean plane is z = const, outwards is +z, the tangent of the BRDF is +x.
struct Microsurface {
  std::variant<HeightField, TiledMesh, SpherePacking> shape;
  /// What they are made of: of a height field the first; of a mesh by TiledMesh::facets; of a packing the spheres' and
  /// the plane's.
  std::vector<Facet> facets{1};
  Channels channels{};
  std::string description{};  ///< one line: kind and parameters

  /// How many facets the shape speaks of: of a packing with its plane 2, of a mesh what TiledMesh::facets asks for.
  BRDF_EXPORT std::size_t facetsNeeded() const;
  /// Throws Error::Kind::Value, naming `where`, for what cannot be traced.
  BRDF_EXPORT void check(const std::string& where) const;
};

}  // namespace brdf
