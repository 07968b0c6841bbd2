#include <brdf/render/MeshFrames.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

Direction between(const Position& from, const Position& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

double length(const Direction& d) { return std::sqrt(dot(d, d)); }

/// `tangent` without its part along n, unit; zero where nothing is left.
Direction across(const Direction& tangent, const Direction& n) {
  const double part = dot(tangent, n);
  Direction t;
  for (std::size_t k = 0; k < 3; ++k) t[k] = tangent[k] - part * n[k];
  return dot(t, t) > 1e-12 * dot(tangent, tangent) ? normalized(t) : Direction{};
}

Direction aroundVertical(const Direction& n) {
  const Direction t = across({n[2], 0, -n[0]}, n);
  return dot(t, t) > 0 ? t : across({1, 0, 0}, n);
}

/// Angle between two edges; 0 where one has no length.
double angle(const Direction& a, const Direction& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

/// Sums at every point of the triangles' directions of growing u.
std::vector<Direction> alongU(const TriangleMesh& mesh) {
  std::vector<Direction> sums(mesh.points.size());
  for (const auto& triangle : mesh.triangles) {
    const auto& [a, b, c] = triangle;
    const Direction ab = between(mesh.points[a], mesh.points[b]), ac = between(mesh.points[a], mesh.points[c]);
    const auto &ta = mesh.textureCoordinates[a], &tb = mesh.textureCoordinates[b], &tc = mesh.textureCoordinates[c];
    const double u1 = tb[0] - ta[0], v1 = tb[1] - ta[1], u2 = tc[0] - ta[0], v2 = tc[1] - ta[1];
    const double area = u1 * v2 - u2 * v1;
    if (!(std::abs(area) > 1e-12 * (std::abs(u1 * v2) + std::abs(u2 * v1)))) continue;
    Direction t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = std::copysign(1.0, area) * (v2 * ab[k] - v1 * ac[k]);
    if (!(dot(t, t) > 0) || !std::isfinite(dot(t, t))) continue;
    t = normalized(t);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t here = triangle[corner];
      const Position& p = mesh.points[here];
      const double weight = angle(between(p, mesh.points[triangle[(corner + 1) % 3]]),
                                  between(p, mesh.points[triangle[(corner + 2) % 3]]));
      for (std::size_t k = 0; k < 3; ++k) sums[here][k] += weight * t[k];
    }
  }
  return sums;
}

}  // namespace

std::size_t removeDegenerateTriangles(TriangleMesh& mesh) {
  const auto flat = [&](const std::array<std::uint32_t, 3>& triangle) {
    const Direction ab = between(mesh.points[triangle[0]], mesh.points[triangle[1]]),
                    ac = between(mesh.points[triangle[0]], mesh.points[triangle[2]]),
                    bc = between(mesh.points[triangle[1]], mesh.points[triangle[2]]);
    const double longest = std::max({length(ab), length(ac), length(bc)});
    return !(length(cross(ab, ac)) > 1e-12 * longest * longest);
  };
  return std::erase_if(mesh.triangles, flat);
}

void settleNormals(TriangleMesh& mesh) {
  if (mesh.normals.size() != mesh.points.size()) return;
  const auto flat = [&](const std::array<std::uint32_t, 3>& t) {
    return cross(between(mesh.points[t[0]], mesh.points[t[1]]), between(mesh.points[t[0]], mesh.points[t[2]]));
  };
  const auto zero = [](const Direction& n) { return !(dot(n, n) > 0); };
  if (std::ranges::any_of(mesh.normals, zero)) {
    std::vector<Direction> sums(mesh.points.size());
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle)
        for (std::size_t k = 0; k < 3; ++k) sums[corner][k] += flat(triangle)[k];
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (zero(mesh.normals[i])) mesh.normals[i] = zero(sums[i]) ? Direction{0, 1, 0} : sums[i];
  }
  for (Direction& n : mesh.normals) n = normalized(n);
  for (auto& triangle : mesh.triangles) {
    Direction sum{};
    for (const std::uint32_t corner : triangle)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += mesh.normals[corner][k];
    if (dot(flat(triangle), sum) < 0) std::swap(triangle[1], triangle[2]);
  }
}

void addTangents(TriangleMesh& mesh) {
  if (!mesh.tangents.empty() || mesh.normals.size() != mesh.points.size()) return;
  std::vector<Direction> wanted(mesh.points.size());
  if (mesh.textureCoordinates.size() == mesh.points.size()) wanted = alongU(mesh);
  mesh.tangents.resize(mesh.points.size());
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    const Direction n = normalized(mesh.normals[k]);
    const Direction t = across(wanted[k], n);
    mesh.tangents[k] = dot(t, t) > 0 ? t : aroundVertical(n);
  }
}

}  // namespace brdf
