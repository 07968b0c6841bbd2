#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/view/GeodesicMesh.h>
#include <brdf/view/LobeMesh.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

constexpr double kRimHeight = 1e-4;
constexpr std::size_t kBlock = 65'536;    // directions evaluated together
constexpr std::size_t kFewestSplit = 64;  // with room for fewer edges the mesh counts as full
// The edge of a hole is followed to this length: it has no chord.
constexpr double kSmallestAtHole = radians(0.25);

Direction plus(const Direction& a, const Direction& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Direction minus(const Direction& a, const Direction& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Direction times(double s, const Direction& a) { return {s * a[0], s * a[1], s * a[2]}; }
double length(const Direction& a) { return std::sqrt(dot(a, a)); }

double distanceToSegment(const Direction& p, const Direction& a, const Direction& b) {
  const Direction along = minus(b, a);
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(minus(p, a), along) / square, 0.0, 1.0) : 0.0;
  return length(minus(p, plus(a, times(t, along))));
}

/// Refines the mesh of one lobe.
class Builder {
 public:
  Builder(const Brdf& brdf, const LobeMeshOptions& options, const Brdf* other)
      : brdf_(brdf),
        other_(options.shape == LobeShape::Value ? nullptr : other),
        options_(options),
        channels_(brdf.channels().count()),
        weights_(options.weights),
        wi_(fromSpherical(options.thetaI, options.phiI)),
        mirror_{-wi_[0], -wi_[1], wi_[2]},
        mesh_(options.phiI) {
    if (weights_.empty()) weights_.assign(channels_, 1.0 / static_cast<double>(channels_));
  }

  LobeMesh build() {
    for (unsigned level = 0; level < options_.subdivisions; ++level) mesh_.subdivide();
    if (options_.tolerance > 0) placePeaks();
    evaluateNew();
    if (options_.tolerance > 0) {
      while (refineAroundPeaks()) evaluateNew();
      while (refineChords()) evaluateNew();
    } else {
      for (double error : judge(mesh_.edges()))
        if (std::isfinite(error)) chordError_ = std::max(chordError_, error);
    }
    return finish();
  }

 private:
  struct Lengths {
    std::vector<double> length;
    std::vector<std::uint8_t> valid;
  };

  /// The mirror and the retro direction become vertices.
  void placePeaks() {
    const std::uint32_t taken = mesh_.moveNearest(mirror_, GeodesicMesh::kNone);
    const double edge = kPi / 2 / static_cast<double>(1u << options_.subdivisions);
    if (options_.subdivisions > 0 && options_.thetaI > edge / 4) mesh_.moveNearest(wi_, taken);
  }

  /// Lengths at directions, with the values (planar) only where `values` is given.
  Lengths lengthsAt(const std::vector<Direction>& directions, std::vector<double>* values = nullptr) const {
    Lengths result{std::vector<double>(directions.size()), std::vector<std::uint8_t>(directions.size())};
    if (values) values->assign(channels_ * directions.size(), 0);
    for (std::size_t first = 0; first < directions.size(); first += kBlock) {
      const auto begin = directions.begin() + static_cast<std::ptrdiff_t>(first);
      const std::size_t count = std::min(kBlock, directions.size() - first);
      const std::vector<Direction> block(begin, begin + static_cast<std::ptrdiff_t>(count));
      std::vector<std::uint8_t> valid, otherValid(count, 1);
      const std::vector<double> f = valuesOverHemisphere(brdf_, wi_, block, valid);
      std::vector<double> g;
      if (other_) g = valuesOverHemisphere(*other_, wi_, block, otherValid);
      for (std::size_t i = 0; i < count; ++i) {
        if (!valid[i] || !otherValid[i]) continue;
        result.valid[first + i] = 1;
        result.length[first + i] = shown(f, count, i) - (other_ ? shown(g, count, i) : 0);
        for (std::size_t c = 0; c < channels_ && values; ++c)
          (*values)[c * directions.size() + first + i] = f[c * count + i] - (other_ ? g[c * count + i] : 0);
      }
    }
    return result;
  }

  double shown(const std::vector<double>& values, std::size_t count, std::size_t i) const {
    double sum = 0;
    for (std::size_t c = 0; c < channels_; ++c) sum += weights_[c] * values[c * count + i];
    return transformed(options_.scale, sum);
  }

  void evaluateNew() {
    const auto& all = mesh_.directions();
    const Lengths added = lengthsAt({all.begin() + static_cast<std::ptrdiff_t>(lengths_.size()), all.end()});
    lengths_.insert(lengths_.end(), added.length.begin(), added.length.end());
    valid_.insert(valid_.end(), added.valid.begin(), added.valid.end());
    for (double one : added.length) maximumLength_ = std::max(maximumLength_, std::abs(one));
  }

  /// Of the final surface; while it is refined the largest length seen so far stands for the radius of a displaced one.
  double radius(double length) const {
    return options_.shape == LobeShape::Displaced ? std::max(maximumLength_ + length, 0.0) : std::abs(length);
  }
  double maximumRadius() const {
    double largest = 0;
    for (std::size_t i = 0; i < lengths_.size(); ++i)
      if (valid_[i]) largest = std::max(largest, radius(lengths_[i]));
    return largest;
  }

  bool refineAroundPeaks() {
    std::unordered_set<MeshEdge> marked;
    for (MeshEdge edge : mesh_.edges()) {
      const double size = mesh_.length(edge);
      if (size < 2 * options_.smallestPeak) continue;
      if (size > 0.25 * distanceToPeaks(edge)) marked.insert(edge);
    }
    if (marked.empty()) return false;
    if (mesh_.split(marked, options_.maximumTriangles)) return true;
    complete_ = false;
    return false;
  }

  /// The distance of the surface from each edge, at its quarters, by share of the largest radius. Edges of holes have
  /// the largest there is, or none when they are short.
  std::vector<double> judge(const std::vector<MeshEdge>& edges) {
    std::vector<Direction> quarters;
    quarters.reserve(3 * edges.size());
    for (MeshEdge edge : edges)
      for (double t : {0.25, 0.5, 0.75}) quarters.push_back(mesh_.along(edge, t));
    const Lengths between = lengthsAt(quarters);
    for (double one : between.length) maximumLength_ = std::max(maximumLength_, std::abs(one));
    const double largest = maximumRadius();
    std::vector<double> errors(edges.size());
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const std::uint32_t a = firstEnd(edges[k]), b = secondEnd(edges[k]);
      const int known =
          valid_[a] + valid_[b] + between.valid[3 * k] + between.valid[3 * k + 1] + between.valid[3 * k + 2];
      if (known == 5) {
        const Direction from = times(radius(lengths_[a]), mesh_.directions()[a]);
        const Direction to = times(radius(lengths_[b]), mesh_.directions()[b]);
        for (std::size_t q = 3 * k; q < 3 * k + 3; ++q)
          errors[k] =
              std::max(errors[k], distanceToSegment(times(radius(between.length[q]), quarters[q]), from, to) / largest);
        if (!std::isfinite(errors[k])) errors[k] = 0;  // a lobe of no length at all
      } else if (known > 0 && mesh_.length(edges[k]) >= 2 * kSmallestAtHole) {
        errors[k] = std::numeric_limits<double>::infinity();
      }
    }
    return errors;
  }

  double smallestBend(MeshEdge edge) const {
    const double near = std::max(distanceToPeaks(edge) / 16, options_.smallestPeak);
    return std::min(near, options_.smallestBend);
  }

  double distanceToPeaks(MeshEdge edge) const {
    const Direction middle = mesh_.along(edge, 0.5);
    return std::min(length(minus(middle, mirror_)), length(minus(middle, wi_)));
  }

  bool refineChords() {
    std::vector<MeshEdge> candidates;
    for (MeshEdge edge : mesh_.edges())
      if (!smooth_.count(edge)) candidates.push_back(edge);
    const std::vector<double> errors = judge(candidates);
    std::vector<std::pair<double, MeshEdge>> bent;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      if (errors[k] > options_.tolerance && mesh_.length(candidates[k]) >= 2 * smallestBend(candidates[k])) {
        bent.emplace_back(errors[k], candidates[k]);
        continue;
      }
      smooth_.insert(candidates[k]);
      if (std::isfinite(errors[k])) chordError_ = std::max(chordError_, errors[k]);
    }
    if (bent.empty()) return false;
    std::sort(bent.begin(), bent.end(), [](const auto& a, const auto& b) {
      return a.first > b.first || (a.first == b.first && a.second < b.second);
    });
    for (std::size_t taken = bent.size(); taken >= std::min(kFewestSplit, bent.size()); taken /= 2) {
      std::unordered_set<MeshEdge> marked;
      for (std::size_t k = 0; k < taken; ++k) marked.insert(bent[k].second);
      if (mesh_.split(std::move(marked), options_.maximumTriangles)) return true;
    }
    complete_ = false;
    for (const auto& [error, edge] : bent)
      if (std::isfinite(error)) chordError_ = std::max(chordError_, error);
    return false;
  }

  LobeMesh finish() {
    LobeMesh mesh;
    Lengths all = lengthsAt(mesh_.directions(), &mesh.values);
    mesh.directions = mesh_.directions();
    mesh.valid = std::move(all.valid);
    mesh.lengths = std::move(all.length);
    mesh.maximumLength = 0;
    for (double one : mesh.lengths) mesh.maximumLength = std::max(mesh.maximumLength, std::abs(one));
    maximumLength_ = mesh.maximumLength;
    if (options_.shape == LobeShape::Displaced) mesh.referenceRadius = mesh.maximumLength;
    mesh.chordError = chordError_;
    mesh.complete = complete_;
    for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
      mesh.radii.push_back(mesh.valid[i] ? radius(mesh.lengths[i]) : 0);
      mesh.maximumRadius = std::max(mesh.maximumRadius, mesh.radii.back());
    }
    mesh.normals.assign(mesh.vertexCount(), Direction{});
    for (const GeodesicMesh::Triangle& t : mesh_.triangles()) {
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
  const Brdf* other_;
  const LobeMeshOptions& options_;
  std::size_t channels_;
  std::vector<double> weights_;
  Direction wi_, mirror_;
  GeodesicMesh mesh_;
  std::vector<double> lengths_;
  std::vector<std::uint8_t> valid_;
  std::unordered_set<MeshEdge> smooth_;  // edges that were seen to lie on the surface
  double maximumLength_ = 0, chordError_ = 0;
  bool complete_ = true;
};

void require(bool condition, const char* field, double found, const char* allowed) {
  if (!condition) throw Error(Error::Kind::Value, {"out of range", field, formatNumber(found), allowed});
}

}  // namespace

std::vector<double> valuesOverHemisphere(const Brdf& brdf, const Direction& wi, const std::vector<Direction>& wo,
                                         std::vector<std::uint8_t>& valid) {
  const std::size_t count = wo.size(), channels = brdf.channels().count();
  DirectionPairBuffer<double> pairs(count);
  for (std::size_t i = 0; i < count; ++i)
    pairs.set(i, wi, wo[i][2] < kRimHeight ? normalized({wo[i][0], wo[i][1], kRimHeight}) : wo[i]);
  std::vector<double> values(count * channels);
  valid.assign(count, 0);
  brdf.evaluateParallel(pairs.view(), values.data(), valid.data());
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < channels; ++c) valid[i] = valid[i] && std::isfinite(values[c * count + i]);
    for (std::size_t c = 0; c < channels && !valid[i]; ++c) values[c * count + i] = 0;
  }
  return values;
}

LobeMesh makeLobeMesh(const Brdf& brdf, const LobeMeshOptions& options, const Brdf* other) {
  require(options.thetaI >= 0 && options.thetaI < kPi / 2, "theta_i", degrees(options.thetaI), "[0, 90) degrees");
  require(std::isfinite(options.phiI), "phi_i", degrees(options.phiI), "a finite number of degrees");
  require(options.subdivisions <= 9, "subdivisions", options.subdivisions, "0 to 9");
  require(options.tolerance >= 0, "tolerance", options.tolerance, "0 or more");
  require(options.smallestBend > 0, "smallest bend", degrees(options.smallestBend), "more than 0 degrees");
  require(options.smallestPeak >= radians(1e-5), "smallest peak", degrees(options.smallestPeak),
          "1e-5 degrees or more");
  require(options.scale.floor > 0 && std::isfinite(options.scale.floor), "floor", options.scale.floor,
          "more than 0/sr");
  require(options.weights.empty() || options.weights.size() == brdf.channels().count(), "number of channel weights",
          static_cast<double>(options.weights.size()), "none, or one a channel");
  if (options.shape != LobeShape::Value) {
    require(other != nullptr, "BRDFs of a difference", 1, "2");
    require(other->channels().count() == brdf.channels().count(), "channels of the BRDF subtracted",
            static_cast<double>(other->channels().count()), "as many as of the other");
  }
  return Builder(brdf, options, other).build();
}

}  // namespace brdf
