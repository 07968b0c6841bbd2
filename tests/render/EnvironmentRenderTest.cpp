// Environment light: furnaces against quadrature, real maps against the sum over every texel, orientation.
#include "../TestFolder.h"
#include "RenderScene.h"

#include <brdf/io/ImageFile.h>

#include <filesystem>

namespace {

using brdf::Direction;
using rendertest::Render;
using rendertest::Rgb;

/// Reflected radiance by the sum over all texels of a map (not rotated), each of constant radiance.
Rgb summed(const brdf::EnvironmentMap& map, const brdf::LobeSum& material, const auto& hit) {
  brdf::DirectionPairBuffer<double> pairs;
  std::vector<double> weights;
  std::vector<const float*> texels;
  for (std::size_t row = 0; row < map.height(); ++row)
    for (std::size_t column = 0; column < map.width(); ++column) {
      const Direction wi = hit.local(map.direction(column, row));
      if (wi[2] <= 0) continue;
      weights.push_back(map.solidAngle(row) * wi[2]);
      texels.push_back(map.picture().pixel(column, row));
      pairs.push(wi, hit.wo);
    }
  std::vector<double> values(pairs.size() * material.channels().count());
  material.evaluateParallel(pairs.view(), values.data(), nullptr);
  Rgb sum{};
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const std::size_t from = material.channels().count() == 1 ? 0 : channel;
      sum[channel] += values[from * pairs.size() + i] * weights[i] * double(texels[i][channel]);
    }
  return sum;
}

}  // namespace

TEST_F(Render, LambertianInAWhiteFurnaceIsItsAlbedo) {
  render_->SetEnvironment(environment_);
  draw("(0.5,0.25,1)*Lambertian");
  int seen = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto hit = this->hit(x, y);
      if (hit && hit->wo[2] < 0.05) continue;  // the silhouette
      const Rgb rgb = pixel(x, y);
      EXPECT_NEAR(rgb[0], hit ? 0.5 : 1, 1e-4);
      // The furnace's irradiance is a sum over blocks of the map: relative error 1e-4.
      EXPECT_NEAR(rgb[1], hit ? 0.25 : 1, 1e-4);
      EXPECT_NEAR(rgb[2], 1, 2e-4);
      seen += hit.has_value();
    }
  EXPECT_GT(seen, 2000);
}

TEST_F(Render, GgxInAWhiteFurnaceIsItsDirectionalAlbedo) {
  render_->SetEnvironment(environment_);
  render_->SetNumberOfSamples(4096);
  render_->SetSize(24, 24);
  const auto quadrature = rendertest::cosineQuadrature(300);
  for (const char* alpha : {"0.15", "0.3", "0.7"}) {
    draw(std::string("GGX(alpha=") + alpha + ", ior=1.5)");
    for (int x : {12, 15, 18, 20, 21}) {
      const auto hit = this->hit(x, 12);
      ASSERT_TRUE(hit);
      brdf::DirectionPairBuffer<double> pairs;
      for (const Direction& wi : quadrature.directions) pairs.push(wi, hit->wo);
      std::vector<double> values(pairs.size());
      material_->evaluateParallel(pairs.view(), values.data(), nullptr);
      double albedo = 0;
      for (std::size_t i = 0; i < values.size(); ++i) albedo += values[i] * quadrature.weights[i];
      EXPECT_NEAR(pixel(x, 12)[0], albedo, 5e-3 * albedo) << alpha << " at cosine " << hit->wo[2];
    }
  }
}

TEST_F(Render, LambertianUnderAMapIsTheSumOverItsTexels) {
  for (const char* name : {"venice", "studio", "sunset"}) {
    ASSERT_TRUE(environment_->ReadFile(rendertest::shippedMap(name)));
    render_->SetEnvironment(environment_);
    draw("Lambertian");
    double largest = 0, worst = 0;
    for (int y = 10; y < 64; y += 11)
      for (int x = 10; x < 64; x += 11) {
        const auto hit = this->hit(x, y);
        if (!hit || hit->wo[2] < 0.2) continue;
        const Rgb expected = summed(environment_->GetMap(), *material_, *hit), found = pixel(x, y);
        for (std::size_t channel = 0; channel < 3; ++channel) {
          largest = std::max(largest, expected[channel]);
          worst = std::max(worst, std::abs(found[channel] - expected[channel]));
        }
      }
    EXPECT_LT(worst, 3e-3 * largest) << name;
  }
}

TEST_F(Render, GlossyLobesUnderAMapNearTheSumOverItsTexels) {
  // Relative to the brightest pixel; the samples' filter blurs by less the more there are.
  struct Case {
    const char* material;
    int samples;
    double tolerance;
  };
  render_->SetEnvironment(environment_);
  render_->SetSize(24, 24);
  for (const char* name : {"venice", "sunset"}) {
    ASSERT_TRUE(environment_->ReadFile(rendertest::shippedMap(name)));
    for (const Case& test : {Case{"GGX(alpha=0.5, ior=5)", 4096, 0.002}, Case{"GGX(alpha=0.2, ior=5)", 4096, 0.002},
                             Case{"GGX(alpha=0.5, ior=5)", 64, 0.05}, Case{"GGX(alpha=0.2, ior=5)", 64, 0.05},
                             Case{"(0.2,0.3,0.4)*Lambertian + 0.5*GGX(alpha=(0.2,0.3,0.5), ior=2)", 4096, 0.002}}) {
      render_->SetNumberOfSamples(test.samples);
      draw(test.material);
      double largest = 0, worst = 0;
      for (int y = 3; y < 24; y += 4)
        for (int x = 3; x < 24; x += 4) {
          const auto hit = this->hit(x, y);
          if (!hit || hit->wo[2] < 0.3) continue;
          const Rgb expected = summed(environment_->GetMap(), *material_, *hit), found = pixel(x, y);
          for (std::size_t channel = 0; channel < 3; ++channel) {
            largest = std::max(largest, expected[channel]);
            worst = std::max(worst, std::abs(found[channel] - expected[channel]));
          }
        }
      RecordProperty(std::string(name) + ' ' + test.material + ' ' + std::to_string(test.samples),
                     std::to_string(worst / largest));
      EXPECT_LT(worst, test.tolerance * largest) << name << ' ' << test.material << ' ' << test.samples;
    }
  }
}

TEST_F(Render, BackgroundAndReflectionShowTheMapUprightTurnedAndNotMirrored) {
  // A smooth map: red grows to +x, green to +y, blue to +z.
  brdf::Image picture(256, 128, 3);
  const brdf::EnvironmentMap frame(picture);
  for (std::size_t y = 0; y < 128; ++y)
    for (std::size_t x = 0; x < 256; ++x)
      for (std::size_t axis = 0; axis < 3; ++axis)
        picture.pixel(x, y)[axis] = static_cast<float>(2 + frame.direction(x, y)[axis]);
  const std::string file = (testFolder("environment") / "axes.exr").string();
  brdf::writeExr(picture, file);
  ASSERT_TRUE(environment_->ReadFile(file));
  render_->SetEnvironment(environment_);
  render_->SetNumberOfSamples(256);
  render_->SetSize(96, 64);
  const auto seen = [&](const Direction& d) {
    Rgb rgb;
    environment_->GetRadiance(d.data(), rgb.data());
    return rgb;
  };
  for (double rotation : {0.0, 70.0}) {
    environment_->SetRotation(rotation);
    render_->SetAzimuth(25);
    render_->SetElevation(15);
    draw("GGXConductor(alpha=0.01)");
    int background = 0, reflected = 0;
    for (int y = 2; y < 64; y += 6)
      for (int x = 2; x < 96; x += 6) {
        const auto hit = this->hit(x, y);
        const Rgb found = pixel(x, y);
        const Direction d = ray(x, y);
        if (!hit) {
          const Rgb expected = seen(d);
          for (std::size_t channel = 0; channel < 3; ++channel) EXPECT_NEAR(found[channel], expected[channel], 0.01);
          ++background;
        } else if (hit->wo[2] > 0.4) {
          const double twice = 2 * brdf::dot(d, hit->point);
          Direction mirror;
          for (std::size_t axis = 0; axis < 3; ++axis) mirror[axis] = d[axis] - twice * hit->point[axis];
          const Rgb expected = seen(mirror);
          // Whatever the reflectance: the colour of what is mirrored.
          EXPECT_NEAR(found[0] / found[1], expected[0] / expected[1], 0.03) << x << ' ' << y;
          EXPECT_NEAR(found[2] / found[1], expected[2] / expected[1], 0.03) << x << ' ' << y;
          ++reflected;
        }
      }
    EXPECT_GT(background, 50);
    EXPECT_GT(reflected, 30);
  }
}

TEST_F(Render, APictureIsTheSameEveryTime) {
  ASSERT_TRUE(environment_->ReadFile(rendertest::shippedMap("venice")));
  render_->SetEnvironment(environment_);
  draw("0.5*GGX(alpha=0.2) + 0.2*Lambertian");
  std::vector<Rgb> first;
  for (int x = 0; x < 64; ++x) first.push_back(pixel(x, 32));
  render_->Modified();
  render_->Update();
  for (int x = 0; x < 64; ++x) EXPECT_EQ(pixel(x, 32), first[static_cast<std::size_t>(x)]);
}

TEST_F(Render, ABadMapIsAnErrorAndLeavesTheOldOne) {
  ASSERT_TRUE(environment_->ReadFile(rendertest::shippedMap("venice")));
  EXPECT_FALSE(environment_->ReadFile("/no/such/map.exr"));
  EXPECT_NE(environment_->GetErrorText().find("/no/such/map.exr"), std::string::npos);
  EXPECT_EQ(environment_->GetMapWidth(), 512);
  takeMessages();
}
