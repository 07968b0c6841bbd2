#pragma once
// The shapes of a microsurface, repeated over a block of tiles, as Embree takes them. Internal to libbrdf/simulate.
#include <brdf/geometry/Directions.h>
#include <brdf/simulate/Microsurface.h>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <vector>

namespace brdf {

/// Some whole tiles that stand for all: rays that leave it on one side come back on the other. Embree keeps floats, so
/// that its coordinates count from the middle.
struct TileBlock {
  double width = 1, depth = 1;     ///< along x and y, micrometres
  double lowest = 0, highest = 0;  ///< of the shapes, z
  std::size_t tilesX = 1, tilesY = 1;
  double margin = 0;  ///< what is beyond the border of the block is there up to this distance
  Direction middle{};
  double rounding = 0;  ///< by what float coordinates may be off

  /// Of whole tiles; as many that rays seldom cross its border, where `primitivesInTile` are few enough.
  TileBlock(double periodX, double periodY, double bottom, double top, std::size_t primitivesInTile);
  /// Throws Error::Kind::Value for more than 2^27 of them: memory.
  static void checkCount(std::size_t primitives);
};

/// Where a ray meets a facet. Coordinates are the block's.
struct Meeting {
  Direction position, normal;  ///< outwards, unit
  std::uint8_t facet = 0;
  double offset = 0;  ///< how far beside the surface a ray has to start to leave it
};

/// A ray, for geometry that is met in double precision.
struct DoubleRay {
  Direction origin, direction;
};

struct FieldTiles {
  explicit FieldTiles(const HeightField& field);
  RTCGeometry geometry(RTCDevice device) const;
  void resolve(const RTCRayHit& hit, const DoubleRay& ray, Meeting& meeting) const;

  TileBlock block;
  double spacingX, spacingY;
  std::uint32_t columns, rows;  ///< cells of the block with its margin of one cell around
  std::vector<float> heights;   ///< at the nodes of these cells, row by row
};

struct MeshTiles {
  explicit MeshTiles(const TiledMesh& mesh);
  RTCGeometry geometry(RTCDevice device) const;
  void resolve(const RTCRayHit& hit, const DoubleRay& ray, Meeting& meeting) const;

  TileBlock block;
  std::vector<std::array<float, 3>> points;  ///< about the middle of the block
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint8_t> facets;
};

struct SphereTiles {
  explicit SphereTiles(const SpherePacking& packing);
  RTCGeometry geometry(RTCDevice device) const;
  void resolve(const RTCRayHit& hit, const DoubleRay& ray, Meeting& meeting) const;

  struct Sphere {
    Direction centre;
    double radius;
  };
  TileBlock block;
  std::vector<Sphere> spheres;
};

/// What travels with a query: for geometry that is met in double precision.
struct TileQuery {
#if RTC_VERSION_MAJOR >= 4
  RTCRayQueryContext context;
#else
  RTCIntersectContext context;
#endif
  const DoubleRay* ray;
};

}  // namespace brdf
