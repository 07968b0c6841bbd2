// A surface is drawn in two steps where the framebuffer has one sample a pixel (vtkBRDFDeferredShading) and in one
// where it has several. Both ways are drawn here, in windows of a user's own, and have to show the same.
#include "RenderScene.h"

#include <vtkActor.h>
#include <vtkBRDFPolyDataMapper.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <set>
#include <vector>

namespace {

using rendertest::Render;

class DeferredShading : public Render {
 protected:
  static constexpr int kSize = 64;

  DeferredShading() {
    window_->SetSize(kSize, kSize);
    window_->AddRenderer(renderer_);
    renderer_->AutomaticLightCreationOff();
    vtkNew<vtkLight> lamp;
    lamp->SetLightTypeToSceneLight();
    lamp->SetPositional(true);
    lamp->SetPosition(1, 2, 2);  // so near that its light depends on where the surface is
    lamp->SetColor(3, 3, 3);
    renderer_->AddLight(lamp);
  }

  vtkActor* sphere(const char* material, double x, double z, double radius) {
    vtkNew<vtkSphereSource> source;
    source->SetThetaResolution(60);
    source->SetPhiResolution(30);
    source->SetRadius(radius);
    source->SetCenter(x, 0, z);
    vtkNew<vtkBRDF> brdf;
    brdf->SetBrdf(brdf::parseMaterialExpression(material));
    vtkNew<vtkBRDFPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    mapper->SetBRDFData(brdf);
    mapper->EncodeForDisplayOn();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    renderer_->AddActor(actor);
    renderer_->ResetCamera();
    mappers_.push_back(mapper);
    return actor;
  }

  /// What the window shows: R, G, B, row by row from the bottom.
  std::vector<int> shown(bool deferred) {
    for (const auto& mapper : mappers_) mapper->SetDeferShading(deferred);
    window_->Render();
    vtkNew<vtkUnsignedCharArray> bytes;
    window_->GetPixelData(0, 0, kSize - 1, kSize - 1, 0, bytes, 0);
    return {bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues()};
  }

  /// Returns how many values of light were compared.
  int expectBothWaysAgree(bool translucent = false) {
    const std::vector<int> deferred = shown(true);
    const int builds = mappers_[0]->GetNumberOfShaderBuilds();
    const std::vector<int> atOnce = shown(false);
    const bool opaque = mappers_[0]->GetNumberOfShaderBuilds() > builds;  // another shader, that is
    EXPECT_NE(opaque, translucent);
    EXPECT_EQ(deferred.size(), atOnce.size());
    int compared = 0;
    for (std::size_t i = 0; i < atOnce.size(); ++i) {
      EXPECT_NEAR(deferred[i], atOnce[i], 1) << "pixel " << i / 3 % kSize << ", " << i / 3 / kSize;
      compared += atOnce[i] > 30;
    }
    return compared;
  }

  vtkNew<vtkBRDFHeadlessRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  std::vector<vtkSmartPointer<vtkBRDFPolyDataMapper>> mappers_;
};

TEST_F(DeferredShading, ShowsWhatDrawingAtOnceShows) {
  sphere("0.6*Lambertian + 0.1*GGX(alpha=0.4)", 0, 0, 1);
  EXPECT_GT(expectBothWaysAgree(), 1000);
}

TEST_F(DeferredShading, ParallelProjection) {
  sphere("0.6*Lambertian + 0.1*GGX(alpha=0.4)", 0, 0, 1);
  renderer_->GetActiveCamera()->ParallelProjectionOn();
  EXPECT_GT(expectBothWaysAgree(), 1000);
}

TEST_F(DeferredShading, TangentsTurnAnisotropicLight) {
  sphere("2*Ward(ax=0.05, ay=0.5)", 0, 0, 1);
  EXPECT_GT(expectBothWaysAgree(), 100);
}

TEST_F(DeferredShading, TheNearerOfTwoHidesTheOtherInEitherOrder) {
  sphere("(0.8,0.4,0.2)*Lambertian", 0, 0, 1);
  sphere("(0.2,0.4,0.8)*Lambertian", 0.3, 0.8, 0.5);    // drawn later, and in front
  sphere("(0.4,0.8,0.2)*Lambertian", -0.3, -0.9, 1.2);  // drawn later, and behind
  EXPECT_GT(expectBothWaysAgree(), 500);
}

TEST_F(DeferredShading, SurfacesOfOtherMappersHideAndAreHidden) {
  vtkNew<vtkPlaneSource> plane;  // through the sphere: half of it is before, half behind
  plane->SetOrigin(-2, -2, 0.5);
  plane->SetPoint1(2, -2, 0.5);
  plane->SetPoint2(-2, 2, 0.5);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0, 0.5, 0);
  renderer_->AddActor(actor);
  sphere("0.8*Lambertian", 0, 0, 1);
  renderer_->ResetCamera();
  EXPECT_GT(expectBothWaysAgree(), 100);
}

TEST_F(DeferredShading, ARendererThatFillsAPartOfTheWindow) {
  renderer_->SetViewport(0.4, 0.25, 1, 1);
  sphere("0.8*Lambertian", 0, 0, 1);
  EXPECT_GT(expectBothWaysAgree(), 200);
}

TEST_F(DeferredShading, ATranslucentSurfaceIsDrawnAsEver) {
  sphere("0.8*Lambertian", 0, 0, 1)->GetProperty()->SetOpacity(0.5);
  EXPECT_GT(expectBothWaysAgree(true), 1000);
}

TEST_F(DeferredShading, SeveralSamplesAPixelSmoothTheOutline) {
  sphere("0.8*Lambertian", 0, 0, 1);
  renderer_->RemoveAllLights();
  vtkNew<vtkBRDFEnvironment> environment;
  environment->SetConstant(1, 1, 1);
  mappers_[0]->SetEnvironment(environment);
  const auto levels = [this](int samples) {
    window_->SetMultiSamples(samples);
    const std::vector<int> picture = shown(true);
    return std::set<int>(picture.begin(), picture.end()).size();
  };
  EXPECT_EQ(levels(0), 2u);  // of nothing and of the sphere
  EXPECT_GT(levels(4), 3u);
}

}  // namespace
