#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/material/LobeSum.h>
#include <brdf/render/SceneArrangement.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

constexpr std::array<CameraPreset, 6> kPresets{{
    {"front", 0, 0, "from +z, level"},
    {"three-quarter", 35, 25, "from the right and above"},
    {"side", 90, 0, "from +x, level"},
    {"back", 180, 0, "from -z, level"},
    {"top", 0, 89, "from above"},
    {"grazing", 0, 8, "from +z, low over the ground"},
}};

}  // namespace

SceneBounds sceneBounds(const Scene& scene) {
  SceneBounds bounds;
  Position low, high;
  low.fill(INFINITY);
  high.fill(-INFINITY);
  const auto add = [&](const Position& p, double margin) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k] - margin);
      high[k] = std::max(high[k], p[k] + margin);
    }
  };
  const SceneObject* last = nullptr;
  std::size_t count = 0;
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    if (k == scene.ground) continue;
    last = &scene.objects[k];
    ++count;
    if (!last->mesh) add(last->placement.shift, last->placement.scale);
    for (std::size_t i = 0; last->mesh && i < last->mesh->points.size(); ++i)
      add(last->placement.placed(last->mesh->points[i]), 0);
  }
  if (count == 0) return bounds;
  bounds.low = low;
  bounds.high = high;
  for (std::size_t k = 0; k < 3; ++k) bounds.center[k] = (low[k] + high[k]) / 2;
  bounds.radius = count == 1 && !last->mesh ? last->placement.scale
                                            : std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2;
  return bounds;
}

void addGround(Scene& scene, BrdfPointer material) {
  if (scene.ground) throw Error(Error::Kind::Value, {"the scene has a ground already", "ground", "", ""});
  const SceneBounds bounds = sceneBounds(scene);
  SceneObject ground;
  ground.name = "ground";
  ground.mesh = std::make_shared<const TriangleMesh>(makeSquare(40));
  ground.placement.scale = bounds.radius;
  ground.placement.shift = {bounds.center[0], bounds.low[1], bounds.center[2]};
  ground.material = scene.materials.size();
  scene.ground = scene.objects.size();
  scene.materials.push_back(std::move(material));
  scene.objects.push_back(std::move(ground));
}

BrdfPointer groundMaterial() { return parseMaterialExpression("0.4*Lambertian"); }

std::span<const CameraPreset> cameraPresets() { return kPresets; }

const CameraPreset& cameraPreset(std::string_view name) {
  const auto found = std::ranges::find(kPresets, name, &CameraPreset::name);
  if (found == kPresets.end()) {
    std::vector<std::string> names;
    for (const CameraPreset& preset : kPresets) names.emplace_back(preset.name);
    throw Error(Error::Kind::Value, {"unknown camera", "", "'" + std::string(name) + "'", joined(names)});
  }
  return *found;
}

void turnObjects(Scene& scene, const Position& center, double degrees) {
  Placement turn;
  turn.axes = rotation({0, 1, 0}, degrees);
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    if (k == scene.ground) continue;
    Placement& at = scene.objects[k].placement;
    for (Direction& axis : at.axes) axis = turn.turned(axis);
    Position from;
    for (std::size_t i = 0; i < 3; ++i) from[i] = at.shift[i] - center[i];
    const Position to = turn.turned(from);
    for (std::size_t i = 0; i < 3; ++i) at.shift[i] = center[i] + to[i];
  }
}

}  // namespace brdf
