#include "../TestFolder.h"

#include <brdf/base/Error.h>
#include <brdf/io/EnvironmentMap.h>
#include <brdf/io/EnvironmentSampler.h>
#include <brdf/io/ImageFile.h>
#include <brdf/sampling/Sequence.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using brdf::Direction;
using brdf::EnvironmentMap;
using brdf::Image;
using brdf::OctahedralMap;

namespace {

constexpr double kPi = brdf::kPi;

EnvironmentMap shipped(const std::string& name) {
  return EnvironmentMap::read(std::filesystem::path(BRDF_SOURCE_DIR) / "datasets/environments" / (name + ".exr"));
}

}  // namespace

TEST(EnvironmentMap, ConstantRadianceHasPowerFourPiAndIrradiancePi) {
  const EnvironmentMap map = EnvironmentMap::constant({1, 2, 0.5});
  EXPECT_NEAR(map.totalPower()[0], 4 * kPi, 1e-6);
  EXPECT_NEAR(map.totalPower()[1], 8 * kPi, 1e-6);
  EXPECT_NEAR(map.irradiance({0, 1, 0})[0], kPi, 1e-3);
}

TEST(EnvironmentMap, OrientationIsAsDocumented) {
  Image picture(64, 32, 3);
  const auto mark = [&](std::size_t x, std::size_t y, std::size_t channel) { picture.pixel(x, y)[channel] = 1; };
  mark(32, 16, 0);                                     // just right of and below the middle: -z
  mark(48, 16, 1);                                     // three quarters: +x
  for (std::size_t x = 0; x < 64; ++x) mark(x, 0, 2);  // zenith
  const EnvironmentMap map(picture);
  EXPECT_GT(map.radiance({0, 0, -1})[0], 0.2);
  EXPECT_GT(map.radiance({1, 0, 0})[1], 0.2);
  EXPECT_NEAR(map.radiance({0, 1, 0})[2], 1, 1e-6);
  EXPECT_EQ(map.radiance({0, -1, 0})[2], 0);
  const Direction d = map.direction(48, 16);
  EXPECT_GT(d[0], 0.99);
  EXPECT_NEAR(map.radiance(d)[1], 1, 1e-6) << "the centre of a texel has its value";
}

TEST(EnvironmentMap, SolidAnglesAddUpToTheSphere) {
  const EnvironmentMap map(Image(128, 64, 1));
  double sum = 0;
  for (std::size_t row = 0; row < 64; ++row) sum += 128 * map.solidAngle(row);
  EXPECT_NEAR(sum, 4 * kPi, 1e-12);
  for (std::size_t n : {1u, 2u, 16u}) {
    sum = 0;
    for (std::size_t row = 0; row < n; ++row)
      for (std::size_t column = 0; column < n; ++column) sum += OctahedralMap::solidAngle(n, column, row);
    EXPECT_NEAR(sum, 4 * kPi, 1e-12) << n;
  }
}

TEST(EnvironmentMap, ASmallTexelsSolidAngleIsItsAreaTimesTheCubedSumOfCoordinates) {
  constexpr std::size_t n = 512;
  for (std::size_t column : {3u, 100u, 255u, 300u, 511u})
    for (std::size_t row : {0u, 77u, 256u, 450u}) {
      const Direction d = OctahedralMap::direction((double(column) + 0.5) / n, (double(row) + 0.5) / n);
      const double norm = std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]);
      EXPECT_NEAR(OctahedralMap::solidAngle(n, column, row) / (4.0 / (n * n) * norm * norm * norm), 1, 2e-2);
    }
}

TEST(EnvironmentMap, TheOctahedralProjectionIsInverted) {
  for (double u : {0.01, 0.3, 0.5, 0.77, 0.99})
    for (double v : {0.02, 0.25, 0.6, 0.98}) {
      const auto back = OctahedralMap::project(OctahedralMap::direction(u, v));
      EXPECT_NEAR(back[0], u, 1e-12);
      EXPECT_NEAR(back[1], v, 1e-12);
    }
  EXPECT_NEAR(OctahedralMap::direction(0.5, 0.5)[1], 1, 1e-12);
  EXPECT_NEAR(OctahedralMap::direction(1, 0.5)[0], 1, 1e-12);
  EXPECT_NEAR(OctahedralMap::direction(0.5, 1)[2], 1, 1e-12);
  EXPECT_NEAR(OctahedralMap::direction(0, 0)[1], -1, 1e-12);
}

TEST(EnvironmentMap, ImpossibleValuesAreZeroAndCounted) {
  Image picture(4, 2, 1);
  picture.values = {1, -1, std::numeric_limits<float>::infinity(), std::nanf(""), 0, 0, 0, 0};
  const EnvironmentMap map(picture);
  EXPECT_EQ(map.defects().negative, 1u);
  EXPECT_EQ(map.defects().notFinite, 2u);
  EXPECT_EQ(map.picture().pixel(0, 0)[2], 1.0f);
  EXPECT_EQ(map.picture().pixel(2, 0)[0], 0.0f);
}

TEST(EnvironmentMap, APictureOfAnotherShapeIsRefused) {
  EXPECT_THROW(EnvironmentMap{Image(64, 64, 3)}, brdf::Error);
  EXPECT_THROW(EnvironmentMap{Image()}, brdf::Error);
}

TEST(EnvironmentMap, EveryLevelOfTheRadianceMapHasThePowerOfThePicture) {
  for (const char* name : {"studio", "sunset", "venice"}) {
    const EnvironmentMap map = shipped(name);
    EXPECT_EQ(map.mapSize(), 512u);
    const auto power = map.totalPower();
    for (std::size_t size : {128u, 512u}) {
      const OctahedralMap radiance = map.radianceMap(size);
      EXPECT_EQ(radiance.levels(), size == 128 ? 8u : 10u);
      for (std::size_t level = 0; level < radiance.levels(); ++level)
        for (std::size_t channel = 0; channel < 3; ++channel)
          EXPECT_NEAR(radiance.totalPower(level)[channel] / power[channel], 1, 1e-3)
              << name << ' ' << size << ' ' << level;
    }
  }
}

TEST(EnvironmentMap, TheRadianceMapShowsThePictureInEveryDirection) {
  Image picture(256, 128, 3);  // smooth: radiance = 2 + direction
  const EnvironmentMap frame(picture);
  for (std::size_t y = 0; y < 128; ++y)
    for (std::size_t x = 0; x < 256; ++x)
      for (std::size_t channel = 0; channel < 3; ++channel)
        picture.pixel(x, y)[channel] = static_cast<float>(2 + frame.direction(x, y)[channel]);
  const EnvironmentMap map(picture);
  const OctahedralMap radiance = map.radianceMap(64);
  // Everywhere, borders and folds included: directions of a spiral, and those next to axes and folds.
  for (int i = 0; i < 2000; ++i) {
    const double y = 1 - 2 * (i + 0.5) / 2000, r = std::sqrt(1 - y * y), phi = 2.399963 * i;
    const Direction d{r * std::cos(phi), y, r * std::sin(phi)};
    for (std::size_t channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(radiance.radiance(d, 0)[channel], 2 + d[channel], 0.02) << d[0] << ' ' << d[1] << ' ' << d[2];
      EXPECT_NEAR(radiance.radiance(d, 2)[channel], 2 + d[channel], 0.08);
    }
  }
}

TEST(EnvironmentMap, TheDiffuseMapIsTheCosineConvolution) {
  for (const char* name : {"studio", "sunset", "venice"}) {
    const EnvironmentMap map = shipped(name);
    const Image diffuse = map.diffuseMap();
    const auto interpolated = [&](double phi, double theta, std::size_t channel) {
      const double x = (phi + kPi) / (2 * kPi) * 128, y = theta / kPi * 64, fx = x - std::floor(x),
                   fy = y - std::floor(y);
      const auto at = [&](double column, double row) {
        return double(diffuse.pixel(std::size_t(column) % 128, std::min<std::size_t>(std::size_t(row), 64))[channel]);
      };
      return (at(x, y) * (1 - fx) + at(x + 1, y) * fx) * (1 - fy) +
             (at(x, y + 1) * (1 - fx) + at(x + 1, y + 1) * fx) * fy;
    };
    double largest = 0, worst = 0;
    for (int i = 0; i < 150; ++i) {
      const double theta = std::acos(1 - 2 * (i + 0.5) / 150), phi = std::remainder(2.399963 * i, 2 * kPi);
      const Direction n{std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
      const auto exact = map.irradiance(n);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        largest = std::max(largest, exact[channel] / kPi);
        worst = std::max(worst, std::abs(interpolated(phi, theta, channel) - exact[channel] / kPi));
      }
    }
    RecordProperty(name, std::to_string(worst / largest));
    EXPECT_LT(worst / largest, 2e-3) << name;
  }
}

TEST(EnvironmentSampler, DensityIntegratesToOneAndFollowsTheInterpolatedLuminance) {
  const EnvironmentMap map = shipped("venice");
  const brdf::EnvironmentSampler sampler(map);
  // The mean of what is seen over a texel: a sum over 8 x 8 places in it, exact for a linear function.
  const auto seen = [&](std::size_t column, std::size_t row) {
    double sum = 0;
    for (int place = 0; place < 64; ++place) {
      const double phi = 2 * kPi * ((double(column) + (place % 8 + 0.5) / 8) / 512 - 0.5);
      const double theta = kPi * (double(row) + (place / 8 + 0.5) / 8) / 256;
      const auto rgb =
          map.radiance({std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)});
      sum += (0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]) / 64;
    }
    return sum;
  };
  double sum = 0, total = 0;
  for (std::size_t row = 0; row < map.height(); ++row)
    for (std::size_t column = 0; column < map.width(); ++column) {
      total += map.solidAngle(row) * seen(column, row);
      sum += map.solidAngle(row) * sampler.pdf(map.direction(column, row));
    }
  EXPECT_NEAR(sum, 1, 1e-9);
  for (const auto& [column, row] : {std::pair{100, 90}, {0, 100}, {511, 7}, {37, 0}, {300, 255}}) {
    const auto x = static_cast<std::size_t>(column), y = static_cast<std::size_t>(row);
    const double density = sampler.pdf(map.direction(x, y));
    EXPECT_NEAR(density, seen(x, y) / total, 1e-9 * density) << column << ' ' << row;
  }
}

TEST(EnvironmentSampler, NoLightIsMissedAroundASingleTexel) {
  // Interpolation spreads one texel over its eight neighbours: whatever has light is drawn, with a bounded weight.
  brdf::Image picture(64, 32, 3);
  std::fill_n(picture.pixel(20, 9), 3, 1000.0f);
  std::fill_n(picture.pixel(5, 0), 3, 1000.0f);
  const EnvironmentMap map(picture);
  const brdf::EnvironmentSampler sampler(map);
  double estimate = 0, largest = 0, exact = 0;
  constexpr std::size_t count = 1 << 20;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [u, v] = brdf::r2(i, 0, 0);
    const Direction d = sampler.sample(u, v);
    const double weight = map.radiance(d)[0] / sampler.pdf(d);
    estimate += weight / double(count);
    largest = std::max(largest, weight);
  }
  constexpr int fine = 32;  // places along each side of a texel
  for (int y = 0; y < 32 * fine; ++y)
    for (int x = 0; x < 64 * fine; ++x) {
      const double phi = 2 * kPi * ((x + 0.5) / (64 * fine) - 0.5), theta = kPi * (y + 0.5) / (32 * fine);
      const Direction d{std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
      exact += map.radiance(d)[0] * std::sin(theta) * 2 * kPi / (64 * fine) * kPi / (32 * fine);
    }
  EXPECT_NEAR(estimate, exact, 1e-3 * exact);
  // In the corner that touches a bright texel its diagonal neighbour sees 1/4 where it sees 1/64 in the mean.
  EXPECT_LT(largest, 16.5 * exact);
}

TEST(EnvironmentSampler, SamplesEstimateTheIrradiance) {
  const EnvironmentMap map = shipped("sunset");
  const brdf::EnvironmentSampler sampler(map);
  const Direction normal = brdf::normalized({0.3, 0.8, -0.5});
  double sum = 0, squares = 0;
  constexpr int side = 300;
  for (int i = 0; i < side * side; ++i) {
    const Direction d = sampler.sample((i % side + 0.5) / side, (i / side + 0.5) / side);
    const double value = std::max(0.0, brdf::dot(d, normal)) * map.radiance(d)[1] / sampler.pdf(d);
    sum += value;
    squares += value * value;
  }
  const double count = side * side, mean = sum / count, deviation = std::sqrt((squares / count - mean * mean) / count);
  // The map's irradiance takes texels for constant: 1e-3 apart from interpolation at this resolution.
  const double expected = map.irradiance(normal)[1];
  EXPECT_NEAR(mean, expected, 4 * deviation + 1e-3 * expected);
}

TEST(EnvironmentSampler, ABlackMapIsDrawnFromUniformly) {
  const brdf::EnvironmentSampler sampler(EnvironmentMap::constant({0, 0, 0}));
  EXPECT_NEAR(sampler.pdf(brdf::normalized({0.1, 0.9, 0.3})), 1 / (4 * kPi), 1e-9);
}

TEST(OctahedralMap, FootprintsHoldTheFourTexelsOfABilinearLookUp) {
  // Colours over nine decades, some of them 0, as maps with a sun have.
  constexpr std::size_t size = 16;
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<float> texels(3 * size * size);
  for (float& value : texels) value = uniform(random) < 0.1f ? 0 : std::pow(10.0f, 9 * uniform(random) - 4);
  const OctahedralMap map(size, texels);
  const OctahedralMap::Footprints footprints = map.footprints();
  std::size_t row = 0;  // of the footprints: levels below each other
  for (std::size_t level = 0; level < map.levels(); ++level) {
    const auto n = std::ptrdiff_t(size >> level);
    EXPECT_EQ(row, 2 * (size - (size >> level)) + level);
    for (std::ptrdiff_t y = 0; y <= n; ++y, ++row)
      for (std::ptrdiff_t x = 0; x <= n; ++x)
        for (std::ptrdiff_t k = 0; k < 4; ++k) {
          const std::uint32_t word = footprints.words.at(4 * (row * (size + 1) + std::size_t(x)) + std::size_t(k));
          const float* colour = map.texel(level, x - 1 + k % 2, y - 1 + k / 2);
          const float largest = std::max({colour[0], colour[1], colour[2]});
          for (std::size_t channel = 0; channel < 3; ++channel) {
            const double found =
                double(word >> (9 * channel) & 511u) * std::exp2(double(word >> 27) - 31) * double(footprints.unit);
            ASSERT_NEAR(found, double(colour[channel]), double(largest) / 256 + double(footprints.unit) * 0x1p-31);
          }
        }
  }
  EXPECT_EQ(footprints.words.size(), 4 * row * (size + 1));
  const OctahedralMap::Footprints even = OctahedralMap(size, std::vector<float>(3 * size * size, 1.0f)).footprints();
  const std::uint32_t word = even.words[4 * ((size + 1) * 3 + 3)];
  EXPECT_EQ(double(word & 511u) * std::exp2(double(word >> 27) - 31) * double(even.unit), 1.0);
  // A value between two steps: right in the mean.
  constexpr float between = 1.0f + 0.3f / 256;
  const OctahedralMap::Footprints dithered =
      OctahedralMap(size, std::vector<float>(3 * size * size, between)).footprints();
  double sum = 0;
  for (std::size_t y = 0; y < size; ++y)
    for (std::size_t x = 0; x < size; ++x) {
      const std::uint32_t at = dithered.words[4 * ((size + 1) * y + x)];
      sum += double(at & 511u) * std::exp2(double(at >> 27) - 31) * double(dithered.unit);
    }
  EXPECT_NEAR(sum / (size * size), double(between), 0.02 / 256);
}

// Light probes, made from a function of the direction by the inverse of Debevec's formula: theta = pi r from +z.
namespace {

brdf::Image lightProbe(std::size_t side, const auto& radiance) {
  brdf::Image probe(side, side, 3);
  std::fill(probe.values.begin(), probe.values.end(), 1e6f);  // outside the circle: must not be seen
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) {
      const double u = 2 * (double(x) + 0.5) / double(side) - 1, v = 1 - 2 * (double(y) + 0.5) / double(side);
      const double r = std::sqrt(u * u + v * v), theta = kPi * r;
      if (r > 1) continue;
      const auto rgb = radiance(Direction{std::sin(theta) * u / r, std::sin(theta) * v / r, std::cos(theta)});
      for (std::size_t c = 0; c < 3; ++c) probe.pixel(x, y)[c] = static_cast<float>(rgb[c]);
    }
  return probe;
}

Direction scattered(std::size_t i) {
  const auto [u, v] = brdf::r2(i, 0, 0);
  const double z = 1 - 2 * u, s = std::sqrt(1 - z * z);
  return {s * std::cos(2 * kPi * v), s * std::sin(2 * kPi * v), z};
}

}  // namespace

TEST(AngularMap, EveryDirectionIsSeenWhereTheFormulaPutsIt) {
  const auto light = [](const Direction& d) {
    return EnvironmentMap::Rgb{2 + d[0], 2 + d[1], 2 + d[2] + 0.5 * std::sin(5 * d[0] + 3 * d[1])};
  };
  const EnvironmentMap map = EnvironmentMap::fromAngular(lightProbe(512, light));
  EXPECT_EQ(map.width(), 1024u);
  for (std::size_t i = 0; i < 5000; ++i) {
    const Direction d = scattered(i);
    // Pixels of 0.7 degrees; a degree around the rim is stretched over the circumference.
    const double margin = d[2] < -0.9998 ? 0.03 : 0.002;
    const auto found = map.radiance(d), expected = light(d);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(found[c], expected[c], margin) << d[0] << ' ' << d[1] << ' ' << d[2];
  }
}

TEST(AngularMap, TheCentreIsTowardsTheCameraAndTheRimBehindTheBall) {
  // A camera on +z looks at the ball: its right is +x, up is +y. A quarter of the width is a right angle.
  brdf::Image probe(256, 256, 3);
  const auto paint = [&](std::size_t x, std::size_t y, std::size_t channel) {
    for (std::size_t j = y - 4; j < y + 4; ++j)
      for (std::size_t i = x - 4; i < x + 4; ++i) probe.pixel(i, j)[channel] = 1;
  };
  paint(128, 128, 0);
  paint(192, 128, 1);
  paint(128, 64, 2);
  const EnvironmentMap map = EnvironmentMap::fromAngular(probe);
  EXPECT_NEAR(map.radiance({0, 0, 1})[0], 1, 1e-6);
  EXPECT_NEAR(map.radiance({1, 0, 0})[1], 1, 1e-6);
  EXPECT_NEAR(map.radiance({0, 1, 0})[2], 1, 1e-6);
  for (const Direction& d : {Direction{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}})
    EXPECT_EQ(map.radiance(d), (EnvironmentMap::Rgb{0, 0, 0}));
}

TEST(AngularMap, ItsPowerIsThatOfThePixelsSolidAngles) {
  // A pixel of an angular map has the solid angle (2 pi / side)^2 sin(theta) / theta.
  const brdf::Image probe = lightProbe(400, [](const Direction& d) {
    return EnvironmentMap::Rgb{1 + d[0] * d[1], 1 + d[2] * d[2], std::exp(d[2])};
  });
  EnvironmentMap::Rgb power{};
  for (std::size_t y = 0; y < 400; ++y)
    for (std::size_t x = 0; x < 400; ++x) {
      const double theta = kPi * std::hypot((double(x) + 0.5) / 200 - 1, (double(y) + 0.5) / 200 - 1);
      if (theta > kPi) continue;
      for (std::size_t c = 0; c < 3; ++c)
        power[c] += double(probe.pixel(x, y)[c]) * std::pow(2 * kPi / 400, 2) * std::sin(theta) / theta;
    }
  const auto found = EnvironmentMap::fromAngular(probe).totalPower();
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], power[c], 1e-3 * power[c]);
}

TEST(AngularMap, AShippedMapSurvivesTheWayThereAndBack) {
  const EnvironmentMap map = shipped("venice");
  const auto probe = lightProbe(1024, [&](const Direction& d) { return map.radiance(d); });
  const auto file = testFolder("maps") / "probe.exr";
  brdf::writeExr(probe, file);
  const EnvironmentMap back = EnvironmentMap::read(file, EnvironmentMap::mapping("angular"));
  double difference = 0, square = 0;
  for (std::size_t i = 0; i < 20000; ++i) {
    const Direction d = scattered(i);
    const auto found = back.radiance(d), expected = map.radiance(d);
    for (std::size_t c = 0; c < 3; ++c) {
      difference += std::pow(found[c] - expected[c], 2);
      square += expected[c] * expected[c];
    }
  }
  EXPECT_LT(std::sqrt(difference / square), 0.05);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(back.totalPower()[c], map.totalPower()[c], 5e-3 * map.totalPower()[c]);
}

TEST(AngularMap, ASquarePictureTakenForEquirectangularIsAnErrorThatNamesTheOption) {
  const auto file = testFolder("maps") / "square.exr";
  brdf::writeExr(brdf::Image(64, 64, 3), file);
  try {
    EnvironmentMap::read(file);
    FAIL();
  } catch (const brdf::Error& error) {
    EXPECT_NE(std::string(error.what()).find("square.exr"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("angular:FILE"), std::string::npos) << error.what();
  }
  EXPECT_THROW(EnvironmentMap::fromAngular(brdf::Image(64, 32, 3)), brdf::Error);
  EXPECT_THROW(EnvironmentMap::fromAngular(brdf::Image()), brdf::Error);
  EXPECT_THROW(EnvironmentMap::mapping("mirror"), brdf::Error);
  for (const std::size_t side : {1, 2, 3}) {  // degenerate, but there is light in the circle
    brdf::Image tiny(side, side, 1);
    std::fill(tiny.values.begin(), tiny.values.end(), 1.0f);
    EXPECT_NEAR(EnvironmentMap::fromAngular(tiny).radiance({0.6, 0, -0.8})[2], 1, 1e-6) << side;
  }
}
