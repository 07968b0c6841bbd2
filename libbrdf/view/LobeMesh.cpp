#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/view/LobeMesh.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace brdf {
namespace {

constexpr double kRimHeight = 1e-4;

Direction plus(const Direction& a, const Direction& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Direction minus(const Direction& a, const Direction& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Direction times(double s, const Direction& a) { return {s * a[0], s * a[1], s * a[2]}; }
double length(const Direction& a) { return std::sqrt(dot(a, a)); }

using Triangle = std::array<std::uint32_t, 3>;

std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}
std::uint32_t edgeFirst(std::uint64_t key) { return static_cast<std::uint32_t>(key >> 32); }
std::uint32_t edgeSecond(std::uint64_t key) { return static_cast<std::uint32_t>(key); }

/// Builds one mesh: uniform subdivision, then passes that split the edges that a criterion marks.
class Builder {
 public:
  Builder(const Brdf& brdf, const LobeMeshOptions& options)
      : brdf_(brdf), options_(options), channels_(brdf.channels().count()), weights_(options.weights) {
    if (weights_.empty()) weights_.assign(channels_, 1.0 / static_cast<double>(channels_));
    wi_ = fromSpherical(options.thetaI, options.phiI);
    mirror_ = {-wi_[0], -wi_[1], wi_[2]};
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double phi = options.phiI + quarter * kPi / 2;  // an edge of the mesh lies in the plane of incidence
      directions_.push_back({std::cos(phi), std::sin(phi), 0.0});
    }
    directions_.push_back({0, 0, 1});
    triangles_ = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  }

  LobeMesh build() {
    for (unsigned level = 0; level < options_.subdivisions; ++level) {
      marked_.clear();
      for (std::uint64_t edge : edges()) marked_.insert(edge);
      split();
    }
    evaluateFrom(0);
    if (options_.tolerance > 0)
      while (markEdges()) split();
    return finish();
  }

 private:
  struct Values {
    std::vector<double> planar;
    std::vector<std::uint8_t> valid;
  };

  Values valuesAt(const std::vector<Direction>& directions) const {
    DirectionPairBuffer<double> pairs(directions.size());
    for (std::size_t i = 0; i < directions.size(); ++i) {
      Direction wo = directions[i];
      if (wo[2] < kRimHeight) wo = normalized({wo[0], wo[1], kRimHeight});
      pairs.set(i, wi_, wo);
    }
    Values values{std::vector<double>(directions.size() * channels_), std::vector<std::uint8_t>(directions.size())};
    brdf_.evaluateParallel(pairs.view(), values.planar.data(), values.valid.data());
    return values;
  }

  double radius(const Values& values, std::size_t i) const {
    double shown = 0;
    const std::size_t count = values.valid.size();
    for (std::size_t c = 0; c < channels_; ++c) shown += weights_[c] * values.planar[c * count + i];
    return values.valid[i] ? transformed(options_.transform, shown) : 0;
  }

  void evaluateFrom(std::size_t first) {
    const std::vector<Direction> added(directions_.begin() + static_cast<std::ptrdiff_t>(first), directions_.end());
    const Values values = valuesAt(added);
    for (std::size_t i = 0; i < added.size(); ++i) {
      radii_.push_back(radius(values, i));
      maximumRadius_ = std::max(maximumRadius_, radii_.back());
    }
  }

  std::vector<std::uint64_t> edges() const {
    std::vector<std::uint64_t> keys;
    keys.reserve(triangles_.size() * 3);
    for (const Triangle& t : triangles_)
      for (int k = 0; k < 3; ++k) keys.push_back(edgeKey(t[k], t[(k + 1) % 3]));
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
  }

  Direction midpoint(std::uint64_t edge) const {
    return normalized(plus(directions_[edgeFirst(edge)], directions_[edgeSecond(edge)]));
  }

  /// Around the mirror and retro directions edges are a quarter of their distance to them.
  bool nearPeak(const Direction& middle, double size) const {
    const double distance = std::min(length(minus(middle, mirror_)), length(minus(middle, wi_)));
    return size > 0.25 * distance;
  }

  /// Marks the edges to split in this pass; false when there are none, or no room.
  bool markEdges() {
    if (directions_.size() >= options_.maximumVertices) return false;
    marked_.clear();
    std::vector<std::uint64_t> candidates;
    std::vector<Direction> middles;
    for (std::uint64_t edge : edges()) {
      if (smooth_.count(edge)) continue;
      const double size = edgeLength(edge);
      if (size < 2 * options_.smallestPeak) continue;
      const Direction middle = midpoint(edge);
      if (nearPeak(middle, size)) {
        marked_.insert(edge);
      } else if (size >= 2 * options_.smallestBend) {
        candidates.push_back(edge);
        middles.push_back(middle);
      }
    }
    const Values values = valuesAt(middles);
    const double allowed = options_.tolerance * maximumRadius_;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const std::uint32_t a = edgeFirst(candidates[i]), b = edgeSecond(candidates[i]);
      const Direction chord = times(0.5, plus(times(radii_[a], directions_[a]), times(radii_[b], directions_[b])));
      if (length(minus(times(radius(values, i), middles[i]), chord)) > allowed)
        marked_.insert(candidates[i]);
      else
        smooth_.insert(candidates[i]);
    }
    return !marked_.empty();
  }

  double edgeLength(std::uint64_t edge) const {
    return length(minus(directions_[edgeFirst(edge)], directions_[edgeSecond(edge)]));
  }

  /// The triangle turned so that its longest edge comes first.
  Triangle longestFirst(const Triangle& t) const {
    int longest = 0;
    for (int k = 1; k < 3; ++k)
      if (edgeLength(edgeKey(t[k], t[(k + 1) % 3])) > edgeLength(edgeKey(t[longest], t[(longest + 1) % 3])))
        longest = k;
    return {t[longest], t[(longest + 1) % 3], t[(longest + 2) % 3]};
  }

  /// Splits the marked edges for all their triangles, which keeps the mesh conforming. A triangle with a marked edge is
  /// bisected at its longest edge first (Rivara 1984, "Algorithms for refining triangular grids suitable for adaptive
  /// and multigrid techniques"), which keeps its angles from degenerating; with three it becomes four similar ones.
  void split() {
    for (Triangle& t : triangles_) t = longestFirst(t);
    for (bool changed = true; changed;) {
      changed = false;
      for (const Triangle& t : triangles_)
        if (marked_.count(edgeKey(t[1], t[2])) + marked_.count(edgeKey(t[2], t[0])) > 0)
          changed = marked_.insert(edgeKey(t[0], t[1])).second || changed;
    }
    const std::size_t first = directions_.size();
    std::unordered_map<std::uint64_t, std::uint32_t> middle;
    std::vector<std::uint64_t> ordered(marked_.begin(), marked_.end());
    std::sort(ordered.begin(), ordered.end());  // the order of vertices must not depend on the hash
    for (std::uint64_t edge : ordered) {
      middle[edge] = static_cast<std::uint32_t>(directions_.size());
      directions_.push_back(midpoint(edge));
    }
    std::vector<Triangle> next;
    next.reserve(triangles_.size() * 2);
    for (const auto& [a, b, c] : triangles_) {
      const auto ab = middle.find(edgeKey(a, b)), bc = middle.find(edgeKey(b, c)), ca = middle.find(edgeKey(c, a));
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
    if (!radii_.empty()) evaluateFrom(first);
  }

  /// The triangle, cut in two where the middle of its first edge is given.
  static void pushBisected(std::vector<Triangle>& triangles, const std::uint32_t* middle, const Triangle& t) {
    if (middle) {
      triangles.push_back({t[0], *middle, t[2]});
      triangles.push_back({*middle, t[1], t[2]});
    } else {
      triangles.push_back(t);
    }
  }

  LobeMesh finish() {
    LobeMesh mesh;
    Values values = valuesAt(directions_);
    mesh.directions = std::move(directions_);
    mesh.values = std::move(values.planar);
    mesh.valid = std::move(values.valid);
    mesh.radii = std::move(radii_);
    mesh.maximumRadius = maximumRadius_;
    mesh.normals.assign(mesh.vertexCount(), Direction{});
    for (const Triangle& t : triangles_) {
      if (!mesh.valid[t[0]] || !mesh.valid[t[1]] || !mesh.valid[t[2]]) continue;
      mesh.triangles.push_back(t);
      const Direction a = mesh.position(t[0]);
      const Direction normal = cross(minus(mesh.position(t[1]), a), minus(mesh.position(t[2]), a));
      for (std::uint32_t corner : t) mesh.normals[corner] = plus(mesh.normals[corner], normal);
    }
    for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
      mesh.normals[i] = normalized(mesh.normals[i]);
      if (mesh.normals[i] == Direction{}) mesh.normals[i] = mesh.directions[i];
    }
    return mesh;
  }

  const Brdf& brdf_;
  const LobeMeshOptions& options_;
  std::size_t channels_;
  std::vector<double> weights_;
  Direction wi_, mirror_;
  std::vector<Direction> directions_;
  std::vector<double> radii_;
  std::vector<Triangle> triangles_;
  std::unordered_set<std::uint64_t> marked_;
  std::unordered_set<std::uint64_t> smooth_;  // edges whose midpoint was seen to lie on the chord
  double maximumRadius_ = 0;
};

void require(bool condition, const char* field, double found, const char* allowed) {
  if (!condition) throw Error(Error::Kind::Value, {"out of range", field, formatNumber(found), allowed});
}

}  // namespace

double transformed(LobeTransform transform, double value) {
  const double positive = std::max(value, 0.0);
  switch (transform) {
    case LobeTransform::CubeRoot:
      return std::cbrt(positive);
    case LobeTransform::Log:
      return std::log1p(positive);
    default:
      return positive;
  }
}

LobeTransform parseLobeTransform(std::string_view name) {
  if (name == "none") return LobeTransform::None;
  if (name == "cuberoot") return LobeTransform::CubeRoot;
  if (name == "log") return LobeTransform::Log;
  throw Error(Error::Kind::Value, {"unknown transform", "transform", std::string(name), "none, cuberoot, log"});
}

std::string lobeTransformLabel(LobeTransform transform) {
  switch (transform) {
    case LobeTransform::CubeRoot:
      return "cube root of f_r (sr^-1/3)";
    case LobeTransform::Log:
      return "ln(1 + f_r), f_r in 1/sr";
    default:
      return "f_r (1/sr)";
  }
}

LobeMesh makeLobeMesh(const Brdf& brdf, const LobeMeshOptions& options) {
  require(options.thetaI >= 0 && options.thetaI < kPi / 2, "theta_i", degrees(options.thetaI), "[0, 90) degrees");
  require(std::isfinite(options.phiI), "phi_i", degrees(options.phiI), "a finite number of degrees");
  require(options.subdivisions <= 9, "subdivisions", options.subdivisions, "0 to 9");
  require(options.tolerance >= 0, "tolerance", options.tolerance, "0 or more");
  require(options.smallestBend > 0, "smallest bend", degrees(options.smallestBend), "more than 0 degrees");
  require(options.smallestPeak > 0, "smallest peak", degrees(options.smallestPeak), "more than 0 degrees");
  require(options.weights.empty() || options.weights.size() == brdf.channels().count(), "number of channel weights",
          static_cast<double>(options.weights.size()), "none, or one a channel");
  return Builder(brdf, options).build();
}

}  // namespace brdf
