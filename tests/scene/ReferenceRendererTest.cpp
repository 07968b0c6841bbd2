// How the reference renderer behaves: shadows, frames, meshes, stopping, threads, bad input.
#include "Scenes.h"

#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>

#include <gtest/gtest.h>

namespace {

using namespace brdf;

/// A sphere of radius 1 as triangles with its normals and tangents.
TriangleMesh roundMesh(std::size_t rows) {
  TriangleMesh mesh;
  const std::size_t columns = 2 * rows;
  for (std::size_t j = 0; j <= rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const double theta = kPi * double(j) / double(rows), phi = 2 * kPi * double(i) / double(columns);
      const Direction n{std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
      mesh.points.push_back(n);
      mesh.normals.push_back(n);
      mesh.tangents.push_back({std::cos(phi), 0, -std::sin(phi)});
    }
  const auto index = [&](std::size_t j, std::size_t i) {
    return static_cast<std::uint32_t>(j * columns + i % columns);
  };
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      mesh.triangles.push_back({index(j, i), index(j + 1, i), index(j + 1, i + 1)});
      mesh.triangles.push_back({index(j, i), index(j + 1, i + 1), index(j, i + 1)});
    }
  return mesh;
}

ReferenceOptions exact() {
  ReferenceOptions options;
  options.samples = 2;
  options.pixelCentres = true;
  return options;
}

TEST(ReferenceRenderer, ASquareCastsItsShadow) {
  Scene scene;
  scene.materials = {parseMaterialExpression("Lambertian")};
  const auto square = std::make_shared<const TriangleMesh>(makeSquare(1));
  scene.objects.push_back({"floor", square, {10, Placement{}.axes, {0, 0, 0}}, 0});
  scene.objects.push_back({"screen", square, {1, Placement{}.axes, {0, 1, 0}}, 0});
  scene.lights.push_back({SceneLight::Kind::Directional, {1, 1, 0}, {kPi, kPi, kPi}});  // shadow 1 towards -x
  scene.camera.position = {0, 1000, 0};
  scene.camera.up = {0, 0, -1};
  scene.camera.viewAngle = 2 * degrees(std::atan(2.0 / 1000));  // 4 x 4 of the floor
  scene.width = scene.height = 40;
  const Image picture = renderReference(scene, exact()).radiance;
  for (std::size_t y = 0; y < 40; ++y)
    for (std::size_t x = 0; x < 40; ++x) {
      const double px = (double(x) + 0.5) / 10 - 2, pz = (double(y) + 0.5) / 10 - 2;
      const bool screen = std::abs(px) < 0.5 && std::abs(pz) < 0.5;
      const bool shadow = !screen && std::abs(px + 1) < 0.5 && std::abs(pz) < 0.5;
      EXPECT_NEAR(picture.pixel(x, y)[0], shadow ? 0 : std::sqrt(0.5), 1e-5) << px << ", " << pz;
    }
}

TEST(ReferenceRenderer, AMeshWithNormalsIsTheSphereItStandsFor) {
  Scene scene = sphereScene(parseMaterialExpression("0.5*Lambertian + 0.3*Ward(ax=0.2, ay=0.5)"), 32);
  scene.lights.push_back({SceneLight::Kind::Directional, {0.2, 0.7, 1}, {3, 3, 3}});
  const Image round = renderReference(scene, exact()).radiance;
  scene.objects[0].mesh = std::make_shared<const TriangleMesh>(roundMesh(200));
  const Image meshed = renderReference(scene, exact()).radiance;
  std::size_t compared = 0;
  for (std::size_t y = 0; y < 32; ++y)
    for (std::size_t x = 0; x < 32; ++x) {
      Direction normal, viewer;
      if (!sphereAt(scene, x, y, normal, viewer) || dot(normal, viewer) < 0.3) continue;
      const double expected = double(round.pixel(x, y)[1]);
      if (dot(normal, scene.lights[0].position) < 0.1) continue;  // near the shadow's edge facets show
      EXPECT_NEAR(double(meshed.pixel(x, y)[1]), expected, 2e-3 * expected) << x << ", " << y;
      ++compared;
    }
  EXPECT_GT(compared, 400u);
}

TEST(ReferenceRenderer, TangentsTurnWithTheObject) {
  const auto material = parseMaterialExpression("Ward(ax=0.1, ay=0.4)");
  Scene scene;
  scene.materials = {material};
  scene.objects.push_back({"square", std::make_shared<const TriangleMesh>(makeSquare(1)), {}, 0});
  scene.camera.position = {0, 3, 1};
  scene.camera.viewAngle = 1;
  scene.width = scene.height = 1;
  const Direction light = normalized({0.4, 1, -0.3}), viewer = normalized({0, 3, 1});
  scene.lights.push_back({SceneLight::Kind::Directional, light, {1, 1, 1}});
  for (const double turn : {0.0, 30.0, 90.0, 200.0}) {
    scene.objects[0].placement.axes = rotation({0, 1, 0}, turn);
    const double c = std::cos(radians(turn)), s = std::sin(radians(turn));
    const Direction t{c, 0, -s}, n{0, 1, 0}, b = cross(n, t);
    const auto local = [&](const Direction& d) { return Direction{dot(d, t), dot(d, b), dot(d, n)}; };
    const double expected = material->evaluate(local(light), local(viewer))[0] * light[1];
    EXPECT_NEAR(double(renderReference(scene, exact()).radiance.values[0]), expected, 1e-6 * expected) << turn;
  }
}

TEST(ReferenceRenderer, OpenSurfacesReflectOnBothSides) {
  Scene scene;
  scene.materials = {parseMaterialExpression("Lambertian")};
  scene.objects.push_back({"square", std::make_shared<const TriangleMesh>(makeSquare(10)), {}, 0});
  scene.lights.push_back({SceneLight::Kind::Directional, {0, -1, 0}, {kPi, kPi, kPi}});
  scene.camera.position = {0, -3, 0.1};
  scene.width = scene.height = 1;
  EXPECT_NEAR(renderReference(scene, exact()).radiance.values[0], 1, 1e-6);
  scene.camera.position = {0, 3, 0.1};
  EXPECT_EQ(renderReference(scene, exact()).radiance.values[0], 0);
}

TEST(ReferenceRenderer, TheSamePictureOnAnyNumberOfThreads) {
  Scene scene = sphereScene(parseMaterialExpression("0.2*Lambertian + 0.6*GGX(alpha=0.3)"), 20);
  scene.environment = constantLight(1);
  scene.background = {};  // the environment
  ReferenceOptions options;
  options.samples = 50;
  options.bounces = 2;
  const Image all = renderReference(scene, options).radiance;
  setThreadCount(1);
  const Image one = renderReference(scene, options).radiance;
  setThreadCount(0);
  EXPECT_EQ(all.values, one.values);
  options.seed = 2;
  EXPECT_NE(renderReference(scene, options).radiance.values, one.values);
}

TEST(ReferenceRenderer, StopsAtTheToleranceAndWhenTold) {
  Scene scene = sphereScene(parseMaterialExpression("0.5*Lambertian + 0.4*GGX(alpha=0.4)"), 16);
  scene.environment = constantLight(1);
  ReferenceOptions options;
  options.samples = 1 << 16;
  options.tolerance = 0.01;
  const ReferencePicture enough = renderReference(scene, options);
  EXPECT_TRUE(enough.converged);
  EXPECT_LE(enough.relativeError, 0.01);
  EXPECT_LT(enough.samples, options.samples);
  options.tolerance = 0;
  options.progress = [](std::size_t done, std::size_t most, double) {
    EXPECT_LE(done, most);
    return done < 32;
  };
  const ReferencePicture told = renderReference(scene, options);
  EXPECT_TRUE(told.stopped);
  EXPECT_EQ(told.samples, 32u);
}

TEST(ReferenceRenderer, AnEmptySceneShowsTheEnvironment) {
  Scene scene;
  scene.width = 4, scene.height = 2;
  EXPECT_EQ(renderReference(scene).radiance.values, std::vector<float>(24, 0.0f));
  scene.environment = constantLight(2);
  scene.background = {};  // the environment
  EXPECT_EQ(renderReference(scene).radiance.values, std::vector<float>(24, 2.0f));
}

TEST(ReferenceRenderer, SaysWhatIsWrong) {
  const auto refused = [](Scene scene, const ReferenceOptions& options = {}) {
    try {
      renderReference(scene, options);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const Scene good = sphereScene(parseMaterialExpression("Lambertian"), 4);
  Scene scene = good;
  scene.objects[0].material = 3;
  EXPECT_EQ(refused(scene), "object 'sphere': no such material; found 3");
  scene = good;
  scene.camera.target = scene.camera.position;
  EXPECT_EQ(refused(scene), "camera: the camera stands at its target");
  scene = good;
  scene.camera.up = {0, 0, 1};
  EXPECT_EQ(refused(scene), "camera: the camera's up lies along its view");
  scene = good;
  scene.width = 0;
  EXPECT_EQ(refused(scene), "film: the film's size is not usable; found 0 x 4; allowed: 1 to 2^26 pixels in all");
  scene = good;
  auto mesh = makeSquare(1);
  mesh.triangles[0][1] = 9;
  scene.objects[0].mesh = std::make_shared<const TriangleMesh>(mesh);
  EXPECT_EQ(refused(scene), "object 'sphere': a triangle's corner is no point; found 9");
  ReferenceOptions options;
  options.samples = 1;
  EXPECT_EQ(refused(good, options), "reference renderer: samples out of range; found 1; allowed: 2 to 16777216");
}

}  // namespace
