#pragma once
#include <brdf/brdf_export.h>
#include <brdf/render/Ray.h>
#include <brdf/render/Scene.h>

#include <limits>
#include <memory>

namespace brdf {

/// Where a ray meets a surface.
struct SurfacePoint {
  std::size_t object = 0;
  double distance = 0;
  Position position;
  Direction geometricNormal;  ///< of the surface itself, outwards
  Direction normal;           ///< for shading: interpolated between the corners of a triangle
  Direction tangent;          ///< unit, across the shading normal
  double margin = 0;          ///< by what rounding may have moved the position
};

/// The scene's geometry, ready for rays (Embree). Immutable; safe to share among threads. Spheres are met in double
/// precision, triangles in float.
class BRDF_EXPORT RayCaster {
 public:
  explicit RayCaster(const Scene& scene);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// The first surface that the ray meets, if any.
  bool meet(const Ray& ray, SurfacePoint& point) const;
  /// Whether something lies between the ray's origin and `distance`.
  bool blocked(const Ray& ray, double distance = std::numeric_limits<double>::infinity()) const;

  /// Index of an object's material.
  std::size_t material(std::size_t object) const;

  /// A start for rays that leave `point` towards `direction`: beside the surface by what rounding may have moved it.
  Position leaving(const SurfacePoint& point, const Direction& direction) const;

 private:
  struct Geometry;
  std::unique_ptr<Geometry> geometry_;
};

}  // namespace brdf
