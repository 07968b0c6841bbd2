#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/simulate/SurfaceRandom.h>
#include <brdf/simulate/surfaces/BuiltInSurfaces.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

/// A straight scratch with round ends: a V-shaped cut, and on either side a ridge of displaced material.
struct Scratch {
  double x, y;          ///< middle, micrometres
  double cosine, sine;  ///< of its azimuth
  double halfLength;    ///< between the centres of its round ends, micrometres
  double halfWidth, depth;
  double ridgeWidth, ridgeHeight;
};

struct Extremes {
  std::vector<float> cuts, ridges;  ///< deepest cut (0: none) and highest ridge at every node
};

/// Cuts `scratch` into the repeated tile.
void engrave(const HeightField& field, const Scratch& scratch, Extremes& nodes) {
  const double reach = scratch.halfWidth + scratch.ridgeWidth;
  const double extentX = scratch.halfLength * std::abs(scratch.cosine) + reach;
  const double extentY = scratch.halfLength * std::abs(scratch.sine) + reach;
  const auto columns = static_cast<long>(field.columns), rows = static_cast<long>(field.rows);
  const long firstX = std::lround(std::ceil((scratch.x - extentX) / field.spacingX));
  const long lastX = std::lround(std::floor((scratch.x + extentX) / field.spacingX));
  const long firstY = std::lround(std::ceil((scratch.y - extentY) / field.spacingY));
  const long lastY = std::lround(std::floor((scratch.y + extentY) / field.spacingY));
  for (long j = firstY; j <= lastY; ++j) {
    const double dy = static_cast<double>(j) * field.spacingY - scratch.y;
    // The part of the row within reach of the scratch's line, and of its ends.
    long from = firstX, to = lastX;
    if (std::abs(scratch.sine) > 1e-9) {
      const double middle = dy * scratch.cosine / scratch.sine, half = reach / std::abs(scratch.sine);
      from = std::max(from, std::lround(std::floor((scratch.x + middle - half) / field.spacingX)));
      to = std::min(to, std::lround(std::ceil((scratch.x + middle + half) / field.spacingX)));
    }
    const auto row = static_cast<std::size_t>((j % rows + rows) % rows) * field.columns;
    for (long i = from; i <= to; ++i) {
      const double dx = static_cast<double>(i) * field.spacingX - scratch.x;
      const double along = std::max(std::abs(dx * scratch.cosine + dy * scratch.sine) - scratch.halfLength, 0.0);
      const double distance = std::hypot(along, dy * scratch.cosine - dx * scratch.sine);
      if (distance >= reach) continue;
      const std::size_t node = row + static_cast<std::size_t>((i % columns + columns) % columns);
      if (distance < scratch.halfWidth) {
        const double cut = scratch.depth * (1 - distance / scratch.halfWidth);
        nodes.cuts[node] = std::max(nodes.cuts[node], static_cast<float>(cut));
      } else {
        const double place = std::abs(2 * (distance - scratch.halfWidth) / scratch.ridgeWidth - 1);
        nodes.ridges[node] = std::max(nodes.ridges[node], static_cast<float>(scratch.ridgeHeight * (1 - place)));
      }
    }
  }
}

MadeSurface make(const SurfaceArguments& arguments, const SurfaceReaders&) {
  const double period = arguments.number("period"), width = arguments.number("width");
  const double length = arguments.number("length"), spread = arguments.number("width_spread");
  const double steepness = std::tan(radians(arguments.number("slope")));
  const double ridge = arguments.number("ridge"), coverage = arguments.number("coverage");
  HeightField field;
  const double spacing = arguments.number("spacing") > 0 ? arguments.number("spacing") : width / 8;
  const double nodes = std::ceil(period / spacing * (1 - 1e-12));
  if (!(nodes <= 4096))
    throw Error(Error::Kind::Value, {"too many nodes", arguments.where(), formatNumber(nodes) + " along each axis",
                                     "4096: a shorter period or a wider spacing"});
  field.columns = field.rows = std::max<std::size_t>(static_cast<std::size_t>(nodes), 2);
  field.spacingX = field.spacingY = period / static_cast<double>(field.columns);

  // Mean area of a scratch in the plane, between the edges of its cut: rectangle and round ends. Of lognormal widths of
  // median w, E w^k = w^k exp(k^2 spread^2 / 2).
  const double meanWidth = width * std::exp(spread * spread / 2);
  const double area = length * meanWidth + kPi / 4 * width * width * std::exp(2 * spread * spread);
  const double wanted = coverage * period * period / area;
  if (!(wanted <= 1e6))
    throw Error(Error::Kind::Value, {"too many scratches", arguments.where(), formatNumber(wanted, 6),
                                     "1000000: a lower coverage, a shorter period or longer scratches"});
  // Nodes that are looked at, some 10^8 a second.
  const double visits = wanted * ((length + width) / field.spacingX + 1) * (2 * meanWidth / field.spacingX + 1);
  if (!(visits <= 2e9))
    throw Error(Error::Kind::Value, {"too much to cut", arguments.where(), formatNumber(visits, 3) + " nodes",
                                     "2e9: a lower coverage, a shorter period or a wider spacing"});
  const auto count = static_cast<std::size_t>(std::llround(wanted));

  SurfaceRandom random(arguments.whole("seed"));
  Extremes extremes{std::vector<float>(field.columns * field.rows), std::vector<float>(field.columns * field.rows)};
  for (std::size_t k = 0; k < count; ++k) {
    Scratch scratch{};
    scratch.x = period * random.uniform();
    scratch.y = period * random.uniform();
    const double azimuth = radians(arguments.number("orientation") + arguments.number("spread") * random.normal());
    scratch.cosine = std::cos(azimuth);
    scratch.sine = std::sin(azimuth);
    scratch.halfLength = length / 2;
    scratch.halfWidth = std::min(width * std::exp(spread * random.normal()), period) / 2;
    scratch.depth = scratch.halfWidth * steepness;
    scratch.ridgeWidth = ridge > 0 ? scratch.halfWidth : 0;
    scratch.ridgeHeight = ridge * scratch.depth;
    engrave(field, scratch, extremes);
  }
  std::size_t cut = 0;
  field.heights.resize(field.columns * field.rows);
  for (std::size_t k = 0; k < field.heights.size(); ++k) {
    cut += extremes.cuts[k] > 0 ? 1 : 0;
    field.heights[k] = extremes.cuts[k] > 0 ? -extremes.cuts[k] : extremes.ridges[k];
  }
  MadeSurface made;
  made.facts = {
      {"scratches", static_cast<double>(count), "1"},
      {"share of the surface that is cut", static_cast<double>(cut) / static_cast<double>(field.heights.size()), "1"}};
  made.surface.shape = std::move(field);
  return made;
}

struct Defaults {
  double coverage, width, length, spread, period, ridge;
};

std::vector<Parameter> parameters(const Defaults& defaults) {
  return {
      numberParameter("coverage", "coverage", defaults.coverage, 0, 100,
                      "area of all cuts together over that of the tile; they overlap, so that 1 - exp(-coverage) is "
                      "cut"),
      lengthParameter("width", "width", defaults.width, "median width of the cuts", 1e-3),
      numberParameter("width_spread", "spread of the widths", 0.3, 0, 2,
                      "standard deviation of the logarithm of the widths (lognormal); depths go with them"),
      angleParameter("slope", "slope of the walls", 20, 0, 85, "of a cut's two walls from the plane"),
      numberParameter("ridge", "ridge", defaults.ridge, 0, 2,
                      "height of the ridges beside a cut over its depth; each is half as wide as the cut"),
      lengthParameter("length", "length", defaults.length, "of the scratches, without their round ends", 0),
      angleParameter("orientation", "orientation", 0, -360, 360, "azimuth along the scratches, from +x"),
      angleParameter("spread", "spread", defaults.spread, 0, 360,
                     "standard deviation of the azimuths (normal); 360 is any direction"),
      lengthParameter("period", "period", defaults.period, "side of the square tile"),
      lengthParameter("spacing", "spacing", 0, "between nodes, at most; 0: an eighth of the width", 0),
      seedParameter()};
}

const std::vector<Reference> kScratchReferences{{"C. Bosch, X. Pueyo, S. Merillou and D. Ghazanfarpour", 2004,
                                                 "A Physically-Based Model for Rendering Realistic Scratches",
                                                 "Computer Graphics Forum 23, 361-370",
                                                 "10.1111/j.1467-8659.2004.00767.x", ""}};

}  // namespace

SurfaceKind scratchedSurface() {
  return {
      "scratched",
      "scratched metal",
      "A flat land, z = 0, with straight scratches of random places, directions and widths: V-shaped cuts with round "
      "ends and, on either side, triangular ridges of displaced material. Where scratches cross, the deepest cut "
      "wins, and cuts win over ridges.",
      parameters({0.15, 2, 60, 360, 200, 0.3}),
      {},
      kScratchReferences,
      make};
}

SurfaceKind brushedSurface() {
  return {"brushed",
          "brushed metal",
          "Scratches as those of scratched(), so dense that hardly any land is left, long and all but parallel.",
          parameters({4, 1, 300, 3, 120, 0}),
          {},
          kScratchReferences,
          make};
}

}  // namespace brdf
