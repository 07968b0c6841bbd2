// The reference renderer against closed forms and independent sums.
#include "Scenes.h"

#include <brdf/material/TableBrdf.h>
#include <brdf/sampling/DirectionalAlbedo.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace {

using namespace brdf;

/// What standard errors say of differences: the mean of (difference / error)^2 is 1 up to sqrt(2 / count) when there is
/// no bias and the errors are right.
struct Scores {
  double squares = 0, largest = 0;
  std::size_t count = 0;
  void add(double difference, double error) {
    const double z = difference / error;
    squares += z * z;
    largest = std::max(largest, std::abs(z));
    ++count;
  }
  double mean() const { return squares / double(count); }
};

class WhiteFurnace : public testing::TestWithParam<const char*> {};

TEST_P(WhiteFurnace, IsTheDirectionalAlbedo) {
  Scene scene = sphereScene(parseMaterialExpression(GetParam()), 24);
  scene.environment = constantLight(1);
  ReferenceOptions options;
  options.samples = 1024;
  options.pixelCentres = true;
  const ReferencePicture picture = renderReference(scene, options);
  EXPECT_EQ(picture.samples, 1024u);
  Scores scores;
  const std::size_t row = 12;
  for (std::size_t x = 0; x < 24; ++x) {
    Direction normal, viewer;
    if (!sphereAt(scene, x, row, normal, viewer)) continue;
    const Albedo albedo = directionalAlbedo(*scene.materials[0], std::acos(dot(normal, viewer)), 4096);
    const double error = double(picture.standardError.pixel(x, row)[1]);
    scores.add(double(picture.radiance.pixel(x, row)[1]) - albedo.value[albedo.value.size() / 2],
               std::hypot(error, albedo.error[0] + 1e-6));
  }
  ASSERT_GT(scores.count, 15u);
  EXPECT_LT(scores.mean(), 2.2);  // chi-square with 20 degrees of freedom above 44: one in 700
  EXPECT_LT(scores.largest, 4.5);
}
INSTANTIATE_TEST_SUITE_P(Reference, WhiteFurnace,
                         testing::Values("Lambertian", "GGX(alpha=0.3)", "GGX(alpha=0.05)", "AshikhminShirley",
                                         "0.5*Lambertian + CookTorrance", "OrenNayar", "SGD"));

TEST(Reference, ATableIsTheDirectionalAlbedoInAWhiteFurnace) {
  TableLayout layout;
  layout.thetaH /= 2, layout.thetaD /= 3, layout.phiD /= 6;
  const auto table =
      TableBrdf::tabulate(*parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + 0.4*GGX(alpha=0.2)"), layout);
  Scene scene = sphereScene(table, 16);
  scene.environment = constantLight(1);
  ReferenceOptions options;
  options.samples = 2048;
  options.pixelCentres = true;
  const ReferencePicture picture = renderReference(scene, options);
  Scores scores;
  for (std::size_t x = 0; x < 16; ++x) {
    Direction normal, viewer;
    if (!sphereAt(scene, x, 8, normal, viewer)) continue;
    const Albedo albedo = directionalAlbedo(*table, std::acos(dot(normal, viewer)), 8192);
    for (std::size_t c = 0; c < 3; ++c)
      scores.add(double(picture.radiance.pixel(x, 8)[c]) - albedo.value[c],
                 std::hypot(double(picture.standardError.pixel(x, 8)[c]), albedo.error[c]));
  }
  EXPECT_LT(scores.mean(), 2.5);  // 14 pixels, the three channels of each go together
  EXPECT_LT(scores.largest, 4.5);
}

TEST(Reference, ADirectionalLightIsTheValueTimesCosineTimesIrradiance) {
  const auto material = parseMaterialExpression("(0.3,0.1,0.05)*Lambertian + 0.4*Ward(ax=0.1, ay=0.4)");
  Scene scene = sphereScene(material, 64);
  const Direction light = normalized({0.3, 0.8, 0.6});
  scene.lights.push_back({SceneLight::Kind::Directional, light, {2, 3, 4}});
  ReferenceOptions options;
  options.samples = 2;
  options.pixelCentres = true;
  const ReferencePicture picture = renderReference(scene, options);
  std::size_t lit = 0;
  for (std::size_t y = 0; y < 64; ++y)
    for (std::size_t x = 0; x < 64; ++x) {
      Direction normal, viewer;
      const float* rgb = picture.radiance.pixel(x, y);
      if (!sphereAt(scene, x, y, normal, viewer)) {
        EXPECT_EQ(rgb[0], 0);
        continue;
      }
      const double cosine = std::max(0.0, dot(normal, light));
      const auto value = material->evaluate(inSphereFrame(normal, light), inSphereFrame(normal, viewer));
      for (std::size_t c = 0; c < 3; ++c) {
        const double expected = value[c] * cosine * double(2 + c);
        EXPECT_NEAR(double(rgb[c]), expected, 2e-6 * expected) << x << ", " << y;
        EXPECT_EQ(picture.standardError.pixel(x, y)[c], 0);
      }
      lit += cosine > 0;
    }
  EXPECT_GT(lit, 1000u);
}

TEST(Reference, APointLightFallsOffWithTheSquareOfTheDistance) {
  Scene scene;
  scene.materials = {parseMaterialExpression("0.5*Lambertian")};
  scene.objects.push_back({"floor", std::make_shared<const TriangleMesh>(makeSquare(20)), {}, 0});
  scene.lights.push_back({SceneLight::Kind::Point, {0.5, 2, -1}, {7, 7, 7}});
  scene.camera.position = {0, 5, 0};
  scene.camera.up = {0, 0, -1};
  scene.camera.viewAngle = 60;
  scene.width = scene.height = 16;
  ReferenceOptions options;
  options.samples = 2;
  options.pixelCentres = true;
  const ReferencePicture picture = renderReference(scene, options);
  for (std::size_t y = 0; y < 16; ++y)
    for (std::size_t x = 0; x < 16; ++x) {
      const double step = 2 * 5 * std::tan(radians(30)) / 16;
      const double px = (double(x) - 7.5) * step, pz = (double(y) - 7.5) * step;
      const double squared = (px - 0.5) * (px - 0.5) + 4 + (pz + 1) * (pz + 1);
      const double expected = 0.5 / kPi * 7 * (2 / std::sqrt(squared)) / squared;
      EXPECT_NEAR(double(picture.radiance.pixel(x, y)[0]), expected, 1e-5 * expected);
    }
}

TEST(Reference, AMapIsTheSumOverAllItsTexels) {
  Image sky(16, 8, 3);
  std::uint32_t state = 1;
  for (float& value : sky.values) {
    state = state * 1664525u + 1013904223u;
    value = float(state >> 8) * 0x1p-24f;
  }
  sky.pixel(5, 2)[0] = 40;  // a small bright source
  const auto material = parseMaterialExpression("(0.3,0.1,0.05)*Lambertian + 0.6*GGX(alpha=0.25)");
  Scene scene = sphereScene(material, 10);
  SceneEnvironment environment;
  environment.map = std::make_shared<const EnvironmentMap>(sky);
  environment.rotation = 30;
  scene.environment = environment;
  ReferenceOptions options;
  options.samples = 4096;
  options.pixelCentres = true;
  const ReferencePicture picture = renderReference(scene, options);

  // Midpoints on a fine grid over the sphere, each with the map's bilinear radiance after a turn by -30 degrees.
  constexpr std::size_t rows = 360, columns = 720;
  Scores scores;
  for (std::size_t y = 0; y < 10; y += 3)
    for (std::size_t x = 0; x < 10; x += 2) {
      Direction normal, viewer;
      if (!sphereAt(scene, x, y, normal, viewer)) continue;
      DirectionPairBuffer<double> pairs;
      std::vector<std::array<double, 3>> weights;
      for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns; ++i) {
          const double theta = kPi * (double(j) + 0.5) / rows, phi = 2 * kPi * (double(i) + 0.5) / columns;
          const Direction light{std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
          if (dot(light, normal) <= 0) continue;
          const double turn = radians(-30);  // about +y, counter-clockwise from above: x towards -z
          const Direction inMap{std::cos(turn) * light[0] + std::sin(turn) * light[2], light[1],
                                -std::sin(turn) * light[0] + std::cos(turn) * light[2]};
          auto weight = environment.map->radiance(inMap);
          for (double& w : weight) w *= dot(light, normal) * std::sin(theta) * (kPi / rows) * (2 * kPi / columns);
          pairs.push(inSphereFrame(normal, light), inSphereFrame(normal, viewer));
          weights.push_back(weight);
        }
      std::vector<double> values(3 * pairs.size());
      material->evaluate(pairs.view(), values.data(), nullptr);
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0;
        for (std::size_t k = 0; k < pairs.size(); ++k) sum += values[c * pairs.size() + k] * weights[k][c];
        scores.add(double(picture.radiance.pixel(x, y)[c]) - sum,
                   std::hypot(double(picture.standardError.pixel(x, y)[c]), 2e-4 * sum));
      }
    }
  EXPECT_GT(scores.count, 25u);
  EXPECT_LT(scores.mean(), 2.0);
  EXPECT_LT(scores.largest, 4.5);
}

TEST(Reference, WhiteThingsInAWhiteWorldAreInvisibleWhenLightMayBounce) {
  Scene scene = sphereScene(parseMaterialExpression("Lambertian"), 20);
  scene.objects.push_back({"other", nullptr, {0.5, Placement{}.axes, {1, 0.6, 0.8}}, 0});
  scene.objects.push_back(
      {"floor", std::make_shared<const TriangleMesh>(makeSquare(4)), {1, Placement{}.axes, {0, -1, 0}}, 0});
  scene.environment = constantLight(1);
  scene.background = {};  // the environment
  scene.camera.position = {0, 1.5, 4};
  ReferenceOptions options;
  options.samples = 256;
  options.bounces = 1000;
  const ReferencePicture bounced = renderReference(scene, options);
  Scores scores;
  for (std::size_t k = 0; k < bounced.radiance.values.size(); k += 3) {
    const double error = double(bounced.standardError.values[k]);
    if (error == 0)
      EXPECT_NEAR(bounced.radiance.values[k], 1, 1e-6);
    else
      scores.add(double(bounced.radiance.values[k]) - 1, error);
  }
  ASSERT_GT(scores.count, 100u);
  EXPECT_LT(scores.mean(), 1 + 4 * std::sqrt(2.0 / double(scores.count)));
  EXPECT_LT(scores.largest, 6);

  options.bounces = 1;
  const ReferencePicture direct = renderReference(scene, options);
  double total = 0, dark = 1;
  for (std::size_t k = 0; k < direct.radiance.values.size(); k += 3) {
    total += double(direct.radiance.values[k]);
    dark = std::min(dark, double(direct.radiance.values[k]));
  }
  EXPECT_LT(total, 0.97 * 400);  // where things hide each other from the light
  EXPECT_LT(dark, 0.6);
}

TEST(Reference, AnIntegratingSphereSumsItsBounces) {
  Scene scene = sphereScene(parseMaterialExpression("0.6*Lambertian"), 8);
  scene.objects[0].placement.scale = 3;
  scene.lights.push_back({SceneLight::Kind::Point, {0, 0, 0}, {9, 9, 9}});
  scene.camera.position = {0, 1, 1};
  scene.camera.target = {0, 0.5, -2};
  ReferenceOptions options;
  options.samples = 64;
  double expected = 0;
  for (std::size_t bounces = 1; bounces <= 4; ++bounces) {
    options.bounces = bounces;
    expected += std::pow(0.6, double(bounces)) / kPi;  // irradiance 9 / 3^2 = 1; each bounce reflects 0.6 of the last
    const ReferencePicture picture = renderReference(scene, options);
    double sum = 0, variance = 0;
    for (std::size_t k = 0; k < 64; ++k) {
      sum += double(picture.radiance.values[3 * k]);
      variance += double(picture.standardError.values[3 * k]) * double(picture.standardError.values[3 * k]);
    }
    EXPECT_NEAR(sum / 64, expected, 1e-6 + 4 * std::sqrt(variance) / 64) << bounces;
  }
}

TEST(Reference, TheErrorFallsWithTheRootOfTheSamples) {
  Scene scene = sphereScene(parseMaterialExpression("0.3*Lambertian + 0.7*GGX(alpha=0.2)"), 16);
  Image sky(32, 16, 3);
  for (std::size_t x = 0; x < 32; ++x)
    for (std::size_t y = 0; y < 16; ++y) std::fill_n(sky.pixel(x, y), 3, (x / 4 + y / 4) % 2 ? 1.5f : 0.1f);
  scene.environment = SceneEnvironment{std::make_shared<const EnvironmentMap>(sky), 0, 1};
  ReferenceOptions options;
  options.pixelCentres = true;
  options.samples = 1 << 15;
  options.seed = 77;
  const Image truth = renderReference(scene, options).radiance;
  // log2 of the root mean square difference against log2 of the samples: a straight line of slope -1/2.
  double sx = 0, sy = 0, sxx = 0, sxy = 0, n = 0;
  for (std::size_t level = 4; level <= 11; ++level) {
    options.samples = std::size_t{1} << level;
    options.seed = 1;
    const ReferencePicture picture = renderReference(scene, options);
    double squares = 0, claimed = 0;
    for (std::size_t k = 0; k < truth.values.size(); ++k) {
      squares += std::pow(double(picture.radiance.values[k]) - double(truth.values[k]), 2);
      claimed += std::pow(double(picture.standardError.values[k]), 2);
    }
    EXPECT_NEAR(std::sqrt(squares / claimed), 1, 0.25) << options.samples;
    const double x = double(level), y = std::log2(squares) / 2;
    sx += x, sy += y, sxx += x * x, sxy += x * y, n += 1;
  }
  // About 140 lit pixels a level: the spread of log2(rms) is near 0.06, of the slope over 8 levels near 0.01.
  EXPECT_NEAR((n * sxy - sx * sy) / (n * sxx - sx * sx), -0.5, 0.05);
}

}  // namespace
