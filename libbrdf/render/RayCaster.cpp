#include <brdf/base/Error.h>
#include <brdf/render/RayCaster.h>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cmath>
#include <utility>

namespace brdf {
namespace {

#if RTC_VERSION_MAJOR >= 4
using QueryContext = RTCRayQueryContext;
#else
using QueryContext = RTCIntersectContext;
#endif

/// What travels with a query: the ray in double precision, for spheres.
struct Query {
  QueryContext context;  // first: Embree hands its address to the callbacks
  const Ray* ray;
};

Position along(const Ray& ray, double distance) {
  Position p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = ray.origin[k] + distance * ray.direction[k];
  return p;
}

struct Sphere {
  Position center;
  double radius;

  /// Distances at which the line of the ray enters and leaves; false when it passes by. Haines, Gunther, Akenine-Moller
  /// 2019, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, ch. 7: no cancellation for small or
  /// distant spheres.
  bool meet(const Ray& ray, double& enters, double& leaves) const {
    Position f, l;
    for (std::size_t k = 0; k < 3; ++k) f[k] = ray.origin[k] - center[k];
    const double b = -dot(f, ray.direction);
    for (std::size_t k = 0; k < 3; ++k) l[k] = f[k] + b * ray.direction[k];
    const double discriminant = radius * radius - dot(l, l);
    if (discriminant <= 0) return false;
    const double outside = dot(f, f) - radius * radius;  // > 0 in front of the surface
    const double q = b + std::copysign(std::sqrt(discriminant), b);
    enters = outside / q;
    leaves = q;
    if (enters > leaves) std::swap(enters, leaves);
    return true;
  }
};

/// The distance at which the ray meets the sphere beyond 0, or infinity.
double firstMeeting(const Sphere& sphere, const Ray& ray) {
  double enters, leaves;
  if (!sphere.meet(ray, enters, leaves)) return std::numeric_limits<double>::infinity();
  if (enters > 0) return enters;
  return leaves > 0 ? leaves : std::numeric_limits<double>::infinity();
}

void sphereBounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& sphere = *static_cast<const Sphere*>(arguments->geometryUserPtr);
  const auto lower = [&](std::size_t k) {
    return std::nextafter(static_cast<float>(sphere.center[k] - sphere.radius), -INFINITY);
  };
  const auto upper = [&](std::size_t k) {
    return std::nextafter(static_cast<float>(sphere.center[k] + sphere.radius), INFINITY);
  };
  *arguments->bounds_o = {lower(0), lower(1), lower(2), 0, upper(0), upper(1), upper(2), 0};
}

void sphereIntersect(const RTCIntersectFunctionNArguments* arguments) {
  if (!arguments->valid[0]) return;
  auto* hit = reinterpret_cast<RTCRayHit*>(arguments->rayhit);  // rays come one at a time
  const Ray& ray = *reinterpret_cast<const Query*>(arguments->context)->ray;
  const auto distance = static_cast<float>(firstMeeting(*static_cast<const Sphere*>(arguments->geometryUserPtr), ray));
  if (!(distance < hit->ray.tfar)) return;
  hit->ray.tfar = distance;
  hit->hit.geomID = arguments->geomID;
  hit->hit.primID = arguments->primID;
}

void sphereOccluded(const RTCOccludedFunctionNArguments* arguments) {
  if (!arguments->valid[0]) return;
  auto* shadow = reinterpret_cast<RTCRay*>(arguments->ray);
  const Ray& ray = *reinterpret_cast<const Query*>(arguments->context)->ray;
  if (firstMeeting(*static_cast<const Sphere*>(arguments->geometryUserPtr), ray) < double(shadow->tfar))
    shadow->tfar = -INFINITY;
}

RTCRay floatRay(const Ray& ray, double distance) {
  RTCRay r{};
  r.org_x = static_cast<float>(ray.origin[0]);
  r.org_y = static_cast<float>(ray.origin[1]);
  r.org_z = static_cast<float>(ray.origin[2]);
  r.dir_x = static_cast<float>(ray.direction[0]);
  r.dir_y = static_cast<float>(ray.direction[1]);
  r.dir_z = static_cast<float>(ray.direction[2]);
  r.tnear = 0;
  r.tfar = static_cast<float>(std::min(distance, double(std::numeric_limits<float>::max())));
  r.mask = ~0u;
  return r;
}

/// Unit and across n: `tangent` without its part along n, or any direction where nothing is left.
Direction acrossNormal(const Direction& tangent, const Direction& n) {
  const double part = dot(tangent, n);
  Direction t;
  for (std::size_t k = 0; k < 3; ++k) t[k] = tangent[k] - part * n[k];
  if (dot(t, t) > 1e-12 * dot(tangent, tangent)) return normalized(t);
  Direction other;
  orthonormalBasis(n, t, other);
  return t;
}

template <class Value>
Value between(const std::vector<Value>& values, const std::array<std::uint32_t, 3>& corners, double u, double v) {
  Value result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = (1 - u - v) * values[corners[0]][k] + u * values[corners[1]][k] + v * values[corners[2]][k];
  return result;
}

}  // namespace

struct RayCaster::Geometry {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<SceneObject> objects;
  std::vector<Sphere> spheres;  ///< one an object; unused for meshes

  ~Geometry() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  void check(const char* what) const {
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
      throw Error(Error::Kind::Device, {what, "Embree", "error " + std::to_string(error), ""});
  }

  void add(const SceneObject& object, Sphere& sphere) {
    RTCGeometry geometry;
    if (object.mesh) {
      const TriangleMesh& mesh = *object.mesh;
      geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
      auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), mesh.points.size()));
      auto* corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
          geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
      check("no room for a mesh");
      for (const Position& p : mesh.points)
        for (const double x : object.placement.placed(p)) *points++ = static_cast<float>(x);
      for (const auto& triangle : mesh.triangles) corners = std::copy(triangle.begin(), triangle.end(), corners);
    } else {
      sphere = {object.placement.shift, object.placement.scale};
      geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
      rtcSetGeometryUserPrimitiveCount(geometry, 1);
      rtcSetGeometryUserData(geometry, &sphere);
      rtcSetGeometryBoundsFunction(geometry, sphereBounds, nullptr);
      rtcSetGeometryIntersectFunction(geometry, sphereIntersect);
      rtcSetGeometryOccludedFunction(geometry, sphereOccluded);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);  // in order: the number is the object's index
    rtcReleaseGeometry(geometry);
  }

  void onSphere(std::size_t index, SurfacePoint& point) const {
    const Sphere& sphere = spheres[index];
    Direction n;
    for (std::size_t k = 0; k < 3; ++k) n[k] = point.position[k] - sphere.center[k];
    n = normalized(n);
    for (std::size_t k = 0; k < 3; ++k) point.position[k] = sphere.center[k] + sphere.radius * n[k];
    point.geometricNormal = point.normal = n;
    point.tangent = acrossNormal(cross(objects[index].placement.axes[1], n), n);
    point.margin = 1e-12 * (sphere.radius + std::sqrt(dot(sphere.center, sphere.center)));
  }

  void onTriangle(std::size_t index, const RTCHit& hit, SurfacePoint& point) const {
    const SceneObject& object = objects[index];
    const TriangleMesh& mesh = *object.mesh;
    const auto& corners = mesh.triangles[hit.primID];
    const double u = double(hit.u), v = double(hit.v);
    point.position = object.placement.placed(between(mesh.points, corners, u, v));
    std::array<Direction, 2> edges;
    for (std::size_t e = 0; e < 2; ++e)
      for (std::size_t k = 0; k < 3; ++k) edges[e][k] = mesh.points[corners[e + 1]][k] - mesh.points[corners[0]][k];
    const Direction flat = object.placement.turned(normalized(cross(edges[0], edges[1])));
    point.geometricNormal = point.normal = flat;
    if (!mesh.normals.empty())
      if (const Direction n = object.placement.turned(normalized(between(mesh.normals, corners, u, v))); dot(n, n) > 0)
        point.normal = n;
    const Direction tangent =
        mesh.tangents.empty() ? Direction{} : object.placement.turned(between(mesh.tangents, corners, u, v));
    point.tangent = acrossNormal(tangent, point.normal);
    // Embree works in float: errors of a few units in the last place of the coordinates and of the triangle's size.
    const double size = object.placement.scale * std::sqrt(std::max(dot(edges[0], edges[0]), dot(edges[1], edges[1])));
    point.margin = 1e-6 * (size + std::sqrt(dot(point.position, point.position)));
  }
};

RayCaster::RayCaster(const Scene& scene) : geometry_(std::make_unique<Geometry>()) {
  Geometry& g = *geometry_;
  g.device = rtcNewDevice(nullptr);
  if (!g.device)
    throw Error(Error::Kind::Device,
                {"no device", "Embree", "error " + std::to_string(rtcGetDeviceError(nullptr)), ""});
  g.scene = rtcNewScene(g.device);
  rtcSetSceneFlags(g.scene, RTC_SCENE_FLAG_ROBUST);
  g.objects = scene.objects;
  g.spheres.resize(g.objects.size());
  for (std::size_t k = 0; k < g.objects.size(); ++k) g.add(g.objects[k], g.spheres[k]);
  rtcCommitScene(g.scene);
  g.check("the geometry cannot be made ready");
}

RayCaster::~RayCaster() = default;

std::size_t RayCaster::material(std::size_t object) const { return geometry_->objects[object].material; }

bool RayCaster::meet(const Ray& ray, SurfacePoint& point) const {
  const Geometry& g = *geometry_;
  RTCRayHit found{};
  found.ray = floatRay(ray, std::numeric_limits<double>::infinity());
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  Query query{};
  query.ray = &ray;
#if RTC_VERSION_MAJOR >= 4
  rtcInitRayQueryContext(&query.context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query.context;
  rtcIntersect1(g.scene, &found, &arguments);
#else
  rtcInitIntersectContext(&query.context);
  rtcIntersect1(g.scene, &query.context, &found);
#endif
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  point.object = found.hit.geomID;
  if (g.objects[point.object].mesh) {
    point.distance = double(found.ray.tfar);
    g.onTriangle(point.object, found.hit, point);
  } else {
    point.distance = firstMeeting(g.spheres[point.object], ray);
    point.position = along(ray, point.distance);
    g.onSphere(point.object, point);
  }
  return true;
}

bool RayCaster::blocked(const Ray& ray, double distance) const {
  RTCRay shadow = floatRay(ray, distance);
  Query query{};
  query.ray = &ray;
#if RTC_VERSION_MAJOR >= 4
  rtcInitRayQueryContext(&query.context);
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &query.context;
  rtcOccluded1(geometry_->scene, &shadow, &arguments);
#else
  rtcInitIntersectContext(&query.context);
  rtcOccluded1(geometry_->scene, &query.context, &shadow);
#endif
  return shadow.tfar < 0;
}

Position RayCaster::leaving(const SurfacePoint& point, const Direction& direction) const {
  const double step = std::copysign(point.margin, dot(direction, point.geometricNormal));
  Position p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = point.position[k] + step * point.geometricNormal[k];
  return p;
}

}  // namespace brdf
