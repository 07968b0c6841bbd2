#include <brdf/base/Error.h>
#include <brdf/base/Plugins.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/HeightStatistics.h>
#include <brdf/simulate/SurfaceKinds.h>
#include <brdf/simulate/surfaces/BuiltInSurfaces.h>

#include <algorithm>

namespace brdf {
namespace {

std::vector<SurfaceKind>& kinds() {
  static std::vector<SurfaceKind> all = builtInSurfaceKinds();
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

}  // namespace

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
  if (const auto* field = std::get_if<HeightField>(&made.surface.shape)) {
    field->check(arguments.where());
    describe(*field, made.facts);
  }
  return made;
}

}  // namespace brdf
