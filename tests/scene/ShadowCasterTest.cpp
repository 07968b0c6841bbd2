// Shadow masks against closed forms: what a sphere or a wall hides.
#include <brdf/base/Error.h>
#include <brdf/io/OctahedralMap.h>
#include <brdf/render/Lens.h>
#include <brdf/render/ShadowCaster.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace {

using namespace brdf;

constexpr std::size_t kSide = 24;

/// A floor of side 2 seen from above through kSide x kSide pixels, a ball of radius 0.3 hovering at height 0.5.
Scene hovering() {
  Scene scene;
  SceneObject floor{"floor", std::make_shared<const TriangleMesh>(makeSquare(2)), {}, 0};
  SceneObject ball{"ball", nullptr, {}, 0};
  ball.placement.scale = 0.3;
  ball.placement.shift = {0, 0.5, 0};
  scene.objects = {floor, ball};
  return scene;
}

/// Straight down, below the ball.
Ray fromBelowTheBall(double x, double y) { return {{2 * x / kSide - 1, 0.15, 1 - 2 * y / kSide}, {0, -1, 0}}; }

ShadowMask cast(const Scene& scene, std::size_t cells, std::uint64_t seed) {
  ShadowOptions options;
  options.width = options.height = kSide;
  options.seed = seed;
  options.through = fromBelowTheBall;
  ShadowMask mask;
  ShadowCaster(scene, cells).cast(options, mask);
  return mask;
}

bool seen(const ShadowMask& mask, std::size_t pixel, std::size_t cell) {
  const std::size_t word = ((1 + cell / 128) * kSide * kSide + pixel) * 4 + cell / 32 % 4;
  return mask.words[word] >> cell % 32 & 1;
}

}  // namespace

TEST(ShadowCaster, LightsAreHiddenByWhatLiesBetween) {
  Scene scene = hovering();
  const Direction beam = normalized(Direction{0.5, 1, 0});
  scene.lights = {{SceneLight::Kind::Directional, beam, {1, 1, 1}},
                  {SceneLight::Kind::Point, {0, 1, 0}, {1, 1, 1}},
                  {SceneLight::Kind::Point, {0.02, 0.1, 0}, {1, 1, 1}}};  // below the ball
  const ShadowMask mask = cast(scene, 0, 0);
  EXPECT_EQ(mask.layers, 1u);
  std::size_t shadowed = 0;
  for (std::size_t k = 0; k < kSide * kSide; ++k) {
    const Ray ray = fromBelowTheBall(double(k % kSide) + 0.5, double(k / kSide) + 0.5);
    const double x = ray.origin[0], z = ray.origin[2];
    const std::uint32_t bits = mask.words[4 * k];
    // The distance of the ball's centre from the way to the light: its part across the beam.
    const Position to{-x, 0.5, -z};
    const double across = std::sqrt(dot(to, to) - std::pow(dot(to, beam), 2));
    EXPECT_EQ(bits & 1, across < 0.3 ? 0u : 1u) << k;
    const Direction up = normalized(Direction{-x, 1, -z});
    const double fromPoint = std::sqrt(dot(to, to) - std::pow(dot(to, up), 2));
    EXPECT_EQ(bits >> 1 & 1, fromPoint < 0.3 ? 0u : 1u) << k;
    EXPECT_EQ(bits >> 2 & 1, 1u) << k;
    shadowed += across < 0.3;
  }
  EXPECT_GT(shadowed, 20u);
}

TEST(ShadowCaster, ABallHidesItsSolidAngleOfTheSky) {
  Scene scene = hovering();
  scene.environment =
      SceneEnvironment{std::make_shared<const EnvironmentMap>(EnvironmentMap::constant({1, 1, 1})), 0, 1};
  constexpr std::size_t cells = 16, seeds = 16;
  const std::size_t middle = kSide / 2 * kSide + kSide / 2;
  const Ray ray = fromBelowTheBall(double(kSide / 2) + 0.5, double(kSide / 2) + 0.5);
  double hidden = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const ShadowMask mask = cast(scene, cells, seed);
    for (std::size_t cell = 0; cell < cells * cells; ++cell) {
      const Direction d =
          OctahedralMap::direction((double(cell % cells) + 0.5) / cells, (double(cell / cells) + 0.5) / cells);
      if (d[1] > 0.2 && !seen(mask, middle, cell))
        hidden += OctahedralMap::solidAngle(cells, cell % cells, cell / cells);
      if (d[1] < -0.2) {
        EXPECT_FALSE(seen(mask, middle, cell)) << "below the floor";
      }
    }
  }
  // A cone of half angle asin(radius / distance), far above the horizon.
  const double distance = std::sqrt(ray.origin[0] * ray.origin[0] + 0.25 + ray.origin[2] * ray.origin[2]);
  const double solid = 2 * kPi * (1 - std::sqrt(1 - std::pow(0.3 / distance, 2)));
  // The cone's edge runs through about 16 cells of 0.05 sr, of which each is a coin thrown once a seed.
  EXPECT_NEAR(hidden / seeds, solid, 4 * 0.05 * std::sqrt(16 * 0.25 / seeds));
}

TEST(ShadowCaster, ALampIsHiddenWhereItStandsNotWhereItsCellIs) {
  // One bright texel in a dark sky, and the map turned: visibility follows the lamp across the cell.
  Scene scene = hovering();
  Image sky(256, 128, 3);
  std::ranges::fill(sky.values, 1e-6f);
  for (std::size_t c = 0; c < 3; ++c) sky.pixel(70, 30)[c] = 1000;
  const auto map = std::make_shared<const EnvironmentMap>(sky);
  scene.environment = SceneEnvironment{map, 50, 1};
  const Direction inMap = map->direction(70, 30);
  const double c = std::cos(radians(50)), s = std::sin(radians(50));
  const Direction lamp{c * inMap[0] + s * inMap[2], inMap[1], -s * inMap[0] + c * inMap[2]};
  constexpr std::size_t cells = 8;
  const auto [u, v] = OctahedralMap::project(inMap);
  const std::size_t cell = cells * static_cast<std::size_t>(v * cells) + static_cast<std::size_t>(u * cells);
  const ShadowMask mask = cast(scene, cells, 3);
  std::size_t checked = 0;
  for (std::size_t k = 0; k < kSide * kSide; ++k) {
    const Ray ray = fromBelowTheBall(double(k % kSide) + 0.5, double(k / kSide) + 0.5);
    const Position to{-ray.origin[0], 0.5, -ray.origin[2]};
    if (dot(to, lamp) <= 0) continue;
    const double across = std::sqrt(dot(to, to) - std::pow(dot(to, lamp), 2));
    if (std::abs(across - 0.3) < 0.04) continue;  // within the width of the map's texels
    EXPECT_EQ(seen(mask, k, cell), across > 0.3) << k;
    checked += across < 0.3;
  }
  EXPECT_GT(checked, 10u);
}

TEST(ShadowCaster, CellsAndLightsAreBounded) {
  Scene scene = hovering();
  EXPECT_THROW(ShadowCaster(scene, 12), Error);
  EXPECT_THROW(ShadowCaster(scene, 128), Error);
  scene.lights.resize(33);
  EXPECT_THROW(ShadowCaster(scene, 0), Error);
}
