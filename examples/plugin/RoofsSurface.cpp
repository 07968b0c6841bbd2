#include "Workshop.h"

#include <brdf/geometry/Directions.h>

#include <cmath>

namespace workshop {
namespace {

brdf::Parameter parameter(std::string name, std::string unit, std::string description, double standard, double minimum,
                          double maximum) {
  brdf::Parameter record;
  record.name = record.label = record.symbol = std::move(name);
  record.unit = std::move(unit);
  record.description = std::move(description);
  record.defaultValue = standard;
  record.minimum = record.softMinimum = minimum;
  record.maximum = record.softMaximum = maximum;
  return record;
}

brdf::MadeSurface make(const brdf::SurfaceArguments& arguments, const brdf::SurfaceReaders&) {
  const double half = arguments.number("period") / 2;
  const double ridge = half * std::tan(brdf::radians(arguments.number("slope")));
  brdf::MadeSurface made;
  const auto top = static_cast<float>(ridge);
  made.surface.shape = brdf::HeightField{2, 2, half, half, {0, top, 0, top}};  // valley, ridge: repeated by the tile
  made.facts = {{"height of the ridges", ridge, "um"}};
  return made;
}

}  // namespace

brdf::SurfaceKind roofsSurface() {
  brdf::SurfaceKind kind;
  kind.name = "roofs";
  kind.title = "roofs side by side";
  kind.description = "Ridges along y, both sides of the same slope, with nothing between them.";
  kind.parameters = {parameter("slope", "deg", "of both sides", 15, 0, 80),
                     parameter("period", "um", "from ridge to ridge", 2, 1e-3, 1e6)};
  kind.make = make;
  return kind;
}

}  // namespace workshop
