#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/simulate/SurfaceRandom.h>
#include <brdf/simulate/surfaces/BuiltInSurfaces.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

using Sphere = SpherePacking::Sphere;

/// The spheres so far, by the cells of a grid over the tile that are at least as wide as the largest sphere: what may
/// touch a new one is in its cell or the eight around it.
class Neighbours {
 public:
  Neighbours(double period, double largestRadius)
      : period_(period),
        cells_(std::clamp<std::size_t>(static_cast<std::size_t>(period / (2 * largestRadius)), 1, 1024)),
        lists_(cells_ * cells_) {}

  bool isFree(const Sphere& sphere) const {
    const std::size_t reach = std::min<std::size_t>(cells_ - 1, 2);  // all cells where there are fewer than three
    for (std::size_t dj = 0; dj <= reach; ++dj)
      for (std::size_t di = 0; di <= reach; ++di) {
        const std::size_t i = (cell(sphere.centre[0]) + cells_ + di - 1) % cells_;
        const std::size_t j = (cell(sphere.centre[1]) + cells_ + dj - 1) % cells_;
        for (const Sphere& other : lists_[j * cells_ + i])
          if (touch(sphere, other)) return false;
      }
    return true;
  }
  void add(const Sphere& sphere) { lists_[cell(sphere.centre[1]) * cells_ + cell(sphere.centre[0])].push_back(sphere); }

 private:
  std::size_t cell(double x) const {
    return std::min(static_cast<std::size_t>(x / period_ * static_cast<double>(cells_)), cells_ - 1);
  }
  /// Whether two spheres share a point, of any of their copies.
  bool touch(const Sphere& a, const Sphere& b) const {
    const double dx = std::remainder(double{a.centre[0]} - double{b.centre[0]}, period_);
    const double dy = std::remainder(double{a.centre[1]} - double{b.centre[1]}, period_);
    const double dz = double{a.centre[2]} - double{b.centre[2]}, reach = double{a.radius} + double{b.radius};
    return dx * dx + dy * dy + dz * dz <= reach * reach;
  }

  double period_;
  std::size_t cells_;
  std::vector<std::vector<Sphere>> lists_;
};

std::vector<double> radiiOf(const SurfaceArguments& arguments, SurfaceRandom& random) {
  const double radius = arguments.number("radius"), spread = arguments.number("spread");
  const std::string& distribution = arguments.text("distribution");
  if (distribution == "uniform" && spread >= 1) arguments.refuse("spread", "out of bounds", "below 1 of uniform radii");
  std::vector<double> radii(arguments.whole("count"), radius);
  for (double& r : radii) {
    if (distribution == "lognormal") r *= std::exp(spread * random.normal());
    if (distribution == "uniform") r *= 1 + spread * (2 * random.uniform() - 1);
  }
  // The large ones first, as long as there is room.
  std::ranges::sort(radii, std::greater{});
  return radii;
}

MadeSurface make(const SurfaceArguments& arguments, const SurfaceReaders&) {
  const double period = arguments.number("period"), bottom = arguments.number("bottom");
  const double height = arguments.number("height");
  const bool overlap = arguments.text("overlap") == "yes";
  const std::size_t tries = arguments.whole("tries");
  SurfaceRandom random(arguments.whole("seed"));
  const std::vector<double> radii = radiiOf(arguments, random);
  if (!radii.empty() && 2 * radii.front() > period)
    throw Error(Error::Kind::Value,
                {"a sphere is wider than the tile", arguments.where(), formatNumber(2 * radii.front()) + " um",
                 "at most the period, " + formatNumber(period) + " um"});
  if (!radii.empty() && height > 0 && 2 * radii.front() > height)
    throw Error(Error::Kind::Value,
                {"a sphere is higher than the layer", arguments.where(), formatNumber(2 * radii.front()) + " um",
                 "at most the height, " + formatNumber(height) + " um, or height 0"});
  SpherePacking packing{{}, period, period, arguments.text("substrate") == "yes"};
  Neighbours neighbours(period, radii.empty() ? period : radii.front());
  double volume = 0, area = 0, top = bottom;
  for (const double radius : radii)
    for (std::size_t attempt = 0; attempt < (overlap ? 1 : tries); ++attempt) {
      const double x = period * random.uniform(), y = period * random.uniform();
      const double z = bottom + radius + (height > 0 ? (height - 2 * radius) * random.uniform() : 0);
      const Sphere sphere{{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)},
                          static_cast<float>(radius)};
      if (!overlap && !neighbours.isFree(sphere)) continue;
      packing.spheres.push_back(sphere);
      if (!overlap) neighbours.add(sphere);
      volume += 4 * kPi / 3 * radius * radius * radius;
      area += kPi * radius * radius;
      top = std::max(top, z + radius);
      break;
    }
  const auto placed = packing.spheres.size();
  const double layer = top - bottom;
  MadeSurface made;
  made.facts = {
      {"spheres placed", static_cast<double>(placed), "1"},
      {"spheres that found no place", static_cast<double>(radii.size() - placed), "1"},
      {"share of the plane covered, overlaps counted twice", area / (period * period), "1"},
      {"share of the layer filled, overlaps counted twice", layer > 0 ? volume / (period * period * layer) : 0, "1"}};
  made.surface.facets.resize(2);
  made.surface.shape = std::move(packing);
  return made;
}

}  // namespace

SurfaceKind sphereSurface() {
  return {
      "spheres",
      "packing of spheres",
      "Spheres at random places of a square tile, on, above or in the plane z = 0. Without overlap each is thrown "
      "until it touches no other, large ones first; those that find no place in the number of tries are left out "
      "and counted. The facet of the spheres is the first, that of the plane the second.",
      {numberParameter("count", "count", 100, 0, 1e6, "spheres in a tile"),
       lengthParameter("radius", "radius", 0.5, "of every sphere; median of lognormal radii, mean of uniform ones"),
       numberParameter("spread", "spread", 0.2, 0, 2,
                       "standard deviation of the logarithm of lognormal radii; half the range of uniform ones over "
                       "their mean"),
       lengthParameter("period", "period", 20, "side of the square tile"),
       lengthParameter("bottom", "bottom", 0, "z of the layer's lower side: negative is in the substrate", -1e6),
       lengthParameter("height", "height", 0, "of the layer, uniformly filled; 0: all spheres rest on its lower side",
                       0),
       numberParameter("tries", "tries", 100, 1, 1e5, "places tried for a sphere that must not touch others"),
       seedParameter()},
      {{"distribution", "distribution", "of the radii", {"constant", "lognormal", "uniform"}},
       {"overlap", "overlap", "whether spheres may overlap", {"no", "yes"}},
       {"substrate", "substrate", "whether the plane z = 0 is there", {"yes", "no"}}},
      {},
      make};
}

}  // namespace brdf
