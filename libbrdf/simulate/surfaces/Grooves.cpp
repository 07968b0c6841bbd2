#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/simulate/SurfaceRandom.h>
#include <brdf/simulate/surfaces/BuiltInSurfaces.h>
#include <brdf/simulate/surfaces/PlaneWaves.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// Cross section of a groove on a lattice of `nodes` steps a spacing, in steps from its centre.
struct Section {
  std::size_t nodes = 2, halfWidth = 1, halfBottom = 0;
};

/// The coarsest lattice on which a groove's edges fall on nodes; else, of those with at most `most` nodes a spacing,
/// the one that shifts them least.
Section sectionOf(double width, double bottom, double spacing, std::size_t least, std::size_t most) {
  Section best;
  double bestError = INFINITY;
  for (std::size_t nodes = std::max<std::size_t>(least, 2); nodes <= most && bestError > 1e-12; ++nodes) {
    const double step = spacing / static_cast<double>(nodes);
    const double halfWidth = std::round(width / (2 * step)), halfBottom = std::round(bottom / (2 * step));
    if (halfWidth <= halfBottom || 2 * halfWidth > static_cast<double>(nodes)) continue;
    const double error =
        std::max(std::abs(2 * halfWidth * step - width), std::abs(2 * halfBottom * step - bottom)) / spacing;
    if (error < bestError - 1e-12) {
      bestError = error;
      best = {nodes, static_cast<std::size_t>(halfWidth), static_cast<std::size_t>(halfBottom)};
    }
  }
  return best;
}

struct Grooves {
  explicit Grooves(const SurfaceArguments& arguments)
      : width(arguments.number("width")),
        spacing(arguments.number("spacing")),
        angle(arguments.number("angle")),
        bottom(arguments.number("bottom")),
        orientation(arguments.number("orientation")),
        setAngle(arguments.number("set_angle")),
        jitter(arguments.number("jitter")),
        sets(arguments.whole("sets")),
        grooves(arguments.whole("grooves")),
        resolution(arguments.whole("resolution")),
        seed(arguments.whole("seed")),
        where(arguments.where()) {
    if (width > spacing)
      arguments.refuse("width", "out of bounds", "at most the spacing, " + formatNumber(spacing) + " um");
    if (bottom >= width)
      arguments.refuse("bottom", "out of bounds", "less than the width, " + formatNumber(width) + " um");
    if (grooves == 0) grooves = jitter == 0 ? 1 : sets == 1 ? 32 : 8;
  }

  double width, spacing, angle, bottom, orientation, setAngle, jitter;
  std::size_t sets, grooves, resolution, seed;
  std::string where;
};

/// Depth of each lattice step across one family, micrometres below the land: the deepest of the grooves that cover it.
/// `steps` lattice steps hold `lines` spacings and begin again.
std::vector<float> depthsAcross(const Grooves& g, const Section& section, std::size_t lines, double step,
                                SurfaceRandom& random) {
  const std::size_t steps = lines * section.nodes;
  const double slope = 1 / std::tan(radians(g.angle / 2));
  std::vector<float> depths(steps, 0.0F);
  for (std::size_t line = 0; line < lines; ++line) {
    const double shift = g.jitter > 0 ? g.jitter * (random.uniform() - 0.5) * static_cast<double>(section.nodes) : 0;
    const std::size_t centre = line * section.nodes + section.nodes / 2 + steps +
                               static_cast<std::size_t>(std::lround(shift) + static_cast<long>(steps));
    for (std::size_t d = 0; d <= section.halfWidth; ++d) {
      const double depth = slope * step * static_cast<double>(section.halfWidth - std::max(d, section.halfBottom));
      for (const std::size_t at : {(centre + d) % steps, (centre + steps - d) % steps})
        depths[at] = std::max(depths[at], static_cast<float>(depth));
    }
  }
  return depths;
}

MadeSurface make(const SurfaceArguments& arguments, const SurfaceReaders&) {
  const Grooves g(arguments);
  std::vector<double> azimuths(g.sets);
  for (std::size_t k = 0; k < g.sets; ++k) azimuths[k] = g.orientation - 90 + static_cast<double>(k) * g.setAngle;
  PlaneWaves waves = commensurateTile(g.spacing, azimuths, g.grooves);

  // One family along an axis needs no nodes along its lines, and is as fine as its edges ask for. Where edges cross
  // cells, cells have to be small.
  const bool along = g.sets == 1 && (waves.turns[0][0] == 0 || waves.turns[0][1] == 0);
  const std::size_t least = along && g.jitter == 0 ? 2 : g.resolution;
  const std::size_t most =
      along ? std::max(least, kMaximumGeneratedNodes / 2 / std::max<std::size_t>(g.grooves, 2048)) : 2 * g.resolution;
  const Section section = sectionOf(g.width, g.bottom, g.spacing, least, most);
  const double width = g.spacing * 2 * static_cast<double>(section.halfWidth) / static_cast<double>(section.nodes);

  HeightField field;
  if (waves.periodX == 0) waves.periodX = g.spacing;
  if (waves.periodY == 0) waves.periodY = g.spacing;
  const auto nodesAlong = [&](std::size_t axis) {
    long turns = 0;
    for (const auto& wave : waves.turns) turns = std::max(turns, std::abs(wave[axis]));
    return turns == 0 ? std::size_t{2} : static_cast<std::size_t>(turns) * section.nodes;
  };
  field.columns = nodesAlong(0);
  field.rows = nodesAlong(1);
  if (field.columns > kMaximumGeneratedNodes / field.rows)
    throw Error(Error::Kind::Value, {"the tile is too large", g.where,
                                     std::to_string(field.columns) + " x " + std::to_string(field.rows) + " nodes",
                                     "2^24 nodes: fewer grooves, a lower resolution or other angles"});
  field.spacingX = waves.periodX / static_cast<double>(field.columns);
  field.spacingY = waves.periodY / static_cast<double>(field.rows);
  field.heights.assign(field.columns * field.rows, 0.0F);

  SurfaceRandom random(g.seed);
  for (std::size_t k = 0; k < g.sets; ++k) {
    const std::size_t lines = waves.lines(k);
    const std::vector<float> depths =
        depthsAcross(g, section, lines, waves.spacing(k) / static_cast<double>(section.nodes), random);
    // The phase of a node in lattice steps; between the steps of a family that the lattice does not fit, linear.
    const double stepsX = static_cast<double>(waves.turns[k][0]) * static_cast<double>(section.nodes) /
                          static_cast<double>(field.columns);
    const double stepsY =
        static_cast<double>(waves.turns[k][1]) * static_cast<double>(section.nodes) / static_cast<double>(field.rows);
    const auto steps = static_cast<double>(depths.size());
    for (std::size_t j = 0; j < field.rows; ++j)
      for (std::size_t i = 0; i < field.columns; ++i) {
        double phase = std::fmod(stepsX * static_cast<double>(i) + stepsY * static_cast<double>(j), steps);
        if (phase < 0) phase += steps;
        const double low = std::floor(phase + 1e-6), part = std::max(phase - low, 0.0);
        const auto at = static_cast<std::size_t>(low) % depths.size(), next = (at + 1) % depths.size();
        const double depth = (1 - part) * depths[at] + part * depths[next];
        float& height = field.heights[j * field.columns + i];
        height = std::min(height, static_cast<float>(-depth));
      }
  }

  MadeSurface made;
  made.facts = {{"groove width", width, "um"},
                {"groove depth", -*std::min_element(field.heights.begin(), field.heights.end()), "um"}};
  for (std::size_t k = 0; k < g.sets; ++k) {
    const std::string of = g.sets > 1 ? " of set " + std::to_string(k + 1) : "";
    made.facts.push_back({"spacing" + of, waves.spacing(k), "um"});
    made.facts.push_back({"azimuth along the grooves" + of, waves.azimuth(k) + 90, "deg"});
  }
  made.surface.shape = std::move(field);
  return made;
}

}  // namespace

SurfaceKind groovedSurface() {
  return {
      "grooves",
      "machined grooves",
      "A flat land, z = 0, with straight grooves cut into it: V-shaped, or trapezoidal with a flat bottom. Several "
      "sets "
      "cross, the deeper cut wins. The heights are exact where the edges of the grooves fall on nodes of the lattice: "
      "across x or y whenever the width and the spacing have a ratio of two whole numbers with at most 4096 nodes a "
      "spacing, else the width is rounded to the nearest that has, and the angle of the walls kept. Oblique and "
      "crossed "
      "sets have edges as sharp as one cell. Crossed sets that have no common tile have their spacings and azimuths "
      "rounded until they have; what they became is reported.",
      {lengthParameter("width", "groove width", 4, "width of a groove at the land"),
       lengthParameter("spacing", "groove spacing", 20, "from the centre of a groove to the next one's"),
       angleParameter("angle", "bottom angle", 60, 1, 179, "angle between the two walls of a groove"),
       lengthParameter("bottom", "bottom width", 0, "width of the flat bottom; 0 is a V", 0),
       angleParameter("orientation", "orientation", 90, -360, 360,
                      "azimuth along the grooves of the first set, from +x: at 90 they run along y"),
       numberParameter("sets", "groove sets", 1, 1, 6, "sets of parallel grooves that cross each other"),
       angleParameter("set_angle", "angle between sets", 90, 1, 179, "from one set to the next"),
       numberParameter("jitter", "jitter", 0, 0, 1,
                       "shift of each groove along the direction across it: uniform in +- jitter/2 spacings"),
       numberParameter("grooves", "grooves", 0, 0, 4096,
                       "least number of grooves of each set in a tile; 0: 1, with jitter 32 of one set and 8 of more"),
       numberParameter("resolution", "resolution", 128, 2, 4096,
                       "nodes a spacing of oblique, crossed and jittered grooves, at least; at most twice that"),
       seedParameter()},
      {},
      {},
      make};
}

}  // namespace brdf
