#include "../TestFolder.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/io/ImageFile.h>
#include <brdf/render/SceneArrangement.h>
#include <brdf/render/SceneFile.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace brdf;

std::filesystem::path written(const std::string& text) {
  const auto path = testFolder("scene") / "scene.json";
  writeFile(path, text);
  return path;
}

std::string refusal(const std::string& text) {
  const auto path = written(text);
  try {
    readScene(path);
  } catch (const Error& error) {
    std::string what = error.what();
    const std::string folder = path.parent_path().string() + "/";
    for (std::size_t at; (at = what.find(folder)) != std::string::npos;) what.erase(at, folder.size());
    return what;
  }
  return "accepted";
}

TEST(SceneFile, EverythingItCanSay) {
  const auto path = written(R"json({
    // a comment
    "film": {"width": 320, "height": 200},
    "camera": {"position": [0, 1, 5], "target": [0, 0.5, 0], "up": [0, 1, 0], "view_angle": 40},
    "environment": {"constant": [1, 2, 3], "rotation": 90, "scale": 0.5},
    "background": {"kind": "color", "color": [0.1, 0.2, 0.3]},
    "lights": [{"kind": "directional", "theta": 90, "phi": 90, "irradiance": [3, 2, 1]},
               {"kind": "point", "position": [1, 2, 3], "intensity": [4, 5, 6]}],
    "materials": {"red": "(0.5,0.1,0.1)*Lambertian", "metal": "GGX(alpha=0.2)"},
    "objects": [{"name": "ball", "shape": "sphere", "radius": 0.5, "position": [0, 0.5, 0], "material": "metal"},
                {"shape": "square", "side": 4, "rotate": {"axis": [1, 0, 0], "degrees": 90}, "material": "red"},
                {"mesh": "cow.ply", "scale": 2, "material": "red"}]
})json");
  std::filesystem::path asked;
  SceneReaders readers;
  readers.mesh = [&](const std::filesystem::path& file) {
    asked = file;
    return makeSquare(7);
  };
  const Scene scene = readScene(path, readers);
  EXPECT_EQ(asked, path.parent_path() / "cow.ply");
  EXPECT_EQ(scene.width, 320u);
  EXPECT_EQ(scene.height, 200u);
  EXPECT_EQ(scene.camera.position, (Position{0, 1, 5}));
  EXPECT_EQ(scene.camera.viewAngle, 40);
  ASSERT_TRUE(scene.environment);
  EXPECT_EQ(scene.environment->rotation, 90);
  EXPECT_EQ(scene.environment->scale, 0.5);
  EXPECT_EQ(scene.background.kind, SceneBackground::Kind::Colour);
  EXPECT_EQ(scene.background.rgb, (Rgb{0.1, 0.2, 0.3}));
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_NEAR(scene.lights[0].position[0], 1, 1e-15);
  EXPECT_EQ(scene.lights[0].rgb, (Rgb{3, 2, 1}));
  EXPECT_EQ(scene.lights[1].kind, SceneLight::Kind::Point);
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(scene.objects[0].placement.scale, 0.5);
  EXPECT_EQ(scene.materials[scene.objects[0].material]->description(), "GGX(alpha=0.2, ior=1.5)");
  EXPECT_NEAR(scene.objects[1].placement.turned({0, 1, 0})[2], 1, 1e-15);  // facing the camera
  EXPECT_EQ(scene.objects[2].mesh->points[1][0], 3.5);
  EXPECT_EQ(scene.objects[2].placement.scale, 2);
}

TEST(SceneFile, AnEnvironmentMayBeALightProbe) {
  const auto path = written(R"json({"environment": {"file": "probe.exr", "mapping": "angular"},
    "materials": {"m": "Lambertian"}, "objects": [{"shape": "sphere", "material": "m"}]})json");
  Image probe(64, 64, 3);
  for (std::size_t y = 0; y < 64; ++y)
    for (std::size_t x = 32; x < 64; ++x) std::fill_n(probe.pixel(x, y), 3, 1.0f);
  writeExr(probe, path.parent_path() / "probe.exr");
  const Scene scene = readScene(path);
  EXPECT_EQ(scene.environment->map->radiance({1, 0, 0})[0], 1);  // the right half of the probe
  EXPECT_EQ(scene.environment->map->radiance({-1, 0, 0})[0], 0);
}

TEST(SceneFile, CamerasStandAroundTheObjectsAndTheGroundLiesUnderThem) {
  const Scene scene = readScene(written(R"json({
    "film": {"width": 300, "height": 200}, "camera": {"preset": "three-quarter", "elevation": 40},
    "materials": {"m": "Lambertian"}, "ground": {}, "background": {"kind": "none"},
    "objects": [{"shape": "sphere", "radius": 2, "position": [1, 5, 0], "material": "m"}]})json"));
  ASSERT_TRUE(scene.ground);
  EXPECT_EQ(scene.objects[*scene.ground].placement.shift[1], 3);
  EXPECT_EQ(scene.camera.target, (Position{1, 5, 0}));
  const SceneCamera expected = cameraAround({1, 5, 0}, 2 * kGroundMargin, 35, 40, 30, 1.5);
  EXPECT_EQ(scene.camera.position, expected.position);
  EXPECT_EQ(scene.background.kind, SceneBackground::Kind::Transparent);
  EXPECT_NE(refusal(R"({"camera": {"preset": "below"}})").find("three-quarter"), std::string::npos);
  EXPECT_NE(refusal(R"({"camera": {"azimuth": 3, "position": [0, 0, 1]}})").find("either of two"), std::string::npos);
  EXPECT_NE(refusal(R"({"background": {"kind": "sky"}})").find("environment, color, image, none"), std::string::npos);
}

TEST(SceneFile, SaysWhereItIsWrong) {
  EXPECT_EQ(refusal("{\n\"film\": {\n}"), "scene.json, line 3: not JSON; found a fault near byte 14");
  EXPECT_EQ(refusal("[]"), "scene.json: no object; found []; allowed: {...}");
  EXPECT_EQ(refusal(R"({"flim": {}})"),
            "scene.json: unknown key; found \"flim\" (did you mean \"film\"?); allowed: background, "
            "camera, environment, film, ground, lights, materials, objects");
  EXPECT_EQ(refusal(R"({"camera": {"position": [1, 2]}})"),
            "scene.json: camera.position: not three numbers; found [1,2]; allowed: [x, y, z]");
  EXPECT_EQ(refusal(R"({"objects": [{"shape": "teapot", "material": "a"}]})"),
            "scene.json: objects[0].shape: unknown shape; found \"teapot\"; allowed: sphere, cone, cube, "
            "cylinder, plane, preview, square");
  EXPECT_EQ(refusal(R"({"materials": {"b": "Lambertian"}, "objects": [{"shape": "sphere", "material": "a"}]})"),
            "scene.json: objects[0].material: no such material; found \"a\"; allowed: b");
  EXPECT_EQ(refusal(R"({"materials": {"b": "Lambertain"}})").find("Lambertain") != std::string::npos, true);
  EXPECT_EQ(refusal(R"({"materials": {"b": "Lambertian"}, "objects": [{"mesh": "x.ply", "material": "b"}]})"),
            "scene.json: objects[0].mesh: this program reads no meshes; allowed: \"shape\"");
  EXPECT_EQ(refusal(R"({"film": {"width": 1e9, "height": 1e9}})"),
            "scene.json, film: the film's size is not usable; found 1000000000 x 1000000000; allowed: 1 to 2^26 pixels "
            "in all");
  EXPECT_EQ(refusal(R"({"lights": [{"kind": "directional", "theta": 0, "irradiance": [1, -1, 1]}]})"),
            "scene.json, light 0: negative light; allowed: 0 or more");
}

}  // namespace
