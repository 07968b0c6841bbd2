// Tables and scattered data in the shaders: under a directional light against the processor pixel by pixel, under maps
// against the reference renderer, in a white furnace against the directional albedo.
#include "RenderScene.h"
#include "TableCases.h"

#include <brdf/geometry/Directions.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/Resample.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/measured/Format.h>
#include <brdf/models/FormulaModel.h>
#include <brdf/models/Registry.h>
#include <brdf/render/ReferenceRenderer.h>
#include <brdf/sampling/Sequence.h>

#include <vtkActor.h>
#include <vtkBRDFPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <filesystem>
#include <random>

#include "../sampling/FunctionBrdf.h"

namespace {

using brdf::BrdfPointer;
using brdf::Direction;
using rendertest::formula;
using rendertest::Render;
using rendertest::Rgb;
using rendertest::TableCase;

constexpr double kPi = brdf::kPi;

class DrawnBrdf : public Render {
 protected:
  void draw(const BrdfPointer& brdf) {
    vtkNew<vtkBRDF> input;
    input->SetBrdf(brdf);
    render_->SetInputData(input);
    render_->Update();
    ASSERT_EQ(render_->GetErrorText(), "");
  }
  /// Values at a pixel; those of a monochrome BRDF three times.
  static Rgb value(const BrdfPointer& brdf, const Direction& wi, const Direction& wo) {
    const auto values = brdf->evaluate(wi, wo);
    return values.size() == 1 ? Rgb{values[0], values[0], values[0]} : Rgb{values[0], values[1], values[2]};
  }
};

class TableRender : public DrawnBrdf, public testing::WithParamInterface<TableCase> {};

TEST_P(TableRender, UnderADirectionalLightEqualsTheCore) {
  const BrdfPointer brdf = GetParam().make(), drawn = rendertest::drawnOf(brdf);
  render_->AddDirectionalLight(60, 35, 1, 1, 1);
  const double theta = brdf::radians(60), phi = brdf::radians(35);
  const Direction light{std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
  draw(brdf);
  double largest = 0, worst = 0, difference = 0, sum = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto hit = this->hit(x, y);
      if (!hit || hit->wo[2] < 0.15) continue;
      const Direction wi = hit->local(light);
      const Rgb expected = value(brdf, wi, hit->wo), looked = value(drawn, wi, hit->wo), found = pixel(x, y);
      for (std::size_t c = 0; c < 3; ++c) {
        const double cosine = std::max(0.0, wi[2]), radiance = expected[c] * cosine;
        largest = std::max(largest, radiance);
        worst = std::max(worst, std::abs(found[c] - looked[c] * cosine));
        difference += std::abs(found[c] - radiance);
        sum += radiance;
      }
    }
  ASSERT_GT(largest, 0);
  // The facets' normals and positions are off by some 1e-4 rad.
  EXPECT_LT(worst, 5e-3 * largest);
  // What was made for drawing is as near as it says, which is of the worst directions.
  EXPECT_LT(difference / sum, std::max(0.0, render_->GetResamplingError()) + 1e-3);
  EXPECT_LT(render_->GetResamplingError(), 0.05);
  EXPECT_NE(render_->GetTableLayouts().find("theta"), std::string::npos);
}

TEST_P(TableRender, UnderMapsAgreesWithTheReferenceRenderer) {
  constexpr int size = 24;
  const BrdfPointer brdf = GetParam().make();
  render_->SetSize(size, size);
  render_->SetEnvironment(environment_);
  render_->SetNumberOfSamples(brdf->symmetry() == brdf::Symmetry::Anisotropic ? 4096 : 1024);
  for (const char* name : {"venice", "studio"}) {
    ASSERT_TRUE(environment_->ReadFile(rendertest::shippedMap(name)));
    draw(brdf);
    brdf::Scene scene;
    scene.materials = {brdf};
    scene.objects.push_back({"sphere", nullptr, {}, 0});
    scene.environment = brdf::SceneEnvironment{
        std::make_shared<const brdf::EnvironmentMap>(brdf::EnvironmentMap::read(rendertest::shippedMap(name))), 0, 1};
    scene.camera = brdf::cameraAround({0, 0, 0}, 1, 0, 0, 30, 1);
    scene.width = scene.height = size;
    brdf::ReferenceOptions options;
    options.samples = 512;
    options.pixelCentres = true;
    const brdf::ReferencePicture truth = brdf::renderReference(scene, options);
    double difference = 0, claimed = 0, square = 0, bias = 0, sum = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const auto hit = this->hit(x, y);
        if (!hit || hit->wo[2] < 0.2) continue;
        const Rgb rgb = pixel(x, y);
        for (std::size_t c = 0; c < 3; ++c) {
          const auto row = static_cast<std::size_t>(size - 1 - y), column = static_cast<std::size_t>(x);
          const double expected = double(truth.radiance.pixel(column, row)[c]);
          difference += (rgb[c] - expected) * (rgb[c] - expected);
          claimed += std::pow(double(truth.standardError.pixel(column, row)[c]), 2);
          square += expected * expected;
          bias += rgb[c] - expected;
          sum += expected;
        }
      }
    // What the reference's own noise does not explain: filtering, shared samples, resampling.
    const double own = std::sqrt(std::max(0.0, difference - claimed) / square);
    RecordProperty(std::string(name), std::to_string(own));
    // The small lamps of the studio show the most of it, in a broad anisotropic lobe that four viewers' tables share.
    EXPECT_LT(own, brdf->symmetry() == brdf::Symmetry::Anisotropic ? 0.1 : 0.03) << name;
    EXPECT_LT(std::abs(bias), 0.01 * sum) << name;  // it is noise
  }
}

TEST_P(TableRender, InAWhiteFurnaceIsTheDirectionalAlbedo) {
  const BrdfPointer brdf = GetParam().make();
  render_->SetSize(24, 24);
  render_->SetEnvironment(environment_);
  render_->SetNumberOfSamples(4096);
  draw(brdf);
  const auto quadrature = rendertest::cosineQuadrature(240);
  for (int x : {12, 16, 20}) {
    const auto hit = this->hit(x, 13);
    ASSERT_TRUE(hit);
    brdf::DirectionPairBuffer<double> pairs;
    for (const Direction& wi : quadrature.directions) pairs.push(wi, hit->wo);
    const std::size_t channels = brdf->channels().count();
    std::vector<double> values(channels * pairs.size());
    brdf->evaluateParallel(pairs.view(), values.data(), nullptr);
    const Rgb found = pixel(x, 13);
    for (std::size_t c = 0; c < 3; ++c) {
      double albedo = 0;
      for (std::size_t i = 0; i < pairs.size(); ++i)
        albedo += values[(channels == 1 ? 0 : c) * pairs.size() + i] * quadrature.weights[i];
      EXPECT_NEAR(found[c], albedo, (0.01 + std::max(0.0, render_->GetResamplingError())) * albedo) << x;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Materials, TableRender, testing::ValuesIn(rendertest::kTableCases),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_F(DrawnBrdf, MeasuredDataEqualTheirInterpolant) {
  const std::string file = std::string(BRDF_SOURCE_DIR) + "/../shared/data/measured/garnet_red.brdf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const BrdfPointer brdf = brdf::asRgb(brdf::readMeasured(file).brdf);
  double difference = 0, sum = 0;
  for (const auto& [theta, phi] : {std::pair(60.0, 35.0), std::pair(30.0, 70.0), std::pair(85.0, -40.0)}) {
    render_->RemoveAllLights();
    render_->AddDirectionalLight(theta, phi, kPi, kPi, kPi);
    draw(brdf);
    const double t = brdf::radians(theta), p = brdf::radians(phi);
    for (int y = 0; y < 64; y += 2)
      for (int x = 0; x < 64; x += 2) {
        const auto hit = this->hit(x, y);
        if (!hit || hit->wo[2] < 0.3) continue;
        const Direction wi = hit->local({std::sin(t) * std::sin(p), std::cos(t), std::sin(t) * std::cos(p)});
        if (wi[2] <= 0) continue;
        const Rgb expected = value(brdf, wi, hit->wo), found = pixel(x, y);
        for (std::size_t c = 0; c < 3; ++c) {
          difference += std::abs(found[c] - kPi * expected[c] * wi[2]);
          sum += std::abs(kPi * expected[c] * wi[2]);
        }
      }
  }
  RecordProperty("difference", std::to_string(difference / sum));
  EXPECT_GE(render_->GetResamplingError(), 0);
  // Three lights see some directions only, in which the error may be above its mean.
  EXPECT_LT(difference / sum, 2 * render_->GetResamplingError());
}

TEST_F(DrawnBrdf, ALobeWithoutASamplerIsDrawnByTablesOfItsOwnAndNeverCompilesAgain) {
  brdf::registerModel(
      std::make_shared<const brdf::FormulaModel>(R"(<model name="PeakOfTheTest" title="A peak" isotropic="yes">
    <description>Of a test.</description>
    <parameter name="width" label="width" symbol="w" unit="1" default="0.1" min="1e-3" max="1" softMin="0.01" softMax="1"
               scale="log">Of the peak.</parameter>
    <equation>d2 = sqr(ux + vx) + sqr(uy + vy); exp(-d2/sqr(width)) / (pi*sqr(width))</equation>
    </model>)",
                                                 "test of tables"));
  const auto model = brdf::findModel("PeakOfTheTest");
  ASSERT_FALSE(model->namesSampler());
  render_->SetSize(24, 24);
  render_->SetEnvironment(environment_);
  render_->SetNumberOfSamples(256);
  const auto quadrature = rendertest::cosineQuadrature(300);
  for (const char* width : {"0.3", "0.2", "0.1", "0.4"}) {
    const BrdfPointer brdf = formula((std::string("0.5*PeakOfTheTest(width=") + width + ")").c_str());
    draw(brdf);
    const auto hit = this->hit(14, 13);
    brdf::DirectionPairBuffer<double> pairs;
    for (const Direction& wi : quadrature.directions) pairs.push(wi, hit->wo);
    std::vector<double> values(pairs.size());
    brdf->evaluateParallel(pairs.view(), values.data(), nullptr);
    double albedo = 0;
    for (std::size_t i = 0; i < values.size(); ++i) albedo += values[i] * quadrature.weights[i];
    // Cosine-weighted draws of the narrowest would be off by several times as much.
    EXPECT_NEAR(pixel(14, 13)[0], albedo, 0.02 * albedo) << width;
  }
  EXPECT_EQ(render_->GetNumberOfShaderBuilds(), 1);
}

TEST(AdaptedSamples, AreTheMostHalvedUntilTheTimeAllowedSuffices) {
  // 64 samples took 0.2 s; 0.05 s are allowed: 16.
  EXPECT_EQ(vtkBRDFPolyDataMapper::AdaptedSamples(0.05, 0.2, 64, 4, 256), 16);
  EXPECT_EQ(vtkBRDFPolyDataMapper::AdaptedSamples(0.001, 0.2, 64, 4, 256), 4);
  EXPECT_EQ(vtkBRDFPolyDataMapper::AdaptedSamples(0.04, 0.1, 100, 4, 100), 25);  // 40 would do
  EXPECT_EQ(vtkBRDFPolyDataMapper::AdaptedSamples(0.001, 0.1, 100, 4, 100), 4);
  EXPECT_EQ(vtkBRDFPolyDataMapper::AdaptedSamples(1e4, 0.2, 64, 4, 256), 256);
  EXPECT_EQ(vtkBRDFPolyDataMapper::AdaptedSamples(0.05, 0, 0, 4, 256), 4);
  EXPECT_EQ(vtkBRDFPolyDataMapper::AdaptedSamples(1e4, 0, 0, 4, 256), 256);
  EXPECT_EQ(vtkBRDFPolyDataMapper::AdaptedSamples(0, 0.2, 64, 8, 2), 2);
}

TEST_F(DrawnBrdf, AMovingSceneGetsFewerSamplesAndOneAtRestAllOfThem) {
  vtkNew<vtkBRDFHeadlessRenderWindow> window;
  window->SetSize(64, 64);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkBRDFPolyDataMapper> mapper;
  vtkNew<vtkBRDF> input;
  input->SetBrdf(formula("GGX(alpha=0.3)"));
  mapper->SetBRDFData(input);
  mapper->SetInputConnection(sphere->GetOutputPort());
  mapper->SetEnvironment(environment_);
  mapper->SetNumberOfSamples(128);
  mapper->AdaptSamplesOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  window->SetDesiredUpdateRate(1e6);  // as while moving, but so that no machine can keep it
  for (int frame = 0; frame < 3; ++frame) {
    window->Render();
    EXPECT_EQ(mapper->GetSamplesDrawn(), 4);
  }
  window->SetDesiredUpdateRate(1e-4);  // at rest
  window->Render();
  EXPECT_EQ(mapper->GetSamplesDrawn(), 128);
  mapper->AdaptSamplesOff();
  window->SetDesiredUpdateRate(1e6);
  window->Render();
  EXPECT_EQ(mapper->GetSamplesDrawn(), 128);
}

/// A picture as it is while something moves: at a rate that no machine keeps up, then without one.
TEST_F(DrawnBrdf, APictureInAHurryGetsFewSamplesAndTheNextAllOfThem) {
  render_->SetEnvironment(environment_);
  render_->SetNumberOfSamples(128);
  render_->SetEdgeSamples(1);
  const BrdfPointer material = formula("0.5*Lambertian + GGX(alpha=0.3)");
  render_->SetDesiredUpdateRate(1e9);
  for (int frame = 0; frame < 2; ++frame) {
    draw(material);
    EXPECT_EQ(render_->GetSamplesOfPicture(), 4);
  }
  render_->SetDesiredUpdateRate(1e-3);  // 1,000 s for each
  draw(material);
  EXPECT_EQ(render_->GetSamplesOfPicture(), 128);
  render_->SetDesiredUpdateRate(0);
  draw(material);
  EXPECT_EQ(render_->GetSamplesOfPicture(), 128);
  EXPECT_EQ(render_->GetNumberOfShaderBuilds(), 1);
}

}  // namespace
