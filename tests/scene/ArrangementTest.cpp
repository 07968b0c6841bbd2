#include <brdf/base/Error.h>
#include <brdf/render/MeshFrames.h>
#include <brdf/render/SceneArrangement.h>
#include <brdf/render/Shapes.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace brdf;

double length(const Direction& d) { return std::sqrt(dot(d, d)); }

Direction difference(const Position& a, const Position& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Scene balls() {
  Scene scene;
  scene.materials = {groundMaterial()};
  scene.objects = {{"left", nullptr, {}, 0}, {"right", nullptr, {}, 0}};
  scene.objects[0].placement.shift = {-2, 1, 0};
  scene.objects[1].placement.shift = {3, 0.5, 0};
  scene.objects[1].placement.scale = 0.5;
  return scene;
}

TEST(Arrangement, TheGroundLiesUnderTheObjectsAndIsNoneOfThem) {
  Scene scene = balls();
  const SceneBounds bounds = sceneBounds(scene);
  EXPECT_EQ(bounds.low, (Position{-3, 0, -1}));
  EXPECT_EQ(bounds.high, (Position{3.5, 2, 1}));
  EXPECT_NEAR(bounds.radius, std::hypot(6.5, 2, 2) / 2, 1e-12);
  addGround(scene, groundMaterial());
  ASSERT_TRUE(scene.ground);
  const SceneObject& ground = scene.objects[*scene.ground];
  for (const Position& corner : ground.mesh->points) EXPECT_EQ(ground.placement.placed(corner)[1], 0);
  EXPECT_EQ(sceneBounds(scene).high, bounds.high);
  EXPECT_NO_THROW(checkScene(scene));
  EXPECT_THROW(addGround(scene, groundMaterial()), Error);
}

TEST(Arrangement, TurningGoesAroundTheVerticalAndLeavesTheGround) {
  Scene scene = balls();
  addGround(scene, groundMaterial());
  const Position before = scene.objects[*scene.ground].placement.shift;
  turnObjects(scene, {1, 0, 0}, 90);
  // Counter-clockwise seen from above: from -x to +z, from +x to -z.
  EXPECT_NEAR(length(difference(scene.objects[0].placement.shift, {1, 1, 3})), 0, 1e-12);
  EXPECT_NEAR(length(difference(scene.objects[1].placement.shift, {1, 0.5, -2})), 0, 1e-12);
  EXPECT_NEAR(scene.objects[0].placement.turned({1, 0, 0})[2], -1, 1e-12);
  EXPECT_EQ(scene.objects[*scene.ground].placement.shift, before);
}

TEST(Arrangement, PresetsAreNamedAndUnknownOnesRefused) {
  EXPECT_EQ(cameraPreset("grazing").elevation, 8);
  try {
    cameraPreset("below");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("three-quarter"), std::string::npos) << error.what();
  }
}

TEST(Shapes, NormalsAreThoseOfTheirTrianglesAndTangentsAcrossThem) {
  for (const ShapeName& shape : shapeNames()) {
    const TriangleMesh mesh = *makeShape(shape.name);
    ASSERT_EQ(mesh.normals.size(), mesh.points.size());
    ASSERT_EQ(mesh.tangents.size(), mesh.points.size());
    for (std::size_t k = 0; k < mesh.points.size(); ++k) {
      EXPECT_NEAR(length(mesh.normals[k]), 1, 1e-12);
      EXPECT_NEAR(length(mesh.tangents[k]), 1, 1e-12);
      EXPECT_NEAR(dot(mesh.normals[k], mesh.tangents[k]), 0, 1e-12);
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      const Direction flat =
          normalized(cross(difference(mesh.points[b], mesh.points[a]), difference(mesh.points[c], mesh.points[a])));
      // Half a step of 2 pi / 256 in each of two directions, and a triangle's corners at both ends.
      for (const auto corner : {a, b, c}) EXPECT_GT(dot(flat, mesh.normals[corner]), std::cos(0.036)) << shape.name;
    }
    TriangleMesh copy = mesh;
    EXPECT_EQ(removeDegenerateTriangles(copy), 0u) << shape.name;
  }
  EXPECT_FALSE(makeShape("teapot"));
}

TEST(Shapes, ClosedOnesHaveTheVolumeOfTheBodiesTheyAre) {
  const auto volume = [](const TriangleMesh& mesh) {  // divergence theorem
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) sum += dot(mesh.points[a], cross(mesh.points[b], mesh.points[c])) / 6;
    return sum;
  };
  EXPECT_NEAR(volume(*makeShape("cube")), 8, 1e-12);
  EXPECT_NEAR(volume(*makeShape("cylinder")), 2 * kPi, 1e-3 * 2 * kPi);
  EXPECT_NEAR(volume(*makeShape("cone")), 2 * kPi / 3, 1e-3 * kPi);
  EXPECT_GT(volume(*makeShape("preview")), 4 * kPi / 3 * 0.3);
}

TEST(Tangents, FollowTextureCoordinates) {
  // A tilted square whose u runs along its second edge, at another scale than v.
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 1}};
  mesh.normals.assign(4, normalized(Direction{0, -1, 1}));
  mesh.textureCoordinates = {{0, 0}, {0, 5}, {2, 5}, {2, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  addTangents(mesh);
  for (const Direction& t : mesh.tangents) EXPECT_NEAR(dot(t, normalized(Direction{0, 1, 1})), 1, 1e-12);
}

TEST(Tangents, GoAroundTheVerticalWithoutThem) {
  TriangleMesh mesh;
  mesh.points = mesh.normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, normalized(Direction{1, 5, 1})};
  mesh.triangles = {{0, 1, 2}};
  mesh.textureCoordinates.assign(4, {0.5, 0.5});  // which tell nothing
  addTangents(mesh);
  EXPECT_NEAR(mesh.tangents[0][2], -1, 1e-12);
  EXPECT_NEAR(mesh.tangents[1][0], 1, 1e-12);
  EXPECT_NEAR(mesh.tangents[2][0], 1, 1e-12);
  EXPECT_NEAR(dot(mesh.tangents[3], normalized(Direction{1, 0, -1})), 1, 1e-12);
}

TEST(Tangents, DegenerateTrianglesAreDropped) {
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 0, 3}, {0, 1, 3}};
  EXPECT_EQ(removeDegenerateTriangles(mesh), 2u);
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0][2], 3u);
}

}  // namespace
