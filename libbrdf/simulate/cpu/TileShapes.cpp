#include <brdf/base/Error.h>
#include <brdf/simulate/cpu/TileShapes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace brdf {
namespace {

constexpr std::size_t kMostPrimitives = std::size_t{1} << 27;
constexpr std::size_t kRepeatBelow = std::size_t{1} << 13;  ///< primitives up to which a block is made of several tiles
constexpr double kReach = 8;  ///< heights that a block is long where it may be: rays at 83 degrees cross it once

double lowestHeight(const HeightField& field) { return double(*std::ranges::min_element(field.heights)); }
double highestHeight(const HeightField& field) { return double(*std::ranges::max_element(field.heights)); }

struct Box {
  std::array<double, 3> least{1e300, 1e300, 1e300}, most{-1e300, -1e300, -1e300};
  void add(const std::array<float, 3>& point, double radius = 0) {
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], double(point[k]) - radius);
      most[k] = std::max(most[k], double(point[k]) + radius);
    }
  }
  bool empty() const { return least[0] > most[0]; }
};

Box boxOf(const TiledMesh& mesh) {
  Box box;
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) box.add(mesh.points[corner]);
  if (box.empty()) box.add({0, 0, 0});
  return box;
}

Box boxOf(const SpherePacking& packing) {
  Box box;
  for (const auto& sphere : packing.spheres) box.add(sphere.centre, double(sphere.radius));
  if (packing.substrate || box.empty()) box.add({0, 0, 0});
  return box;
}

TileBlock blockOf(const TiledMesh& mesh) {
  const Box box = boxOf(mesh);
  return {mesh.periodX, mesh.periodY, box.least[2], box.most[2], mesh.triangles.size()};
}

TileBlock blockOf(const SpherePacking& packing) {
  const Box box = boxOf(packing);
  return {packing.periodX, packing.periodY, box.least[2], box.most[2], packing.spheres.size()};
}

/// Calls body(shiftX, shiftY) for every repetition of what spans [least, most] that reaches the block or its margin.
template <class Body>
void repeat(const TileBlock& block, const Box& box, double periodX, double periodY, const Body& body) {
  const auto range = [&](std::size_t axis, double size, double period, double& first, double& last) {
    first = std::ceil((-block.margin - box.most[axis]) / period);
    last = std::floor((size + block.margin - box.least[axis]) / period);
  };
  double x0, x1, y0, y1;
  range(0, block.width, periodX, x0, x1);
  range(1, block.depth, periodY, y0, y1);
  if ((x1 - x0 + 1) * (y1 - y0 + 1) > double(kMostPrimitives)) TileBlock::checkCount(kMostPrimitives + 1);
  for (double j = y0; j <= y1; ++j)
    for (double i = x0; i <= x1; ++i) body(i * periodX, j * periodY);
}

}  // namespace

TileBlock::TileBlock(double periodX, double periodY, double bottom, double top, std::size_t primitivesInTile)
    : lowest(bottom), highest(top) {
  const double reach = kReach * (highest - lowest);
  const auto most = static_cast<double>(kRepeatBelow / std::max<std::size_t>(primitivesInTile, 1));
  // Long enough both ways; where that is too much, as square as may be.
  double x = std::max(1.0, std::ceil(reach / periodX)), y = std::max(1.0, std::ceil(reach / periodY));
  if (x * y > most) {
    const double side = std::sqrt(std::max(most, 1.0) * periodX * periodY);
    x = std::clamp(std::floor(side / periodX), 1.0, std::max(x, 1.0));
    y = std::clamp(std::floor(side / periodY), 1.0, std::max(y, 1.0));
    if (x * y > most) (periodX < periodY ? x : y) = std::max(1.0, std::floor(most / (periodX < periodY ? y : x)));
  }
  tilesX = static_cast<std::size_t>(x);
  tilesY = static_cast<std::size_t>(y);
  width = x * periodX;
  depth = y * periodY;
  middle = {width / 2, depth / 2, (lowest + highest) / 2};

  rounding = 6e-8 * (std::max(width, depth) / 2 + (highest - lowest));
  margin = std::max(1e-3 * std::min(width, depth), 8 * rounding);
}

void TileBlock::checkCount(std::size_t primitives) {
  if (primitives > kMostPrimitives)
    throw Error(Error::Kind::Value,
                {"too many triangles or spheres for the memory", "cpu backend",
                 std::to_string(primitives) + " with the repetitions at the border", "at most 2^27"});
}

// ----- height fields
// ---------------------------------------------------------------------------------------------------

FieldTiles::FieldTiles(const HeightField& field)
    : block(field.periodX(), field.periodY(), lowestHeight(field), highestHeight(field),
            2 * field.columns * field.rows),
      spacingX(field.spacingX),
      spacingY(field.spacingY) {
  block.margin = std::min(spacingX, spacingY);
  const std::size_t across = field.columns * block.tilesX + 2, along = field.rows * block.tilesY + 2;
  TileBlock::checkCount(2 * across * along);
  columns = static_cast<std::uint32_t>(across);
  rows = static_cast<std::uint32_t>(along);
  heights.reserve((across + 1) * (along + 1));
  for (std::size_t j = 0; j <= along; ++j)
    for (std::size_t i = 0; i <= across; ++i)
      heights.push_back(field.height((i + field.columns - 1) % field.columns, (j + field.rows - 1) % field.rows));
}

RTCGeometry FieldTiles::geometry(RTCDevice device) const {
  const std::size_t nodes = heights.size(), cells = std::size_t{columns} * rows;
  RTCGeometry made = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(
      rtcSetNewGeometryBuffer(made, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), nodes));
  auto* corners = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(made, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), 2 * cells));
  if (!points || !corners) return made;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i) {
      *points++ = static_cast<float>((double(i) - 1) * spacingX - block.middle[0]);
      *points++ = static_cast<float>((double(j) - 1) * spacingY - block.middle[1]);
      *points++ = static_cast<float>(double(heights[std::size_t{j} * (columns + 1) + i]) - block.middle[2]);
    }
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, b = a + 1, d = a + columns + 1, c = d + 1;
      for (const std::uint32_t corner : {a, b, c, a, c, d}) *corners++ = corner;
    }
  return made;
}

void FieldTiles::resolve(const RTCRayHit& hit, const DoubleRay&, Meeting& meeting) const {
  // Exactly on the triangle of the field, whatever Embree's vertices were rounded to.
  const std::uint32_t cell = hit.hit.primID / 2, j = cell / columns, i = cell - j * columns;
  const bool upper = hit.hit.primID & 1;
  const double u = double(hit.hit.u), v = double(hit.hit.v);
  const float* const corner = heights.data() + std::size_t{j} * (columns + 1) + i;
  const double h00 = double(corner[0]), h11 = double(corner[columns + 2]);
  const double other = double(corner[upper ? columns + 1 : 1]);
  // Corners (0,0), (1,0), (1,1) or (0,0), (1,1), (0,1): u and v belong to the second and third.
  const double x = upper ? u : u + v, y = upper ? u + v : v;
  const double alongX = upper ? h11 - other : other - h00, alongY = upper ? other - h00 : h11 - other;
  meeting.position = {(double(i) - 1 + x) * spacingX, (double(j) - 1 + y) * spacingY, h00 + alongX * x + alongY * y};
  const double sx = alongX / spacingX, sy = alongY / spacingY, scale = 1 / std::sqrt(1 + sx * sx + sy * sy);
  meeting.normal = {-sx * scale, -sy * scale, scale};
  meeting.facet = 0;
  meeting.offset = 2 * block.rounding;
}

// ----- meshes
// ----------------------------------------------------------------------------------------------------------

MeshTiles::MeshTiles(const TiledMesh& mesh) : block(blockOf(mesh)) {
  const auto corner = [&](std::size_t triangle, std::size_t k) { return mesh.points[mesh.triangles[triangle][k]]; };
  const auto isDegenerate = [&](std::size_t triangle) {
    std::array<Direction, 2> edges;
    for (std::size_t e = 0; e < 2; ++e)
      for (std::size_t k = 0; k < 3; ++k)
        edges[e][k] = double(corner(triangle, e + 1)[k]) - double(corner(triangle, 0)[k]);
    const Direction n = cross(edges[0], edges[1]);
    return !(dot(n, n) > 0);
  };
  std::unordered_map<std::uint32_t, std::uint32_t> here;  // of this repetition: index of a point in `points`
  repeat(block, boxOf(mesh), mesh.periodX, mesh.periodY, [&](double shiftX, double shiftY) {
    here.clear();
    const std::array<double, 3> shift{shiftX - block.middle[0], shiftY - block.middle[1], -block.middle[2]};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      Box box;
      for (std::size_t k = 0; k < 3; ++k) box.add(corner(t, k));
      if (box.least[0] + shiftX > block.width + block.margin || box.most[0] + shiftX < -block.margin ||
          box.least[1] + shiftY > block.depth + block.margin || box.most[1] + shiftY < -block.margin || isDegenerate(t))
        continue;
      std::array<std::uint32_t, 3> placed;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [entry, isNew] = here.try_emplace(mesh.triangles[t][k], static_cast<std::uint32_t>(points.size()));
        placed[k] = entry->second;
        if (!isNew) continue;
        std::array<float, 3> point;
        for (std::size_t a = 0; a < 3; ++a) point[a] = static_cast<float>(double(corner(t, k)[a]) + shift[a]);
        points.push_back(point);
      }
      triangles.push_back(placed);
      facets.push_back(mesh.facets.empty() ? std::uint8_t{0} : mesh.facets[t]);
      TileBlock::checkCount(triangles.size());
    }
  });
}

RTCGeometry MeshTiles::geometry(RTCDevice device) const {
  RTCGeometry made = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* to = static_cast<std::array<float, 3>*>(
      rtcSetNewGeometryBuffer(made, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), points.size()));
  auto* corners = static_cast<std::array<std::uint32_t, 3>*>(rtcSetNewGeometryBuffer(
      made, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
  if (to) std::ranges::copy(points, to);
  if (corners) std::ranges::copy(triangles, corners);
  return made;
}

void MeshTiles::resolve(const RTCRayHit& hit, const DoubleRay&, Meeting& meeting) const {
  const auto& corners = triangles[hit.hit.primID];
  const double u = double(hit.hit.u), v = double(hit.hit.v);
  Direction first, second;
  for (std::size_t k = 0; k < 3; ++k) {
    const double start = double(points[corners[0]][k]);
    first[k] = double(points[corners[1]][k]) - start;
    second[k] = double(points[corners[2]][k]) - start;
    meeting.position[k] = start + u * first[k] + v * second[k] + block.middle[k];
  }
  meeting.normal = normalized(cross(first, second));
  meeting.facet = facets[hit.hit.primID];
  meeting.offset = 2 * block.rounding;
}

// ----- spheres
// ---------------------------------------------------------------------------------------------------------

namespace {

/// The distance at which the ray meets the sphere beyond 0, or infinity. E. Haines, J. Gunther and T. Akenine-Moller
/// 2019, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, ch. 7,
/// DOI 10.1007/978-1-4842-4427-2_7.
double firstMeeting(const SphereTiles::Sphere& sphere, const DoubleRay& ray) {
  Direction f, l;
  for (std::size_t k = 0; k < 3; ++k) f[k] = ray.origin[k] - sphere.centre[k];
  const double b = -dot(f, ray.direction);
  for (std::size_t k = 0; k < 3; ++k) l[k] = f[k] + b * ray.direction[k];
  const double discriminant = sphere.radius * sphere.radius - dot(l, l);
  constexpr double never = std::numeric_limits<double>::infinity();
  if (discriminant <= 0) return never;
  const double outside = dot(f, f) - sphere.radius * sphere.radius, q = b + std::copysign(std::sqrt(discriminant), b);
  const double near = std::min(outside / q, q), far = std::max(outside / q, q);
  return near > 0 ? near : far > 0 ? far : never;
}

void sphereBounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& tiles = *static_cast<const SphereTiles*>(arguments->geometryUserPtr);
  const SphereTiles::Sphere& sphere = tiles.spheres[arguments->primID];
  const auto bound = [&](std::size_t k, double sign) {
    return std::nextafter(static_cast<float>(sphere.centre[k] + sign * sphere.radius - tiles.block.middle[k]),
                          static_cast<float>(sign * INFINITY));
  };
  *arguments->bounds_o = {bound(0, -1), bound(1, -1), bound(2, -1), 0, bound(0, 1), bound(1, 1), bound(2, 1), 0};
}

void sphereIntersect(const RTCIntersectFunctionNArguments* arguments) {
  if (!arguments->valid[0]) return;
  auto* hit = reinterpret_cast<RTCRayHit*>(arguments->rayhit);  // rays come one at a time
  const DoubleRay& ray = *reinterpret_cast<const TileQuery*>(arguments->context)->ray;
  const auto& tiles = *static_cast<const SphereTiles*>(arguments->geometryUserPtr);
  const auto distance = static_cast<float>(firstMeeting(tiles.spheres[arguments->primID], ray));
  if (!(distance < hit->ray.tfar)) return;
  hit->ray.tfar = distance;
  hit->hit.geomID = arguments->geomID;
  hit->hit.primID = arguments->primID;
}

}  // namespace

SphereTiles::SphereTiles(const SpherePacking& packing) : block(blockOf(packing)) {
  for (const auto& sphere : packing.spheres) {
    Box box;
    box.add(sphere.centre, double(sphere.radius));
    repeat(block, box, packing.periodX, packing.periodY, [&](double shiftX, double shiftY) {
      spheres.push_back(
          {{double(sphere.centre[0]) + shiftX, double(sphere.centre[1]) + shiftY, double(sphere.centre[2])},
           double(sphere.radius)});
      TileBlock::checkCount(spheres.size());
    });
  }
}

RTCGeometry SphereTiles::geometry(RTCDevice device) const {
  RTCGeometry made = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(made, static_cast<unsigned>(spheres.size()));
  rtcSetGeometryUserData(made, const_cast<SphereTiles*>(this));
  rtcSetGeometryBoundsFunction(made, sphereBounds, nullptr);
  rtcSetGeometryIntersectFunction(made, sphereIntersect);
  return made;
}

void SphereTiles::resolve(const RTCRayHit& hit, const DoubleRay& ray, Meeting& meeting) const {
  const Sphere& sphere = spheres[hit.hit.primID];
  const double distance = firstMeeting(sphere, ray);
  for (std::size_t k = 0; k < 3; ++k)
    meeting.normal[k] = ray.origin[k] + distance * ray.direction[k] - sphere.centre[k];
  meeting.normal = normalized(meeting.normal);
  for (std::size_t k = 0; k < 3; ++k) meeting.position[k] = sphere.centre[k] + sphere.radius * meeting.normal[k];
  meeting.facet = 0;
  meeting.offset = 1e-13 * (sphere.radius + block.width + block.depth);
}

}  // namespace brdf
