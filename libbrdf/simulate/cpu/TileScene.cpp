#include <brdf/base/Error.h>
#include <brdf/simulate/cpu/TileScene.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostBlocks = 1'000'000;

std::variant<FieldTiles, MeshTiles, SphereTiles> tilesOf(const Microsurface& surface) {
  if (const auto* field = std::get_if<HeightField>(&surface.shape)) return FieldTiles(*field);
  if (const auto* mesh = std::get_if<TiledMesh>(&surface.shape)) return MeshTiles(*mesh);
  return SphereTiles(std::get<SpherePacking>(surface.shape));
}

/// Distance along one coordinate to the end of [0, size] that the ray approaches.
double toBorder(double origin, double direction, double size) {
  if (direction > 0) return std::max((size - origin) / direction, 0.0);
  if (direction < 0) return std::max(-origin / direction, 0.0);
  return kNever;
}

}  // namespace

TileScene::TileScene(const Microsurface& surface)
    : shape_(tilesOf(surface)), block_(std::visit([](const auto& s) { return s.block; }, shape_)) {
  for (const Facet& facet : surface.facets) {
    const bool dielectric = facet.kind == Facet::Kind::Dielectric;
    mediumOf_.push_back(dielectric ? static_cast<int>(facetOf_.size()) : Media::kNone);
    if (dielectric) facetOf_.push_back(mediumOf_.size() - 1);
  }
  const auto* packing = std::get_if<SpherePacking>(&surface.shape);
  plane_ = packing && packing->substrate;
  open_ = std::holds_alternative<TiledMesh>(surface.shape) || (packing && !plane_);
  below_ = open_ ? Media::kNone : mediumOf_[plane_ ? 1 : 0];
  // Below an opaque plane is nothing that light could reach.
  const double lowest = plane_ && below_ == Media::kNone ? 0 : block_.lowest;
  const double gap = 1e-3 * (block_.highest - lowest) + 1e-4 * std::min(block_.width, block_.depth);
  highest_ = block_.highest + gap;
  lowest_ = lowest - gap;

  device_ = rtcNewDevice(nullptr);
  if (!device_)
    throw Error(Error::Kind::Device,
                {"no device", "Embree", "error " + std::to_string(rtcGetDeviceError(nullptr)), ""});
  scene_ = rtcNewScene(device_);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry geometry = std::visit([&](const auto& s) { return s.geometry(device_); }, shape_);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_);
  if (const RTCError error = rtcGetDeviceError(device_); error != RTC_ERROR_NONE) {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
    throw Error(Error::Kind::Device,
                {"the geometry cannot be made ready", "Embree", "error " + std::to_string(error), ""});
  }
}

TileScene::~TileScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

bool TileScene::query(const DoubleRay& ray, double least, double most, RTCRayHit& hit) const {
  hit.ray.org_x = static_cast<float>(ray.origin[0] - block_.middle[0]);
  hit.ray.org_y = static_cast<float>(ray.origin[1] - block_.middle[1]);
  hit.ray.org_z = static_cast<float>(ray.origin[2] - block_.middle[2]);
  hit.ray.dir_x = static_cast<float>(ray.direction[0]);
  hit.ray.dir_y = static_cast<float>(ray.direction[1]);
  hit.ray.dir_z = static_cast<float>(ray.direction[2]);
  hit.ray.tnear = static_cast<float>(least);
  hit.ray.tfar = static_cast<float>(most);
  hit.ray.time = 0;
  hit.ray.mask = ~0u;
  hit.ray.id = 0;
  hit.ray.flags = 0;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  TileQuery query;
  query.ray = &ray;
#if RTC_VERSION_MAJOR >= 4
  rtcInitRayQueryContext(&query.context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query.context;
  rtcIntersect1(scene_, &hit, &arguments);
#else
  rtcInitIntersectContext(&query.context);
  rtcIntersect1(scene_, &query.context, &hit);
#endif
  return hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

bool TileScene::meetFacet(const DoubleRay& ray, double most, const Media& media, Meeting& meeting, double& distance,
                          std::uint64_t& queries) const {
  double least = 0;
  RTCRayHit hit;
  // Each time, one facet is passed over that the ray comes from; a vertex may have many.
  for (int attempt = 0; attempt < 64; ++attempt) {
    ++queries;
    if (!query(ray, least, most, hit)) return false;
    distance = double(hit.ray.tfar);
    std::visit([&](const auto& s) { s.resolve(hit, ray, meeting); }, shape_);
    const double cosine = dot(ray.direction, meeting.normal);
    const bool front = cosine < 0;
    const bool expected = front != media.within(medium(meeting.facet));
    // How far rounding would have to move the ray for it to start on the other side.
    if (expected || distance * std::abs(cosine) > 2 * meeting.offset) return true;
    least = std::nextafter(hit.ray.tfar, INFINITY) * 1.0000002;
    if (!(least < most)) return false;
  }
  return true;
}

void TileScene::wrap(DoubleRay& ray) const {
  ray.origin[0] -= block_.width * std::floor(ray.origin[0] / block_.width);
  ray.origin[1] -= block_.depth * std::floor(ray.origin[1] / block_.depth);
}

TileScene::End TileScene::follow(DoubleRay& ray, const Media& media, Meeting& meeting, double& distance,
                                 std::uint64_t& queries) const {
  distance = 0;
  const Direction& d = ray.direction;
  const double beyond = 4 * block_.rounding;  // hits this near behind the border count: they are in the margin
  for (std::size_t blocks = 0; blocks < kMostBlocks; ++blocks) {
    const double border =
        std::min(toBorder(ray.origin[0], d[0], block_.width), toBorder(ray.origin[1], d[1], block_.depth));
    const double slab = d[2] > 0   ? (highest_ - ray.origin[2]) / d[2]
                        : d[2] < 0 ? (lowest_ - ray.origin[2]) / d[2]
                                   : kNever;
    const double z = ray.origin[2];
    const double plane = plane_ && ((z > 0 && d[2] < 0) || (z < 0 && d[2] > 0)) ? -z / d[2] : kNever;
    const double most = std::min({border + beyond, slab, plane});
    double met;
    if (meetFacet(ray, most, media, meeting, met, queries)) {
      distance += met;
      ray.origin = meeting.position;
      wrap(ray);
      meeting.position = ray.origin;
      return End::Facet;
    }
    const bool atPlane = plane <= std::min(border, slab), leaves = !atPlane && slab <= border;
    const double step = atPlane ? plane : leaves ? slab : border;
    distance += step;
    for (std::size_t k = 0; k < 3; ++k) ray.origin[k] += step * d[k];
    if (atPlane) {
      ray.origin[2] = 0;
      wrap(ray);
      meeting = {ray.origin, {0, 0, 1}, 1, 0};
      return End::Facet;
    }
    if (leaves) return d[2] > 0 ? End::Above : End::Below;
    // On to the next block: the border that was reached becomes the opposite one, exactly.
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double size = axis == 0 ? block_.width : block_.depth;
      if (d[axis] > 0 && ray.origin[axis] >= size * (1 - 1e-15))
        ray.origin[axis] = std::max(ray.origin[axis] - size, 0.0);
      if (d[axis] < 0 && ray.origin[axis] <= size * 1e-15) ray.origin[axis] = std::min(ray.origin[axis] + size, size);
    }
  }
  return End::Nowhere;
}

void TileScene::leave(DoubleRay& ray, const Meeting& meeting) {
  const double step = std::copysign(meeting.offset, dot(ray.direction, meeting.normal));
  for (std::size_t k = 0; k < 3; ++k) ray.origin[k] = meeting.position[k] + step * meeting.normal[k];
}

}  // namespace brdf
