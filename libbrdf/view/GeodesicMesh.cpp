#include <brdf/view/GeodesicMesh.h>

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace brdf {
namespace {

/// Adds the triangle, cut in two where the middle of its first edge is given.
void pushBisected(std::vector<GeodesicMesh::Triangle>& triangles, const std::uint32_t* middle,
                  const GeodesicMesh::Triangle& t) {
  if (middle) {
    triangles.push_back({t[0], *middle, t[2]});
    triangles.push_back({*middle, t[1], t[2]});
  } else {
    triangles.push_back(t);
  }
}

}  // namespace

GeodesicMesh::GeodesicMesh(double phi) : triangles_{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}} {
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double azimuth = phi + quarter * kPi / 2;
    directions_.push_back({std::cos(azimuth), std::sin(azimuth), 0.0});
  }
  directions_.push_back({0, 0, 1});
}

std::vector<MeshEdge> GeodesicMesh::edges() const {
  std::vector<MeshEdge> edges;
  edges.reserve(triangles_.size() * 3);
  for (const Triangle& t : triangles_)
    for (int k = 0; k < 3; ++k) edges.push_back(meshEdge(t[k], t[(k + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

double GeodesicMesh::length(MeshEdge edge) const {
  const Direction& a = directions_[firstEnd(edge)];
  const Direction& b = directions_[secondEnd(edge)];
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Direction GeodesicMesh::along(MeshEdge edge, double t) const {
  const Direction& a = directions_[firstEnd(edge)];
  const Direction& b = directions_[secondEnd(edge)];
  return normalized({(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]});
}

void GeodesicMesh::subdivide() {
  const std::vector<MeshEdge> all = edges();
  split({all.begin(), all.end()}, std::numeric_limits<std::size_t>::max());
}

std::uint32_t GeodesicMesh::moveNearest(const Direction& target, std::uint32_t kept) {
  std::uint32_t nearest = kNone;
  double largest = -2;
  for (std::uint32_t i = 0; i < directions_.size(); ++i) {
    const double cosine = dot(directions_[i], target);
    if (i == kept || directions_[i][2] == 0 || cosine <= largest) continue;
    largest = cosine;
    nearest = i;
  }
  if (nearest != kNone) directions_[nearest] = target;
  return nearest;
}

GeodesicMesh::Triangle GeodesicMesh::longestFirst(const Triangle& t) const {
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (length(meshEdge(t[k], t[(k + 1) % 3])) > length(meshEdge(t[longest], t[(longest + 1) % 3]))) longest = k;
  return {t[longest], t[(longest + 1) % 3], t[(longest + 2) % 3]};
}

bool GeodesicMesh::split(std::unordered_set<MeshEdge> marked, std::size_t maximumTriangles) {
  for (Triangle& t : triangles_) t = longestFirst(t);
  for (bool changed = true; changed;) {
    changed = false;
    for (const Triangle& t : triangles_)
      if (marked.count(meshEdge(t[1], t[2])) + marked.count(meshEdge(t[2], t[0])) > 0)
        changed = marked.insert(meshEdge(t[0], t[1])).second || changed;
  }
  std::size_t total = triangles_.size();
  for (const Triangle& t : triangles_)
    for (int k = 0; k < 3; ++k) total += marked.count(meshEdge(t[k], t[(k + 1) % 3]));
  if (total > maximumTriangles) return false;

  std::unordered_map<MeshEdge, std::uint32_t> middle;
  std::vector<MeshEdge> ordered(marked.begin(), marked.end());
  std::sort(ordered.begin(), ordered.end());  // the order of vertices must not depend on the hash
  for (MeshEdge edge : ordered) {
    middle[edge] = static_cast<std::uint32_t>(directions_.size());
    directions_.push_back(along(edge, 0.5));
  }
  std::vector<Triangle> next;
  next.reserve(total);
  for (const auto& [a, b, c] : triangles_) {
    const auto ab = middle.find(meshEdge(a, b)), bc = middle.find(meshEdge(b, c)), ca = middle.find(meshEdge(c, a));
    const auto none = middle.end();
    if (ab == none) {
      next.push_back({a, b, c});
    } else if (bc != none && ca != none) {
      next.push_back({a, ab->second, ca->second});
      next.push_back({ab->second, b, bc->second});
      next.push_back({ca->second, bc->second, c});
      next.push_back({ab->second, bc->second, ca->second});
    } else {
      pushBisected(next, ca == none ? nullptr : &ca->second, {c, a, ab->second});
      pushBisected(next, bc == none ? nullptr : &bc->second, {b, c, ab->second});
    }
  }
  triangles_ = std::move(next);
  return true;
}

}  // namespace brdf
