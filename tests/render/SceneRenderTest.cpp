// Scenes of several objects drawn by the shaders, against the reference renderer of libbrdf.
#include "RenderScene.h"

#include <brdf/base/Error.h>
#include <brdf/render/ReferenceRenderer.h>
#include <brdf/render/SceneArrangement.h>

namespace {

using rendertest::Render;

brdf::SceneObject sphereAt(brdf::Position place, double radius, std::size_t material) {
  brdf::SceneObject object{"sphere", nullptr, {}, material};
  object.placement.shift = place;
  object.placement.scale = radius;
  object.placement.axes = brdf::rotation({0, 0, 1}, 30);  // its tangents run around a tilted axis
  return object;
}

/// Two spheres and a tilted square, each of its own material, which no light lets shadow another.
brdf::Scene openScene() {
  brdf::Scene scene;
  scene.materials = {brdf::parseMaterialExpression("(0.6,0.3,0.1)*Lambertian"),
                     brdf::parseMaterialExpression("Ward(ax=0.15, ay=0.4)"),
                     brdf::parseMaterialExpression("(0.1,0.1,0.3)*Lambertian + GGX(alpha=0.3)")};
  scene.objects = {sphereAt({-1.4, 0.2, 0}, 0.9, 0), sphereAt({1.3, -0.3, 0.4}, 0.7, 1)};
  brdf::SceneObject square{"square", std::make_shared<const brdf::TriangleMesh>(brdf::makeSquare(1)), {}, 2};
  square.placement.shift = {0, 1.4, -0.5};
  square.placement.axes = brdf::rotation({1, 0.2, 0}, 60);
  scene.objects.push_back(square);
  scene.lights = {{brdf::SceneLight::Kind::Directional, {0.2, 0.5, 1}, {3, 2, 1}},
                  {brdf::SceneLight::Kind::Point, {0.5, 0.6, 4}, {8, 9, 10}}};
  scene.camera = brdf::cameraAround({0, 0.3, 0}, 2.6, 20, 10, 35, 1.5);
  scene.width = 90;
  scene.height = 60;
  return scene;
}

brdf::Image reference(const brdf::Scene& scene, std::size_t samples = 2) {
  brdf::ReferenceOptions options;
  options.samples = samples;
  options.pixelCentres = true;
  return brdf::renderReference(scene, options).radiance;
}

struct Difference {
  double rms = 0, largest = 0;  ///< relative to the reference's root mean square
};

class SceneRender : public Render {
 protected:
  /// Over the pixels that `counts`; VTK's rows go up, the core's down.
  template <class Counts>
  Difference difference(const brdf::Image& truth, const Counts& counts) {
    double sum = 0, square = 0, largest = 0;
    for (std::size_t y = 0; y < truth.height; ++y)
      for (std::size_t x = 0; x < truth.width; ++x) {
        if (!counts(x, y)) continue;
        const auto* drawn = static_cast<const float*>(
            render_->GetOutput()->GetScalarPointer(static_cast<int>(x), static_cast<int>(truth.height - 1 - y), 0));
        for (std::size_t c = 0; c < 3; ++c) {
          const double expected = double(truth.pixel(x, y)[c]), off = double(drawn[c]) - expected;
          sum += off * off;
          square += expected * expected;
          largest = std::max(largest, std::abs(off));
        }
      }
    const double pixels = 3 * double(truth.width * truth.height);
    return {std::sqrt(sum / square), largest / std::sqrt(square / pixels)};
  }
};

/// Whether a pixel and its neighbours see the same object: there both renderers see the same surface.
class Interior {
 public:
  explicit Interior(brdf::Scene scene) : width_(scene.width), height_(scene.height) {
    for (std::size_t k = 0; k < scene.objects.size(); ++k) scene.objects[k].material = k + 1;
    scene.materials.clear();
    for (std::size_t k = 0; k <= scene.objects.size(); ++k)
      scene.materials.push_back(brdf::parseMaterialExpression(std::to_string(0.1 * double(k)) + "*Lambertian"));
    scene.lights.clear();
    // The same light everywhere: the radiance of a pixel tells its object.
    scene.environment = brdf::SceneEnvironment{
        std::make_shared<const brdf::EnvironmentMap>(brdf::EnvironmentMap::constant({1, 1, 1})), 0, 1};
    scene.background.kind = brdf::SceneBackground::Kind::Transparent;
    picture_ = reference(scene, 2);
  }
  bool operator()(std::size_t x, std::size_t y) const {
    if (x == 0 || y == 0 || x + 1 >= width_ || y + 1 >= height_) return false;
    for (std::size_t j = y - 1; j <= y + 1; ++j)
      for (std::size_t i = x - 1; i <= x + 1; ++i)
        if (picture_.pixel(i, j)[3] < 1) return false;
    return true;
  }

 private:
  std::size_t width_, height_;
  brdf::Image picture_;
};

}  // namespace

using SceneRenderTest = SceneRender;

TEST_F(SceneRenderTest, SeveralObjectsAndMaterialsEqualTheReferenceWhereNothingShadows) {
  const brdf::Scene scene = openScene();
  render_->SetScene(scene);
  render_->Update();
  ASSERT_EQ(render_->GetErrorText(), "");
  const Difference off = difference(reference(scene), Interior(scene));
  // Facets of the drawn spheres: see AnisotropyFollowsTheTangentsOfTheObject.
  EXPECT_LT(off.rms, 2e-3);
  EXPECT_LT(off.largest, 5e-2);
  EXPECT_EQ(render_->GetNumberOfShaderBuilds(), 3);
}

/// A ball on a floor with another behind it, so that each light throws shadows.
brdf::Scene shadowedScene() {
  brdf::Scene scene;
  scene.materials = {brdf::parseMaterialExpression("(0.6,0.5,0.4)*Lambertian"),
                     brdf::parseMaterialExpression("(0.1,0.1,0.3)*Lambertian + GGX(alpha=0.3)")};
  scene.objects = {sphereAt({0, 1, 0}, 1, 1), sphereAt({-1.5, 0.5, 1}, 0.5, 0)};
  brdf::addGround(scene, scene.materials[0]);
  scene.camera = brdf::cameraAround({0, 0.7, 0}, 2, 20, 25, 35, 1.5);
  scene.width = 90;
  scene.height = 60;
  return scene;
}

TEST_F(SceneRenderTest, ShadowsOfLightsAreTheReferencesPixelByPixel) {
  brdf::Scene scene = shadowedScene();
  scene.lights = {{brdf::SceneLight::Kind::Directional, {0.7, 0.6, 0.3}, {3, 2, 1}},
                  {brdf::SceneLight::Kind::Point, {-3, 2.5, 2}, {8, 9, 10}}};
  const brdf::Image truth = reference(scene);
  const Interior interior(scene);
  render_->SetScene(scene);
  render_->SetShadows(vtkBRDFRender::SHADOWS_NONE);
  render_->Update();
  const Difference without = difference(truth, interior);
  EXPECT_GT(without.rms, 0.1) << "nothing is shadowed: the test says nothing";
  for (const int shadows : {vtkBRDFRender::SHADOWS_LIGHTS, vtkBRDFRender::SHADOWS_ALL}) {
    render_->SetShadows(shadows);
    render_->Update();
    ASSERT_EQ(render_->GetErrorText(), "");
    const Difference off = difference(truth, interior);
    EXPECT_LT(off.rms, 5e-3);
    EXPECT_LT(off.largest, 5e-2) << "a pixel is shadowed that should not be, or the reverse";
  }
}

TEST_F(SceneRenderTest, ShadowsOfTheEnvironmentComeNearTheReferences) {
  brdf::Scene scene = shadowedScene();
  scene.environment = brdf::SceneEnvironment{
      std::make_shared<const brdf::EnvironmentMap>(brdf::EnvironmentMap::read(rendertest::shippedMap("venice"))), 70,
      1};
  scene.background.kind = brdf::SceneBackground::Kind::Colour;
  scene.width = 60;
  scene.height = 40;
  const brdf::Image truth = reference(scene, 1024);
  const Interior interior(scene);
  render_->SetNumberOfSamples(256);
  const auto off = [&](int shadows, int cells) {
    render_->SetScene(scene);
    render_->SetShadows(shadows);
    render_->SetShadowCells(cells);
    render_->Update();
    EXPECT_EQ(render_->GetErrorText(), "");
    return difference(truth, interior).rms;
  };
  const double without = off(vtkBRDFRender::SHADOWS_NONE, 16), coarse = off(vtkBRDFRender::SHADOWS_ALL, 8),
               usual = off(vtkBRDFRender::SHADOWS_ALL, 16), fine = off(vtkBRDFRender::SHADOWS_ALL, 32);
  EXPECT_GT(without, 0.1);
  EXPECT_LT(coarse, 0.5 * without);
  EXPECT_LT(usual, 0.03);
  EXPECT_LT(fine, usual);
  RecordProperty("none", std::to_string(without));
  RecordProperty("8", std::to_string(coarse));
  RecordProperty("16", std::to_string(usual));
  RecordProperty("32", std::to_string(fine));
}

TEST_F(SceneRenderTest, KindsOfShadowsInTurnShowWhatEachShowsAlone) {
  brdf::Scene scene = shadowedScene();
  scene.lights = {{brdf::SceneLight::Kind::Directional, {0.7, 0.6, 0.3}, {3, 2, 1}}};
  scene.environment = brdf::SceneEnvironment{
      std::make_shared<const brdf::EnvironmentMap>(brdf::EnvironmentMap::constant({1, 1, 1})), 0, 1};
  scene.width = 45;
  scene.height = 30;
  const auto picture = [&](vtkBRDFRender* render, int shadows) {
    render->SetShadows(shadows);
    render->Update();
    const auto* values = static_cast<const float*>(render->GetOutput()->GetScalarPointer());
    return std::vector<float>(values, values + 3 * scene.width * scene.height);
  };
  render_->SetScene(scene);
  for (const int shadows : {vtkBRDFRender::SHADOWS_ALL, vtkBRDFRender::SHADOWS_LIGHTS, vtkBRDFRender::SHADOWS_ALL,
                            vtkBRDFRender::SHADOWS_NONE, vtkBRDFRender::SHADOWS_LIGHTS}) {
    vtkNew<vtkBRDFRender> alone;
    alone->SetEdgeSamples(1);
    alone->SetScene(scene);
    EXPECT_EQ(picture(render_, shadows), picture(alone, shadows)) << shadows;
  }
}

TEST_F(SceneRenderTest, ALoneSphereIsTheSameWithShadows) {
  render_->SetEnvironment(environment_);
  draw("0.5*Lambertian + 0.3*GGX");
  const auto with = pixel(20, 30);
  render_->SetShadows(vtkBRDFRender::SHADOWS_NONE);
  render_->Update();
  EXPECT_EQ(pixel(20, 30), with);
  EXPECT_EQ(render_->GetNumberOfShaderBuilds(), 1);
}

TEST_F(SceneRenderTest, WindowsComeAndGoAndChangeTheirSize) {
  brdf::Scene scene = shadowedScene();
  scene.lights = {{brdf::SceneLight::Kind::Directional, {0.7, 0.6, 0.3}, {3, 2, 1}}};
  scene.environment = brdf::SceneEnvironment{
      std::make_shared<const brdf::EnvironmentMap>(brdf::EnvironmentMap::constant({1, 1, 1})), 0, 1};
  for (int life = 0; life < 2; ++life) {
    vtkNew<vtkBRDFRender> render;
    float first = 0;
    for (const std::size_t side : {24u, 40u, 17u, 24u}) {
      scene.width = scene.height = side;
      render->SetScene(scene);
      render->Update();
      ASSERT_EQ(render->GetErrorText(), "");
      const int middle = static_cast<int>(side) / 2;
      const float value = *static_cast<const float*>(render->GetOutput()->GetScalarPointer(middle, middle, 0));
      ASSERT_GT(value, 0);
      if (side == 24u) {
        if (first > 0) {
          EXPECT_EQ(value, first);
        }
        first = value;
      }
    }
  }
}

TEST_F(SceneRenderTest, ObjectsAreReplacedNotAdded) {
  brdf::Scene scene = openScene();
  render_->SetScene(scene);
  render_->Update();
  scene.objects.resize(1);
  scene.lights.resize(1);
  render_->SetScene(scene);
  render_->Update();
  ASSERT_EQ(render_->GetErrorText(), "");
  EXPECT_LT(difference(reference(scene), Interior(scene)).rms, 2e-3);
}

TEST_F(SceneRenderTest, BackgroundsAreTheReferencesOwn) {
  brdf::Scene scene = openScene();
  brdf::Image gradient(31, 17, 3);
  for (std::size_t y = 0; y < 17; ++y)
    for (std::size_t x = 0; x < 31; ++x) {
      gradient.pixel(x, y)[0] = float(x) / 31;
      gradient.pixel(x, y)[1] = float(y) / 17;
    }
  scene.background.kind = brdf::SceneBackground::Kind::Picture;
  scene.background.picture = std::make_shared<const brdf::Image>(gradient);
  render_->SetScene(scene);
  render_->Update();
  const brdf::Image truth = reference(scene);
  EXPECT_NEAR(pixel(0, 0)[1], double(truth.pixel(0, scene.height - 1)[1]), 1e-6);
  EXPECT_GT(pixel(0, 0)[1], 0.8);
  EXPECT_GT(pixel(89, 59)[0], 0.8);
  EXPECT_NEAR(pixel(89, 59)[0], double(truth.pixel(89, 0)[0]), 1e-6);

  scene.background.kind = brdf::SceneBackground::Kind::Transparent;
  render_->SetScene(scene);
  render_->SetEdgeSamples(8);
  render_->Update();
  ASSERT_EQ(render_->GetOutput()->GetNumberOfScalarComponents(), 4);
  brdf::ReferenceOptions options;
  options.samples = 256;
  const brdf::Image whole = brdf::renderReference(scene, options).radiance;
  double sum = 0, part = 0;
  for (std::size_t y = 0; y < whole.height; ++y)
    for (std::size_t x = 0; x < whole.width; ++x) {
      const auto* rgba = static_cast<const float*>(
          render_->GetOutput()->GetScalarPointer(static_cast<int>(x), static_cast<int>(whole.height - 1 - y), 0));
      sum += std::abs(double(rgba[3]) - double(whole.pixel(x, y)[3]));
      part += rgba[3] > 0 && rgba[3] < 1;
    }
  EXPECT_LT(sum / double(whole.width * whole.height), 0.01);
  EXPECT_GT(part, 50);
}

TEST_F(SceneRenderTest, WhatCannotBeDrawnIsSaidInOneLine) {
  brdf::Scene scene = openScene();
  scene.lights.resize(9, scene.lights[0]);
  EXPECT_THROW(render_->SetScene(scene), brdf::Error);
  render_->RemoveAllObjects();
  render_->Update();
  EXPECT_NE(render_->GetErrorText().find("nothing to render"), std::string::npos) << render_->GetErrorText();
  takeMessages();
}
