// Light without an environment map, and what holds for every light: against the core in double, pixel by pixel.
#include "RenderScene.h"

#include <brdf/color/ColourSettings.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/SampleSet.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <algorithm>

namespace {

using rendertest::Render;
using rendertest::Rgb;

constexpr double kPi = brdf::kPi;

/// A BRDF that is not a sum of lobes.
class Constant : public brdf::Brdf {
 public:
  const brdf::Channels& channels() const override { return channels_; }
  brdf::Symmetry symmetry() const override { return brdf::Symmetry::Isotropic; }
  bool reciprocal() const override { return true; }
  std::string description() const override { return "constant of the test"; }
  void evaluate(const brdf::DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override {
    std::fill_n(values, pairs.count, 1.0);
    if (valid) std::fill_n(valid, pairs.count, std::uint8_t{1});
  }
  using Brdf::evaluate;

 private:
  brdf::Channels channels_;
};

}  // namespace

TEST_F(Render, LambertianUnderADirectionalLightIsAlbedoIrradianceCosineOverPi) {
  render_->AddDirectionalLight(60, 40, 2, 1, 0.5);
  draw("0.8*Lambertian");
  const double theta = brdf::radians(60), phi = brdf::radians(40);
  const brdf::Direction light{std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
  int lit = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto hit = this->hit(x, y);
      if (!hit || hit->wo[2] < 0.1) continue;
      const double cosine = std::max(0.0, brdf::dot(hit->point, light));
      const Rgb rgb = pixel(x, y);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double irradiance = 2 / std::pow(2.0, channel);
        // Facets between vertices move the point by (edge angle)^2 / 8 at most.
        EXPECT_NEAR(rgb[channel], 0.8 / kPi * irradiance * cosine, 2e-4 * irradiance) << x << ' ' << y;
      }
      lit += cosine > 0;
    }
  EXPECT_GT(lit, 800);
}

TEST_F(Render, APointLightFallsOffWithTheSquareOfDistance) {
  const brdf::Direction place{0.5, 1.2, 1.5};
  render_->AddPointLight(place[0], place[1], place[2], 3, 3, 3);
  draw("Lambertian");
  for (int y = 4; y < 64; y += 8)
    for (int x = 4; x < 64; x += 8) {
      const auto hit = this->hit(x, y);
      if (!hit || hit->wo[2] < 0.2) continue;
      brdf::Direction to;
      for (std::size_t axis = 0; axis < 3; ++axis) to[axis] = place[axis] - hit->point[axis];
      const double squared = brdf::dot(to, to), cosine = std::max(0.0, brdf::dot(to, hit->point) / std::sqrt(squared));
      EXPECT_NEAR(pixel(x, y)[0], 3 * cosine / (kPi * squared), 1e-3) << x << ' ' << y;
    }
}

TEST_F(Render, EveryLobeUnderADirectionalLightEqualsTheCore) {
  render_->AddDirectionalLight(50, 30, 1, 1, 1);
  const double theta = brdf::radians(50), phi = brdf::radians(30);
  const brdf::Direction light{std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
  for (const auto& model : brdf::allModels()) {
    draw(model->name());
    double largest = 0, worst = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const auto hit = this->hit(x, y);
        if (!hit || hit->wo[2] < 0.15) continue;
        const brdf::Direction wi = hit->local(light);
        const double expected = material_->evaluate(wi, hit->wo)[0] * std::max(0.0, wi[2]);
        largest = std::max(largest, expected);
        worst = std::max(worst, std::abs(pixel(x, y)[0] - expected));
      }
    // The facets' normals and positions are off by some 1e-4 rad, over which default lobes change little.
    EXPECT_GT(largest, 0) << model->name();
    EXPECT_LT(worst, 5e-3 * largest) << model->name();
  }
}

TEST_F(Render, AnisotropyFollowsTheTangentsOfTheObject) {
  render_->AddDirectionalLight(60, 0, 1, 1, 1);
  const double theta = brdf::radians(60);
  const brdf::Direction light{0, std::cos(theta), std::sin(theta)};
  draw("Ward(ax=0.1, ay=0.4)");
  double largest = 0, worst = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto hit = this->hit(x, y);
      if (!hit || hit->wo[2] < 0.3) continue;
      const brdf::Direction wi = hit->local(light);
      const double expected = material_->evaluate(wi, hit->wo)[0] * std::max(0.0, wi[2]);
      largest = std::max(largest, expected);
      worst = std::max(worst, std::abs(pixel(x, y)[0] - expected));
    }
  EXPECT_LT(worst, 1e-2 * largest);
}

TEST_F(Render, ExposureIsAPowerOfTwo) {
  render_->AddDirectionalLight(60, 0, 1, 1, 1);
  draw("Lambertian");
  const double before = pixel(32, 40)[1];
  render_->SetExposure(-3);
  render_->Update();
  EXPECT_NEAR(pixel(32, 40)[1] * 8, before, 1e-6 * before);
}

TEST_F(Render, SweepingAParameterNeverCompiles) {
  render_->SetSize(16, 16);
  render_->SetEnvironment(environment_);
  draw("0.1*Lambertian + GGX(alpha=0.1)");
  ASSERT_EQ(render_->GetNumberOfShaderBuilds(), 1);
  double before = 0;
  for (int step = 1; step <= 100; ++step) {
    draw("(0.1,0.2,0.3)*Lambertian + 0.5*GGX(alpha=" + std::to_string(0.1 + 0.005 * step) + ")");
    EXPECT_NE(pixel(8, 8)[0], before);
    before = pixel(8, 8)[0];
  }
  EXPECT_EQ(render_->GetNumberOfShaderBuilds(), 1);
  draw("GGX(alpha=0.1)");
  EXPECT_EQ(render_->GetNumberOfShaderBuilds(), 2) << "another structure compiles once";
}

TEST_F(Render, ASpectralMaterialHasItsColourUnderTheLightAskedFor) {
  const auto channels = brdf::Channels::spectral({450, 500, 550, 600, 650});
  material_ = brdf::parseMaterialExpression("(0.2,0.2,0.3,0.5,0.6)*Lambertian", channels);
  vtkNew<vtkBRDF> input;
  input->SetBrdf(material_);
  render_->SetInputData(input);
  render_->AddDirectionalLight(90, 0, kPi, kPi, kPi);  // from +z, where the camera is
  for (const char* illuminant : {"", "A", "F11"}) {
    render_->SetIlluminant(illuminant);
    render_->Update();
    ASSERT_EQ(render_->GetErrorText(), "");
    const auto seen = brdf::asRgb(material_, brdf::colourSettings({illuminant, "2", "bradford"}));
    const auto expected = seen->evaluate({0, 0, 1}, {0, 0, 1});
    const Rgb rgb = pixel(32, 32);
    for (std::size_t channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(rgb[channel], kPi * expected[channel], 5e-3 * kPi * expected[channel]) << illuminant;
  }
}

TEST_F(Render, ASpectralMaterialWhoseShapeDependsOnTheWavelengthIsDrawnByATable) {
  vtkNew<vtkBRDF> input;
  const brdf::BrdfPointer brdf =
      brdf::parseMaterialExpression("GGX(alpha=(0.3,0.4,0.5))", brdf::Channels::spectral({450, 550, 650}));
  input->SetBrdf(brdf);
  render_->SetInputData(input);
  render_->AddDirectionalLight(90, 0, kPi, kPi, kPi);  // from +z, where the camera is
  render_->Update();
  ASSERT_EQ(render_->GetErrorText(), "");
  EXPECT_LT(render_->GetResamplingError(), 0.02);
  const auto expected = brdf::asRgb(brdf)->evaluate({0, 0, 1}, {0, 0, 1});
  for (std::size_t channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(pixel(32, 32)[channel], kPi * expected[channel], 0.02 * kPi * expected[channel]);
}

TEST_F(Render, ABrdfThatIsNeitherLobesNorATableIsDrawn) {
  vtkNew<vtkBRDF> input;
  input->SetBrdf(std::make_shared<Constant>());
  render_->SetInputData(input);
  render_->AddDirectionalLight(90, 0, kPi, kPi, kPi);
  render_->Update();
  EXPECT_EQ(render_->GetErrorText(), "");
  EXPECT_NEAR(pixel(32, 32)[1], kPi, 5e-3 * kPi);
  EXPECT_NEAR(render_->GetResamplingError(), 0, 1e-12);
}

TEST_F(Render, AnyObjectCanBeRendered) {
  vtkNew<vtkSphereSource> sphere;  // without tangents
  sphere->SetRadius(2);
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(200);
  sphere->GenerateNormalsOff();
  render_->SetObjectConnection(sphere->GetOutputPort());
  render_->AddDirectionalLight(90, 0, kPi, kPi, kPi);  // from the viewer
  draw("Lambertian");
  EXPECT_NEAR(pixel(32, 32)[0], 1, 2e-3);
  vtkNew<vtkPolyData> empty;
  render_->SetInputDataObject(1, empty);
  render_->Update();
  EXPECT_NE(render_->GetErrorText().find("empty"), std::string::npos);
  takeMessages();
}
