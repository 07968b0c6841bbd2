#include <brdf/base/Error.h>
#include <brdf/base/Plugins.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/HeightStatistics.h>
#include <brdf/simulate/SurfaceKinds.h>
#include <brdf/simulate/surfaces/BuiltInSurfaces.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

std::vector<SurfaceKind>& kinds() {
  static std::vector<SurfaceKind> all = [] {
    std::vector<SurfaceKind> kinds = builtInSurfaceKinds();
    for (SurfaceKind& kind : kinds) kind.builtIn = true;
    return kinds;
  }();
  return all;
}

/// What every height field has to say of itself.
void describe(const HeightField& field, std::vector<SurfaceFact>& facts) {
  const HeightStatistics statistics = statisticsOf(field);
  facts.insert(facts.end(), {{"period along x", field.periodX(), "um"},
                             {"period along y", field.periodY(), "um"},
                             {"nodes along x", static_cast<double>(field.columns), "1"},
                             {"nodes along y", static_cast<double>(field.rows), "1"},
                             {"lowest point", statistics.lowest, "um"},
                             {"highest point", statistics.highest, "um"},
                             {"mean height", statistics.mean, "um"},
                             {"rms height", statistics.rms, "um"},
                             {"rms slope along x", statistics.rmsSlopeX, "1"},
                             {"rms slope along y", statistics.rmsSlopeY, "1"}});
}

void describe(const TiledMesh& mesh, std::vector<SurfaceFact>& facts) {
  double lowest = INFINITY, highest = -INFINITY;
  for (const auto& point : mesh.points) {
    lowest = std::min<double>(lowest, point[2]);
    highest = std::max<double>(highest, point[2]);
  }
  facts.insert(facts.end(), {{"period along x", mesh.periodX, "um"},
                             {"period along y", mesh.periodY, "um"},
                             {"lowest point", lowest, "um"},
                             {"highest point", highest, "um"},
                             {"triangles", static_cast<double>(mesh.triangles.size()), "1"}});
}

void describe(const SpherePacking& packing, std::vector<SurfaceFact>& facts) {
  facts.insert(facts.end(), {{"period along x", packing.periodX, "um"}, {"period along y", packing.periodY, "um"}});
}

/// Checks what was made, and lets it speak of itself.
void complete(MadeSurface& made, const std::string& where) {
  made.surface.check(where);
  std::visit([&](const auto& shape) { describe(shape, made.facts); }, made.surface.shape);
}

}  // namespace

MadeSurface describedSurface(SurfaceShape shape, std::string description) {
  MadeSurface made;
  if (std::holds_alternative<SpherePacking>(shape)) made.surface.facets.resize(2);
  made.surface.shape = std::move(shape);
  made.surface.description = std::move(description);
  complete(made, made.surface.description);
  return made;
}

void setMissingPeriods(TiledMesh& mesh, const std::string& where) {
  for (const std::size_t axis : {0, 1}) {
    double& period = axis == 0 ? mesh.periodX : mesh.periodY;
    if (period > 0) continue;
    float low = INFINITY, high = -INFINITY;
    for (const auto& point : mesh.points) {
      low = std::min(low, point[axis]);
      high = std::max(high, point[axis]);
    }
    if (!(high > low))
      throw Error(Error::Kind::Value,
                  {std::string("no extent along ") + (axis == 0 ? "x" : "y"), where, {}, "a period"});
    period = double{high} - double{low};
  }
}

const std::vector<SurfaceKind>& surfaceKinds() {
  plugins();
  return kinds();
}

void registerSurfaceKind(SurfaceKind kind) {
  if (const auto call = parseCall(kind.name, "name of a surface"); call.name != kind.name || !kind.make)
    throw Error(Error::Kind::Value, {"kind of surface cannot be used",
                                     {},
                                     "'" + kind.name + "'",
                                     "a name of letters, digits and '_', and a function that makes the surface"});
  const auto same = std::ranges::find(kinds(), kind.name, &SurfaceKind::name);
  if (same != kinds().end())
    *same = std::move(kind);
  else
    kinds().push_back(std::move(kind));
}

const SurfaceKind& findSurfaceKind(std::string_view name) {
  const auto found = std::ranges::find(surfaceKinds(), name, &SurfaceKind::name);
  if (found != surfaceKinds().end()) return *found;
  std::vector<std::string> names;
  for (const SurfaceKind& kind : surfaceKinds()) names.push_back(kind.name);
  const std::string nearest = closestName(name, names);
  throw Error(Error::Kind::Value, {"unknown kind of surface",
                                   {},
                                   "'" + std::string(name) + "'",
                                   joined(names) + (nearest.empty() ? "" : " (did you mean " + nearest + "?)")});
}

MadeSurface makeSurface(std::string_view expression, const SurfaceReaders& readers) {
  const Call call = parseCall(expression, "surface");
  const SurfaceKind& kind = findSurfaceKind(call.name);
  const SurfaceArguments arguments(call, kind.parameters, kind.texts);
  MadeSurface made = kind.make(arguments, readers);
  made.surface.description = arguments.expression();
  complete(made, arguments.where());
  return made;
}

}  // namespace brdf
