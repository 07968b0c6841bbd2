#include "SceneArguments.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/render/SceneFile.h>
#include <brdf/render/Shapes.h>

#include <cmath>

namespace brdf::app {
namespace {

/// Brightness: a white Lambertian at the origin that faces a light besides the environment has radiance 1.
void addLight(Scene& scene, const std::string& text, double rotation) {
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string value = colon == std::string::npos ? "" : text.substr(colon + 1);
  if ((kind == "env" || kind == "angular") && !value.empty()) {
    const auto mapping = kind == "env" ? EnvironmentMap::Mapping::Equirectangular : EnvironmentMap::Mapping::Angular;
    scene.environment =
        SceneEnvironment{std::make_shared<const EnvironmentMap>(EnvironmentMap::read(value, mapping)), rotation, 1};
  } else if (kind == "directional") {
    const auto at = numberListOption("--light", value, 2, "directional:45,0");
    const double theta = radians(at[0]), phi = radians(at[1]);
    scene.lights.push_back({SceneLight::Kind::Directional,
                            {std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)},
                            {kPi, kPi, kPi}});
  } else if (kind == "point") {
    const auto at = numberListOption("--light", value, 3, "point:2,2,3");
    const double intensity = kPi * (at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
    scene.lights.push_back({SceneLight::Kind::Point, {at[0], at[1], at[2]}, {intensity, intensity, intensity}});
  } else {
    throw Error(Error::Kind::Usage, {"unknown light", "--light", "'" + text + "'",
                                     "env:FILE, angular:FILE, directional:theta,phi (degrees) or point:x,y,z"});
  }
}

Scene sceneFromFile(const SceneRequest& request) {
  if (!request.lights.empty())
    throw Error(Error::Kind::Usage, {"a scene has its own lights", "--light", request.lights.front(), ""});
  SceneReaders readers;
  readers.mesh = [](const std::filesystem::path& path) { return pictures().makeObject(path.string()); };
  readers.shape = [](const std::string& name) { return pictures().makeObject(name); };
  readers.picture = [](const std::filesystem::path& path) { return pictures().readPicture(path.string()); };
  return readScene(request.scene, readers);
}

Scene sceneOfOneObject(const SceneRequest& request) {
  if (request.lights.empty())
    throw Error(Error::Kind::Usage, {"required option missing", "--light", "",
                                     "env:FILE, angular:FILE, directional:theta,phi or point:x,y,z"});
  Scene scene;
  for (const std::string& light : request.lights) addLight(scene, light, request.rotation);
  scene.materials = {loadMaterial(request.material, request.assumptions).brdf};
  SceneObject object{request.object, nullptr, {}, 0};
  if (request.object != "sphere") {
    auto mesh = makeShape(request.object);
    object.mesh = std::make_shared<const TriangleMesh>(mesh ? std::move(*mesh) : pictures().makeObject(request.object));
  }
  scene.objects.push_back(std::move(object));
  return scene;
}

SceneBackground background(const std::string& text) {
  SceneBackground background;
  if (text == "none") {
    background.kind = SceneBackground::Kind::Transparent;
  } else if (text.starts_with("color:")) {
    const auto rgb = numberListOption("--background", text.substr(6), 3, "color:0.2,0.2,0.2");
    background.kind = SceneBackground::Kind::Colour;
    background.rgb = {rgb[0], rgb[1], rgb[2]};
  } else if (text != "environment") {
    background.kind = SceneBackground::Kind::Picture;
    background.picture = std::make_shared<const Image>(pictures().readPicture(text));
  }
  return background;
}

void placeCamera(const SceneRequest& request, Scene& scene) {
  const bool asked =
      !request.camera.empty() || request.azimuth || request.elevation || request.viewAngle || !request.lookAt.empty();
  if (!request.scene.empty() && !asked) return;
  const CameraPreset& preset = cameraPreset(request.camera.empty() ? "front" : request.camera);
  const SceneBounds bounds = sceneBounds(scene);
  Position target = bounds.center;
  if (!request.lookAt.empty()) {
    const auto at = numberListOption("--look-at", request.lookAt, 3, "0,0.5,0");
    target = {at[0], at[1], at[2]};
  }
  scene.camera = cameraAround(target, bounds.radius * (request.ground ? kGroundMargin : 1),
                              request.azimuth.value_or(preset.azimuth), request.elevation.value_or(preset.elevation),
                              request.viewAngle.value_or(30),
                              static_cast<double>(scene.width) / static_cast<double>(scene.height));
}

}  // namespace

void declareScene(Arguments& arguments, SceneRequest& request) {
  arguments.positional("MATERIAL", request.material, "A file, an expression or preset:NAME");
  arguments.optional();
  arguments.option("--object", request.object, "NAME|FILE",
                   "A shape (docs/rendering.md lists them), or a file: .ply, .obj, .stl, .vtp, .gltf, .glb [sphere]");
  arguments.option("--light", request.lights, "LIGHT",
                   "env:FILE (equirectangular .exr or .hdr), angular:FILE (a light probe of Debevec), "
                   "directional:theta,phi (degrees from +y, and about it from +z) or "
                   "point:x,y,z; the last two give a white diffuser that faces them radiance 1; several times");
  arguments.option("--rotate", request.rotation, {-360, 360}, "DEGREES", "Turn the environment about the vertical");
  arguments.option("--scene", request.scene, "FILE.json",
                   "Objects, materials, lights and camera in a file (docs/scenes.md) instead of a material");
  std::vector<std::string> names;
  for (const CameraPreset& preset : cameraPresets()) names.emplace_back(preset.name);
  arguments.option("--camera", request.camera, "NAME",
                   "Where the camera stands, all objects in view: " + joined(names) + " [front, or the scene's own]");
  arguments.option("--azimuth", request.azimuth, {-360, 360}, "DEGREES",
                   "Instead of the camera's: from +z about the vertical, counter-clockwise seen from above");
  arguments.option("--elevation", request.elevation, {-89, 89}, "DEGREES", "Instead of the camera's: above the level");
  arguments.option("--view-angle", request.viewAngle, {1, 120}, "DEGREES", "Vertical angle of view [30]");
  arguments.option("--look-at", request.lookAt, "X,Y,Z", "What the camera looks at [the middle of the objects]");
  arguments.optionWithOptionalValue("--ground", request.ground, request.groundMaterial, "MATERIAL",
                                    "A plane under the objects [0.4*Lambertian]");
  arguments.option("--background", request.background, "BACKGROUND",
                   "environment, color:r,g,b (linear radiance), none (transparent), or a picture: .exr, .hdr, .png, "
                   ".jpg [environment, or the scene's own]");
  arguments.option("--size", request.size, "WxH", "Pixels [512x512, or the scene's own]");
}

Scene arrangeScene(const SceneRequest& request) {
  if (request.scene.empty() == request.material.empty())
    throw Error(Error::Kind::Usage, {"what to render", "", request.scene.empty() ? "nothing" : "a material and a scene",
                                     "MATERIAL or --scene FILE.json"});
  std::optional<PictureSize> size;
  if (!request.size.empty()) size = sizeOption(request.size);
  Scene scene = request.scene.empty() ? sceneOfOneObject(request) : sceneFromFile(request);
  if (size) {
    scene.width = size->width;
    scene.height = size->height;
  }
  placeCamera(request, scene);
  if (!request.background.empty()) scene.background = background(request.background);
  if (request.ground)
    addGround(scene, request.groundMaterial.empty() ? groundMaterial()
                                                    : loadMaterial(request.groundMaterial, request.assumptions).brdf);
  return scene;
}

}  // namespace brdf::app
