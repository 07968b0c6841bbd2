#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/simulate/surfaces/BuiltInSurfaces.h>
#include <brdf/simulate/surfaces/PlaneWaves.h>

#include <array>
#include <cmath>

namespace brdf {
namespace {

struct ProfilePoint {
  double along, height;  ///< micrometres across the lines, and z
};

/// One period of a surface that is the same all along its lines, as strips between the points of its cross section; the
/// last is a pitch after the first, at the same height. Exact for any azimuth across the lines (degrees): the strips
/// fill a parallelogram whose copies, shifted by the periods, fill the plane.
TiledMesh stripMesh(const std::vector<ProfilePoint>& profile, double azimuth) {
  const double pitch = profile.back().along - profile.front().along;
  const PlaneWaves tile = commensurateTile(pitch, std::array{azimuth}, 1);
  TiledMesh mesh;
  mesh.periodX = tile.periodX > 0 ? tile.periodX : pitch;
  mesh.periodY = tile.periodY > 0 ? tile.periodY : pitch;
  // Points of equal phase: along x, or along y where the phase does not depend on x; and the way to the next tile along
  // the lines, to the left of the direction across them.
  const double a = radians(azimuth);
  std::array<double, 2> across{}, lines{};
  if (tile.periodX > 0) {
    across = {std::copysign(mesh.periodX, std::cos(a)) / pitch, 0};
    lines = tile.periodY > 0
                ? std::array{std::copysign(mesh.periodX, -std::sin(a)), std::copysign(mesh.periodY, std::cos(a))}
                : std::array{0.0, std::copysign(mesh.periodY, std::cos(a))};
  } else {
    across = {0, std::copysign(mesh.periodY, std::sin(a)) / pitch};
    lines = {std::copysign(mesh.periodX, -std::sin(a)), 0};
  }
  for (const ProfilePoint& point : profile)
    for (const double side : {0.0, 1.0})
      mesh.points.push_back({static_cast<float>(point.along * across[0] + side * lines[0]),
                             static_cast<float>(point.along * across[1] + side * lines[1]),
                             static_cast<float>(point.height)});
  for (std::uint32_t k = 0; k + 1 < profile.size(); ++k) {
    const std::uint32_t p = 2 * k;
    mesh.triangles.push_back({p, p + 2, p + 3});
    mesh.triangles.push_back({p, p + 3, p + 1});
  }
  return mesh;
}

MadeSurface made(TiledMesh mesh) {
  MadeSurface made;
  made.surface.shape = std::move(mesh);
  return made;
}

Parameter pitchParameter() { return lengthParameter("pitch", "pitch", 10, "from one line to the next", 1e-3); }

Parameter orientationParameter() {
  return angleParameter("orientation", "orientation", 90, -360, 360,
                        "azimuth along the lines, from +x: at 90 they run along y");
}

MadeSurface makeLamellar(const SurfaceArguments& arguments, const SurfaceReaders&) {
  const double pitch = arguments.number("pitch"), depth = arguments.number("depth");
  const double half = pitch * arguments.number("duty") / 2;
  return made(stripMesh({{-half, 0}, {half, 0}, {half, -depth}, {pitch - half, -depth}, {pitch - half, 0}},
                        arguments.number("orientation") - 90));
}

MadeSurface makeBlazed(const SurfaceArguments& arguments, const SurfaceReaders&) {
  const double pitch = arguments.number("pitch");
  const double rise = 1 / std::tan(radians(arguments.number("blaze"))), fall = arguments.number("back");
  // Widths in projection of the facet and of the other side, which is vertical at 90 degrees.
  const double back = fall == 90 ? 0 : 1 / std::tan(radians(fall));
  const double height = pitch / (rise + back);
  MadeSurface result =
      made(stripMesh({{0, 0}, {height * rise, height}, {pitch, 0}}, arguments.number("orientation") - 90));
  result.facts = {{"height", height, "um"}};
  return result;
}

MadeSurface makeSinusoidal(const SurfaceArguments& arguments, const SurfaceReaders&) {
  const std::size_t nodes = arguments.whole("resolution");
  const PlaneWaves tile =
      commensurateTile(arguments.number("pitch"), std::array{arguments.number("orientation") - 90}, 1);
  const double amplitude = arguments.number("depth") / 2;
  HeightField field;
  field.columns = tile.periodX > 0 ? nodes : 2;
  field.rows = tile.periodY > 0 ? nodes : 2;
  const double pitch = arguments.number("pitch");
  field.spacingX = (tile.periodX > 0 ? tile.periodX : pitch) / static_cast<double>(field.columns);
  field.spacingY = (tile.periodY > 0 ? tile.periodY : pitch) / static_cast<double>(field.rows);
  const auto [turnsX, turnsY] = tile.turns[0];
  for (std::size_t j = 0; j < field.rows; ++j)
    for (std::size_t i = 0; i < field.columns; ++i) {
      const double phase = static_cast<double>(turnsX) * static_cast<double>(i) / static_cast<double>(field.columns) +
                           static_cast<double>(turnsY) * static_cast<double>(j) / static_cast<double>(field.rows);
      field.heights.push_back(static_cast<float>(amplitude * std::cos(2 * kPi * phase)));
    }
  MadeSurface result;
  result.surface.shape = std::move(field);
  return result;
}

}  // namespace

SurfaceKind lamellarSurface() {
  return {"lamellar",
          "lamellar grating",
          "Flat lands, z = 0, and flat bottoms with vertical walls, exactly, as triangles in any direction.",
          {pitchParameter(), lengthParameter("depth", "depth", 1, "of the bottoms below the lands"),
           numberParameter("duty", "duty cycle", 0.5, 0.001, 0.999, "width of a land over the pitch"),
           orientationParameter()},
          {},
          {},
          makeLamellar};
}

SurfaceKind sinusoidalSurface() {
  return {"sinusoidal",
          "sinusoidal grating",
          "Heights depth/2 cos(2 pi s / pitch), s across the lines, at the nodes of a lattice.",
          {pitchParameter(), lengthParameter("depth", "depth", 1, "from the highest to the lowest point", 0),
           orientationParameter(),
           numberParameter("resolution", "resolution", 256, 4, 4096, "nodes a pitch, along each axis")},
          {},
          {},
          makeSinusoidal};
}

SurfaceKind blazedSurface() {
  return {"blazed",
          "blazed grating",
          "Saw teeth: a facet that rises from z = 0 at the blaze angle towards the right of the lines, and a back "
          "that falls again; exactly, as triangles in any direction. Both angles of 45 degrees give retro-reflecting "
          "V-grooves.",
          {pitchParameter(), angleParameter("blaze", "blaze angle", 20, 0.01, 89, "of the facet from the plane"),
           angleParameter("back", "back angle", 90, 0.01, 90, "of the back of the teeth from the plane"),
           orientationParameter()},
          {},
          {},
          makeBlazed};
}

}  // namespace brdf
