#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/ImageFile.h>
#include <brdf/io/JsonObject.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/render/SceneArrangement.h>
#include <brdf/render/SceneFile.h>
#include <brdf/render/Shapes.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace brdf {
namespace {

/// A path written in the scene: relative to the scene's own folder.
std::filesystem::path beside(const std::filesystem::path& scene, const std::string& path) {
  return scene.parent_path() / path;
}

/// What loadMaterial makes of a text of the scene; a file beside the scene wins.
BrdfPointer material(const std::filesystem::path& scene, const std::string& text) {
  const std::size_t hash = text.find('#');
  const std::filesystem::path file = beside(scene, text.substr(0, hash));
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored))
    return loadMaterial(file.string() + (hash == std::string::npos ? "" : text.substr(hash))).brdf;
  return loadMaterial(text).brdf;
}

Placement placement(const JsonObject& object) {
  Placement place;
  place.shift = object.triple("position", {0, 0, 0});
  place.scale = object.number("scale", 1);
  if (const auto turn = object.object("rotate")) {
    const Direction axis = turn->triple("axis", {0, 1, 0});
    if (dot(axis, axis) == 0) turn->fail("no direction", "axis", "[0, 0, 0]", "a vector of any length but 0");
    place.axes = rotation(axis, turn->number("degrees"));
    turn->finish();
  }
  return place;
}

std::string shapeList() {
  std::vector<std::string> names;
  for (const ShapeName& shape : shapeNames()) names.emplace_back(shape.name);
  return joined(names);
}

using MaterialNames = std::map<std::string, std::size_t>;

std::size_t materialIndex(const JsonObject& entry, const MaterialNames& materials) {
  const std::string name = entry.text("material");
  const auto found = materials.find(name);
  if (found == materials.end()) {
    std::vector<std::string> names;
    for (const auto& [known, index] : materials) names.push_back(known);
    entry.fail("no such material", "material", "\"" + name + "\"", joined(names));
  }
  return found->second;
}

SceneObject sceneObject(const JsonObject& entry, const std::filesystem::path& scene, const SceneReaders& readers,
                        const MaterialNames& materials) {
  SceneObject object;
  object.name = entry.text("name", "");
  object.placement = placement(entry);
  if (entry.has("shape") == entry.has("mesh")) entry.fail("either of two", "shape or mesh", "", "exactly one of them");
  if (entry.has("mesh")) {
    if (!readers.mesh) entry.fail("this program reads no meshes", "mesh", "", "\"shape\"");
    object.mesh = std::make_shared<const TriangleMesh>(readers.mesh(beside(scene, entry.text("mesh"))));
  } else if (const std::string shape = entry.text("shape"); shape == "square") {
    object.mesh = std::make_shared<const TriangleMesh>(makeSquare(entry.number("side", 1)));
  } else if (shape == "sphere") {
    object.placement.scale *= entry.number("radius", 1);
  } else if (auto mesh = makeShape(shape)) {
    object.mesh = std::make_shared<const TriangleMesh>(std::move(*mesh));
  } else if (readers.shape) {
    object.mesh = std::make_shared<const TriangleMesh>(readers.shape(shape));
  } else {
    entry.fail("unknown shape", "shape", "\"" + shape + "\"", "sphere, " + shapeList());
  }
  object.material = materialIndex(entry, materials);
  entry.finish();
  return object;
}

SceneLight sceneLight(const JsonObject& entry) {
  SceneLight light;
  const std::string kind = entry.text("kind");
  if (kind == "directional") {
    const double theta = radians(entry.number("theta")), phi = radians(entry.number("phi", 0));
    light.position = {std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
    light.rgb = entry.triple("irradiance");
  } else if (kind == "point") {
    light.kind = SceneLight::Kind::Point;
    light.position = entry.triple("position");
    light.rgb = entry.triple("intensity");
  } else {
    entry.fail("unknown kind of light", "kind", "\"" + kind + "\"", "directional, point");
  }
  entry.finish();
  return light;
}

SceneEnvironment sceneEnvironment(const JsonObject& entry, const std::filesystem::path& scene) {
  SceneEnvironment environment;
  if (entry.has("file") == entry.has("constant"))
    entry.fail("either of two", "file or constant", "", "exactly one of them");
  if (entry.has("file")) {
    const std::string mapping = entry.has("mapping") ? entry.text("mapping") : "equirectangular";
    if (mapping != "equirectangular" && mapping != "angular")
      entry.fail("unknown mapping", "mapping", "\"" + mapping + "\"", "equirectangular, angular");
    environment.map = std::make_shared<const EnvironmentMap>(
        EnvironmentMap::read(beside(scene, entry.text("file")), EnvironmentMap::mapping(mapping)));
  } else {
    environment.map = std::make_shared<const EnvironmentMap>(EnvironmentMap::constant(entry.triple("constant")));
  }
  environment.rotation = entry.number("rotation", 0);
  environment.scale = entry.number("scale", 1);
  entry.finish();
  return environment;
}

SceneBackground sceneBackground(const JsonObject& entry, const std::filesystem::path& scene,
                                const SceneReaders& readers) {
  using Kind = SceneBackground::Kind;
  SceneBackground background;
  const std::string kind = entry.text("kind");
  if (kind == "color") {
    background.kind = Kind::Colour;
    background.rgb = entry.triple("color");
  } else if (kind == "image") {
    background.kind = Kind::Picture;
    const std::filesystem::path file = beside(scene, entry.text("file"));
    background.picture = std::make_shared<const Image>(readers.picture ? readers.picture(file) : readImage(file));
  } else if (kind == "none") {
    background.kind = Kind::Transparent;
  } else if (kind != "environment") {
    entry.fail("unknown kind of background", "kind", "\"" + kind + "\"", "environment, color, image, none");
  }
  entry.finish();
  return background;
}

/// The camera's place, given outright or by how it stands to the objects.
SceneCamera sceneCamera(const JsonObject& entry, const Scene& scene, bool ground) {
  SceneCamera camera;
  const double viewAngle = entry.number("view_angle", camera.viewAngle);
  const bool around = entry.has("preset") || entry.has("azimuth") || entry.has("elevation");
  if (around) {
    if (entry.has("position")) entry.fail("either of two", "position", "", "a position, or preset, azimuth, elevation");
    if (!(viewAngle > 0 && viewAngle < 180))
      entry.fail("angle of view out of range", "view_angle", formatNumber(viewAngle), "above 0 and below 180 degrees");
    const CameraPreset& preset = cameraPreset(entry.text("preset", "front"));
    const SceneBounds bounds = sceneBounds(scene);
    camera = cameraAround(entry.triple("target", bounds.center), bounds.radius * (ground ? kGroundMargin : 1),
                          entry.number("azimuth", preset.azimuth), entry.number("elevation", preset.elevation),
                          viewAngle, static_cast<double>(scene.width) / static_cast<double>(scene.height));
  } else {
    camera.position = entry.triple("position", camera.position);
    camera.target = entry.triple("target", camera.target);
    camera.viewAngle = viewAngle;
  }
  camera.up = entry.triple("up", camera.up);
  entry.finish();
  return camera;
}

}  // namespace

Scene readScene(const std::filesystem::path& path, const SceneReaders& readers) {
  const JsonObject file = JsonObject::read(path);
  Scene scene;
  if (const auto film = file.object("film")) {
    scene.width = film->count("width", scene.width, 1);
    scene.height = film->count("height", scene.height, 1);
    film->finish();
  }
  if (const auto entry = file.object("environment")) scene.environment = sceneEnvironment(*entry, path);
  if (const auto entry = file.object("background")) scene.background = sceneBackground(*entry, path, readers);
  for (const JsonObject& entry : file.objects("lights")) scene.lights.push_back(sceneLight(entry));
  std::map<std::string, std::size_t> materials;
  if (const auto list = file.object("materials"))
    for (const std::string& name : list->names()) {
      materials[name] = scene.materials.size();
      scene.materials.push_back(material(path, list->text(name)));
    }
  for (const JsonObject& entry : file.objects("objects"))
    scene.objects.push_back(sceneObject(entry, path, readers, materials));
  if (const auto entry = file.object("camera")) scene.camera = sceneCamera(*entry, scene, file.has("ground"));
  if (const auto entry = file.object("ground")) {
    addGround(scene, entry->has("material") ? scene.materials[materialIndex(*entry, materials)] : groundMaterial());
    entry->finish();
  }
  file.finish();
  try {
    checkScene(scene);
  } catch (const Error& error) {
    Error::Details details = error.details();
    details.where = path.string() + ", " + details.where;
    throw Error(error.kind(), std::move(details));
  }
  return scene;
}

}  // namespace brdf
