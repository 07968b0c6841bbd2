#include "../TestFolder.h"
#include "Support.h"

#include <brdf/geometry/Directions.h>

#include <gtest/gtest.h>

#include <vtkBRDFErrorMap.h>
#include <vtkBRDFErrorMapView.h>
#include <vtkBRDFHeadlessRenderWindow.h>
#include <vtkBRDFLobeView.h>
#include <vtkBRDFSource.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <cmath>
#include <cstring>
#include <filesystem>

namespace brdf {
namespace {

using test::ExpectErrors;
using test::Pixel;
using test::pixelAt;

vtkSmartPointer<vtkBRDFSource> material(const char* text) {
  const auto source = vtkSmartPointer<vtkBRDFSource>::New();
  source->SetMaterial(text);
  return source;
}

/// Whether blue rules: the first colour of the palette, however it is lit.
bool isBlue(const Pixel& p) { return p[2] > p[0] + 40 && p[2] > p[1] + 20; }

/// The pixel that a point of the scene falls on.
std::array<int, 2> projected(vtkBRDFView* view, const Direction& point) {
  vtkRenderer* renderer = view->GetRenderer();
  renderer->SetWorldPoint(point[0], point[1], point[2], 1);
  renderer->WorldToDisplay();
  return {static_cast<int>(std::lround(renderer->GetDisplayPoint()[0])),
          static_cast<int>(std::lround(renderer->GetDisplayPoint()[1]))};
}

std::size_t count(vtkImageData* image, bool (*wanted)(const Pixel&)) {
  std::size_t found = 0;
  for (int y = 0; y < image->GetDimensions()[1]; ++y)
    for (int x = 0; x < image->GetDimensions()[0]; ++x) found += wanted(pixelAt(image, x, y));
  return found;
}

TEST(LobeView, TheLobeStandsInTheMirrorDirection) {
  const auto source = material("0.001*Lambertian + BlinnPhong(n=2000)");
  vtkNew<vtkBRDFLobeView> view;
  view->AddInputConnection(source->GetOutputPort());
  vtkNew<vtkImageData> image;
  for (double phiI : {0.0, 115.0}) {
    view->SetThetaI(40);
    view->SetPhiI(phiI);
    ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
    EXPECT_EQ(image->GetDimensions()[0], 900);
    EXPECT_EQ(image->GetDimensions()[1], 700);
    for (double height : {0.3, 0.6}) {
      Direction mirror = fromSpherical(radians(40), radians(phiI + 180)),
                retro = fromSpherical(radians(40), radians(phiI));
      for (double& x : mirror) x *= height;
      for (double& x : retro) x *= height;
      const auto at = projected(view, mirror), away = projected(view, retro);
      EXPECT_TRUE(isBlue(pixelAt(image, at[0], at[1])));
      EXPECT_FALSE(isBlue(pixelAt(image, away[0], away[1])));
    }
  }
}

TEST(LobeView, TheLengthScalesTheLobe) {
  const auto source = material("Lambertian");
  vtkNew<vtkBRDFLobeView> view;
  view->AddInputConnection(source->GetOutputPort());
  vtkNew<vtkImageData> full, half;
  ASSERT_TRUE(view->Capture(full));
  view->SetLength(2 / kPi);
  ASSERT_TRUE(view->Capture(half));
  const double ratio = static_cast<double>(count(full, isBlue)) / static_cast<double>(count(half, isBlue));
  EXPECT_NEAR(ratio, 4, 0.35);  // areas; perspective and the legend's key make it not exactly 4
}

TEST(LobeView, TheSamePictureTwice) {
  const auto a = material("GGX(alpha=0.3)"), b = material("Lambertian");
  vtkNew<vtkImageData> images[2];
  for (auto& image : images) {
    vtkNew<vtkBRDFLobeView> view;
    view->SetSize(300, 200);
    view->AddInputConnection(a->GetOutputPort(), "A");
    view->AddInputConnection(b->GetOutputPort(), "B");
    ASSERT_TRUE(view->Capture(image));
    EXPECT_EQ(view->GetNumberOfInputs(), 2);
  }
  EXPECT_EQ(std::memcmp(images[0]->GetScalarPointer(), images[1]->GetScalarPointer(), 300 * 200 * 3), 0);
}

TEST(LobeView, DrawsIntoAWindowThatItIsGiven) {
  const auto source = material("Lambertian");
  vtkNew<vtkBRDFHeadlessRenderWindow> window;
  window->SetSize(400, 300);
  {
    vtkNew<vtkBRDFLobeView> view;
    view->SetRenderWindow(window);
    view->AddInputConnection(source->GetOutputPort());
    ASSERT_TRUE(view->Render());
    EXPECT_TRUE(window->HasRenderer(view->GetRenderer()));
  }
  EXPECT_EQ(window->GetRenderers()->GetNumberOfItems(), 0);
}

TEST(ErrorMapView, AConstantErrorIsOneColour) {
  const auto a = material("0.9*Lambertian"), b = material("0.4*Lambertian");
  vtkNew<vtkBRDFErrorMapView> view;
  view->SetInputConnection(0, a->GetOutputPort());
  view->SetInputConnection(1, b->GetOutputPort());
  vtkNew<vtkImageData> image;
  ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
  // The end of viridis, over the map: at least a third of the picture.
  const auto yellow = [](const Pixel& p) { return p == Pixel{253, 231, 37}; };
  EXPECT_GT(count(image, yellow), 900u * 700 / 3);
  view->GetErrorMap()->SetMeasure("difference");
  ASSERT_TRUE(view->Capture(image));
  EXPECT_GT(count(image, [](const Pixel& p) { return p == Pixel{180, 4, 38}; }), 900u * 700 / 3);  // A above B: red
}

TEST(ErrorMapView, NoDifferenceIsDrawnToo) {
  const auto a = material("Lambertian");
  vtkNew<vtkBRDFErrorMapView> view;
  view->SetInputConnection(0, a->GetOutputPort());
  view->SetInputConnection(1, a->GetOutputPort());
  for (const char* scale : {"auto", "log", "linear"}) {
    view->SetScale(scale);
    EXPECT_TRUE(view->Render()) << view->GetErrorText();
  }
  const ExpectErrors errors;
  view->SetScale("cubic");
  EXPECT_FALSE(view->Render());
  EXPECT_NE(view->GetErrorText().find("auto, linear, log"), std::string::npos);
}

TEST(View, FailsWithAReasonAndWritesNothing) {
  const ExpectErrors errors;
  vtkNew<vtkBRDFLobeView> empty;
  EXPECT_FALSE(empty->Render());
  EXPECT_NE(empty->GetErrorText().find("nothing to draw"), std::string::npos);

  const std::filesystem::path folder = testFolder("views");
  const auto bad = material("Nonsense"), good = material("Lambertian");
  vtkNew<vtkBRDFLobeView> view;
  view->SetSize(100, 100);
  view->AddInputConnection(bad->GetOutputPort());
  EXPECT_FALSE(view->WritePNG(folder / "bad.png"));
  EXPECT_NE(view->GetErrorText().find("Nonsense"), std::string::npos) << view->GetErrorText();
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  view->RemoveAllInputs();
  view->AddInputConnection(good->GetOutputPort());
  EXPECT_FALSE(view->WritePNG(folder / "missing" / "good.png"));
  EXPECT_NE(view->GetErrorText().find("missing"), std::string::npos);
  EXPECT_TRUE(view->WritePNG(folder / "good.png"));
  EXPECT_GT(std::filesystem::file_size(folder / "good.png"), 1000u);
}

}  // namespace
}  // namespace brdf
