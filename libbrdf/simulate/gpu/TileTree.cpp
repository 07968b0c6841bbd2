#include <brdf/base/Error.h>
#include <brdf/simulate/gpu/BoxTree.h>
#include <brdf/simulate/gpu/TileTree.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr std::size_t kMost = std::size_t{1} << 24;  ///< primitives: numbers of them are exact as floats

[[noreturn]] void tooMany(const std::string& where, double found) {
  throw Error(Error::Kind::Value,
              {"too many triangles or spheres for the gpu backend", where,
               std::to_string(static_cast<long long>(found)) + " with the repetitions at the border",
               "at most 2^24; the cpu backend takes more"});
}

struct Extent {
  std::array<double, 3> least{1e300, 1e300, 1e300}, most{-1e300, -1e300, -1e300};
  void add(const std::array<float, 3>& point, double radius = 0) {
    for (std::size_t a = 0; a < 3; ++a) {
      least[a] = std::min(least[a], double(point[a]) - radius);
      most[a] = std::max(most[a], double(point[a]) + radius);
    }
  }
};

/// Unit, middle and ends of a tile, from the z of what is in it.
struct Frame {
  double periodX, periodY, middleZ, margin;
  Frame(TileTree& tree, double alongX, double alongY, double low, double high, double lowestMet)
      : periodX(alongX), periodY(alongY), middleZ((low + high) / 2), margin(1e-3 * std::min(periodX, periodY)) {
    tree.unit = std::max(periodX, periodY);
    tree.half = {periodX / (2 * tree.unit), periodY / (2 * tree.unit)};
    const double gap = (1e-3 * (high - lowestMet) + 1e-4 * std::min(periodX, periodY)) / tree.unit;
    tree.lowest = (lowestMet - middleZ) / tree.unit - gap;
    tree.highest = (high - middleZ) / tree.unit + gap;
    tree.plane = -middleZ / tree.unit;
    // Two units in the last place of the largest coordinate.
    tree.rounding = 2.4e-7 * (0.5 + (high - low) / tree.unit);
  }

  /// Calls body(shiftX, shiftY) for every repetition of `extent` that reaches into the tile or its margin.
  template <class Body>
  void repeat(const Extent& extent, const std::string& where, const Body& body) const {
    const auto first = [&](std::size_t a, double period) { return std::ceil((-margin - extent.most[a]) / period); };
    const auto last = [&](std::size_t a, double period) {
      return std::floor((period + margin - extent.least[a]) / period);
    };
    const double x0 = first(0, periodX), x1 = last(0, periodX), y0 = first(1, periodY), y1 = last(1, periodY);
    if ((x1 - x0 + 1) * (y1 - y0 + 1) > double(kMost)) tooMany(where, (x1 - x0 + 1) * (y1 - y0 + 1));
    for (double j = y0; j <= y1; ++j)
      for (double i = x0; i <= x1; ++i) body(i * periodX, j * periodY);
  }

  std::array<float, 3> place(const TileTree& tree, const std::array<float, 3>& point, double shiftX,
                             double shiftY) const {
    return {static_cast<float>((double(point[0]) + shiftX - periodX / 2) / tree.unit),
            static_cast<float>((double(point[1]) + shiftY - periodY / 2) / tree.unit),
            static_cast<float>((double(point[2]) - middleZ) / tree.unit)};
  }
};

/// Sorts the primitives, of `texels` texels each, into the order of the leaves.
void finish(TileTree& tree, const std::vector<FloatBox>& boxes, std::size_t texels) {
  std::vector<std::uint32_t> order;
  tree.nodes = makeBoxTree(boxes, order);
  std::vector<TileTree::Texel> sorted;
  sorted.reserve(tree.primitives.size());
  for (const std::uint32_t k : order)
    for (std::size_t t = 0; t < texels; ++t) sorted.push_back(tree.primitives[texels * k + t]);
  tree.primitives = std::move(sorted);
  if (tree.primitives.empty()) tree.primitives.resize(texels);
}

bool isDegenerate(const std::array<std::array<float, 3>, 3>& corners) {
  std::array<float, 3> a, b;
  for (std::size_t k = 0; k < 3; ++k) {
    a[k] = corners[1][k] - corners[0][k];
    b[k] = corners[2][k] - corners[0][k];
  }
  const float x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
  return !(x * x + y * y + z * z > 0);
}

}  // namespace

TileTree::TileTree(const TiledMesh& mesh, const std::vector<int>& mediumOf, const std::string& where) {
  Extent all;
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) all.add(mesh.points[corner]);
  if (mesh.triangles.empty()) all.add({0, 0, 0});
  const Frame frame(*this, mesh.periodX, mesh.periodY, all.least[2], all.most[2], all.least[2]);
  std::vector<FloatBox> boxes;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Extent extent;
    for (const std::uint32_t corner : mesh.triangles[t]) extent.add(mesh.points[corner]);
    frame.repeat(extent, where, [&](double shiftX, double shiftY) {
      std::array<std::array<float, 3>, 3> corners;
      FloatBox box;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = frame.place(*this, mesh.points[mesh.triangles[t][k]], shiftX, shiftY);
        box.add({corners[k], corners[k]});
      }
      if (isDegenerate(corners)) return;
      if (boxes.size() == kMost) tooMany(where, double(kMost) + 1);
      boxes.push_back(box);
      const std::size_t facet = mesh.facets.empty() ? 0 : mesh.facets[t];
      const std::array<float, 3> beside{static_cast<float>(facet), static_cast<float>(mediumOf[facet]), 0.0F};
      for (std::size_t k = 0; k < 3; ++k)
        primitives.push_back({corners[k][0], corners[k][1], corners[k][2], beside[k]});
    });
  }
  finish(*this, boxes, 3);
}

TileTree::TileTree(const SpherePacking& packing, const std::vector<int>& mediumOf, const std::string& where) {
  Extent all;
  for (const auto& sphere : packing.spheres) all.add(sphere.centre, double(sphere.radius));
  if (packing.substrate || packing.spheres.empty()) all.add({0, 0, 0});
  // Below an opaque plane is nothing that light could reach.
  const bool opaque = packing.substrate && mediumOf[1] < 0;
  const double least = opaque ? 0 : all.least[2];
  const Frame frame(*this, packing.periodX, packing.periodY, least, all.most[2], least);
  std::vector<FloatBox> boxes;
  for (const auto& sphere : packing.spheres) {
    Extent extent;
    extent.add(sphere.centre, double(sphere.radius));
    if (opaque && extent.most[2] <= 0) continue;
    frame.repeat(extent, where, [&](double shiftX, double shiftY) {
      if (boxes.size() == kMost) tooMany(where, double(kMost) + 1);
      const std::array<float, 3> centre = frame.place(*this, sphere.centre, shiftX, shiftY);
      const auto radius = static_cast<float>(double(sphere.radius) / unit);
      FloatBox box;
      for (std::size_t a = 0; a < 3; ++a) {
        box.least[a] = std::nextafter(centre[a] - radius, -1e30F);
        box.most[a] = std::nextafter(centre[a] + radius, 1e30F);
      }
      boxes.push_back(box);
      primitives.push_back({centre[0], centre[1], centre[2], radius});
    });
  }
  finish(*this, boxes, 1);
}

}  // namespace brdf
