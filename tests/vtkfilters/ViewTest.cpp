#include "../TestFolder.h"
#include "Support.h"

#include <brdf/geometry/Directions.h>

#include <gtest/gtest.h>

#include <vtkBRDFDirectionWidget.h>
#include <vtkBRDFErrorMap.h>
#include <vtkBRDFErrorMapView.h>
#include <vtkBRDFHeadlessRenderWindow.h>
#include <vtkBRDFHistogramView.h>
#include <vtkBRDFLobeView.h>
#include <vtkBRDFSource.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
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

/// The rows of the picture between `left` and `right` that hold a colour of the legend's keys.
int highestKey(vtkImageData* image, int left, int right) {
  for (int y = image->GetDimensions()[1] / 2; y > 0; --y)
    for (int x = left; x < right; ++x) {
      const Pixel p = pixelAt(image, x, y);
      if (*std::max_element(p.begin(), p.end()) - *std::min_element(p.begin(), p.end()) > 60) return y;
    }
  return 0;
}

TEST(LobeView, TheLegendOfUpToTenMaterialsStaysBelowThePicture) {
  for (int number = 1; number <= 10; ++number) {
    vtkNew<vtkBRDFLobeView> view;
    for (int k = 0; k < number; ++k) {
      const auto source = material("Lambertian");
      source->Update();
      view->AddInputData(source->GetOutput(), "material " + std::to_string(k));
    }
    view->SetTolerance(0);
    view->SetResolution(3);
    vtkNew<vtkImageData> image;
    ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
    const int text = 15, keys = highestKey(image, text, 2 * text);
    EXPECT_GT(keys, text);
    for (int phi = 0; phi < 360; phi += 30) {  // the labels of the azimuths
      const Direction rim = fromSpherical(kPi / 2, radians(phi));
      const auto label = projected(view, {1.08 * rim[0], 1.08 * rim[1], 0});
      EXPECT_GT(label[1], keys + text / 2) << number << " materials, label " << phi;
      EXPECT_GT(label[0], 0);
      EXPECT_LT(label[0], 900);
    }
  }
}

TEST(LobeView, SideBySideEachLobeHasItsPlace) {
  for (int number : {1, 2, 3, 5, 10})
    for (const auto& [width, height] : {std::pair{900, 700}, std::pair{360, 280}}) {
      vtkNew<vtkBRDFLobeView> view;
      view->SetSize(width, height);
      view->SetLayout("side");
      view->SetTolerance(0);
      view->SetResolution(3);
      for (int k = 0; k < number; ++k) {
        const auto source = material("Lambertian");
        source->Update();
        view->AddInputData(source->GetOutput(), "material " + std::to_string(k));
      }
      vtkNew<vtkImageData> image;
      ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
      // The first disc in full; every lobe the same number of pixels of its colour, within the edges'.
      const auto low = projected(view, {0.8, -0.8, 0}), high = projected(view, {-0.8, 0.8, 0});
      EXPECT_GE(std::min(low[0], high[0]), 0);
      EXPECT_LT(std::max(low[0], high[0]), width);
      EXPECT_GT(count(image, isBlue), 60u) << number;
    }
}

TEST(LobeView, ColoursAreApartFromTheLength) {
  const auto source = material("(0.9, 0.1, 0.1)*Lambertian");
  vtkNew<vtkBRDFLobeView> view;
  view->AddInputConnection(source->GetOutputPort());
  vtkNew<vtkImageData> image;
  const auto red = [](const Pixel& p) { return p[0] > 2 * p[1] && p[0] > 2 * p[2] && p[0] > 60; };
  const auto yellow = [](const Pixel& p) { return p[0] > 2 * p[2] + 20 && p[1] > 2 * p[2] + 20; };
  ASSERT_TRUE(view->Capture(image));
  EXPECT_GT(count(image, isBlue), 50000u);
  view->SetColour("true");
  ASSERT_TRUE(view->Capture(image));
  EXPECT_GT(count(image, red), 50000u);
  EXPECT_LT(count(image, isBlue), 2000u);
  for (const char* colour : {"value", "0", "luminance"}) {  // all of one value, the largest: the end of viridis
    view->SetColour(colour);
    ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
    EXPECT_GT(count(image, yellow), 50000u) << colour;
  }
  const ExpectErrors errors;
  view->SetColour("mauve");
  EXPECT_FALSE(view->Render());
  EXPECT_NE(view->GetErrorText().find("mauve"), std::string::npos);
}

TEST(LobeView, ADifferenceIsRedAboveAndBlueBelow) {
  const auto a = material("0.9*Lambertian"), b = material("0.4*Lambertian");
  const auto red = [](const Pixel& p) { return p[0] > p[2] + 50 && p[0] > p[1] + 50; };
  const auto blue = [](const Pixel& p) { return p[2] > p[0] + 50 && p[2] > p[1] + 50; };
  for (const char* shape : {"difference", "displaced"})
    for (bool exchanged : {false, true}) {
      vtkNew<vtkBRDFLobeView> view;
      view->AddInputConnection((exchanged ? b : a)->GetOutputPort());
      view->AddInputConnection((exchanged ? a : b)->GetOutputPort());
      view->SetShape(shape);
      vtkNew<vtkImageData> image;
      ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
      // The colour bar has both, a lobe many more; a hemisphere dented to nothing has no size.
      const bool visible = !exchanged || std::string(shape) == "difference";
      EXPECT_EQ(count(image, red) > 40000u, !exchanged) << shape;
      EXPECT_EQ(count(image, blue) > 40000u, exchanged && visible) << shape;
    }
  vtkNew<vtkBRDFLobeView> view;
  view->AddInputConnection(a->GetOutputPort());
  view->SetShape("difference");
  const ExpectErrors errors;
  EXPECT_FALSE(view->Render());
}

TEST(LobeView, SamplesStandInPlaceOfTheirLobe) {
  const auto b = material("0.4*Lambertian");
  vtkNew<vtkBRDFLobeView> view;
  view->AddInputData(test::tabulated("0.5*Lambertian"), "measured");
  view->AddInputConnection(b->GetOutputPort(), "model");
  view->ShowSamplesOn();
  view->SetSampleAngle(5);
  vtkNew<vtkImageData> image;
  ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
  // Every residual is the same and below 0: the dark blue end of the scale, in dots around the model's lobe.
  const auto blue = [](const Pixel& p) { return std::abs(p[0] - 59) < 12 && std::abs(p[2] - 192) < 12; };
  EXPECT_GT(count(image, blue), 500u);
  view->RemoveAllInputs();
  view->AddInputConnection(b->GetOutputPort());
  const ExpectErrors errors;
  EXPECT_FALSE(view->Render());
  EXPECT_NE(view->GetErrorText().find("no samples"), std::string::npos) << view->GetErrorText();
}

TEST(LobeView, DegenerateLobesAreDrawnToo) {
  const auto black = material("0*Lambertian");
  for (const char* colour : {"auto", "value", "0"})
    for (const char* transform : {"none", "logfloor"}) {
      vtkNew<vtkBRDFLobeView> view;
      view->SetSize(64, 64);
      view->AddInputConnection(black->GetOutputPort());
      view->SetColour(colour);
      view->SetTransform(transform);
      EXPECT_TRUE(view->Render()) << view->GetErrorText();
    }
}

/// One without a display: VTK's factory would make one of X11's.
class Interactor : public vtkRenderWindowInteractor {
 public:
  static Interactor* New() { VTK_STANDARD_NEW_BODY(Interactor); }
  vtkTypeMacro(Interactor, vtkRenderWindowInteractor);
};

/// Presses the left button at one place of the window, moves in steps to another and releases it.
void drag(vtkRenderWindowInteractor* interactor, std::array<int, 2> from, std::array<int, 2> to) {
  interactor->SetEventInformation(from[0], from[1]);
  interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  for (int step = 1; step <= 8; ++step) {
    interactor->SetEventInformation(from[0] + (to[0] - from[0]) * step / 8, from[1] + (to[1] - from[1]) * step / 8);
    interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  }
  interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
}

/// A point of the light's arrow, its middle.
Direction arrowAt(double theta, double phi) {
  Direction w = fromSpherical(radians(theta), radians(phi));
  for (double& x : w) x *= 1.175;
  return w;
}

TEST(DirectionWidget, DraggingTheArrowTurnsTheLightAndTheLobe) {
  const auto source = material("0.001*Lambertian + BlinnPhong(n=2000)");
  vtkNew<vtkBRDFHeadlessRenderWindow> window;
  window->SetSize(900, 700);
  vtkNew<Interactor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<vtkBRDFLobeView> view;
  view->AddInputConnection(source->GetOutputPort());
  view->EnableInteraction(interactor);
  view->SetResolution(3);
  ASSERT_TRUE(view->Render()) << view->GetErrorText();
  ASSERT_EQ(view->GetThetaI(), 45);

  // Beside the arrow nothing happens.
  drag(interactor, projected(view, {0, 0, 0.4}), projected(view, arrowAt(20, 0)));
  EXPECT_EQ(view->GetThetaI(), 45);

  struct Place {
    double theta, phi;
  } before{45, 0};
  for (const Place& place : {Place{30, 40}, Place{60, -50}, Place{20, -120}, Place{70, 20}}) {
    drag(interactor, projected(view, arrowAt(before.theta, before.phi)),
         projected(view, arrowAt(place.theta, place.phi)));
    EXPECT_NEAR(view->GetThetaI(), place.theta, 0.6)
        << place.theta;  // a pixel is a fifth of a degree, more at the limb
    EXPECT_NEAR(view->GetPhiI(), place.phi, 1.2) << place.theta;
    EXPECT_EQ(view->GetDirectionWidget()->GetTheta(), view->GetThetaI());
    before = {view->GetThetaI(), view->GetPhiI()};
    // The lobe stands in the new mirror direction.
    vtkNew<vtkWindowToImageFilter> capture;
    capture->SetInput(window);
    capture->SetReadFrontBuffer(false);
    capture->SetShouldRerender(false);
    capture->Update();
    Direction mirror = fromSpherical(radians(before.theta), radians(before.phi + 180));
    for (double& x : mirror) x *= 0.6;
    const auto at = projected(view, mirror);
    EXPECT_TRUE(isBlue(pixelAt(capture->GetOutput(), at[0], at[1]))) << place.theta;
  }
  // Pulled below the horizon it stays above.
  const auto horizon = projected(view, {1.0, -0.6, -0.2});
  drag(interactor, projected(view, arrowAt(before.theta, before.phi)), horizon);
  EXPECT_EQ(view->GetThetaI(), 89);
  view->EnableInteraction(nullptr);
  EXPECT_EQ(view->GetDirectionWidget(), nullptr);
  EXPECT_TRUE(view->Render());
}

TEST(DirectionWidget, TellsEachStep) {
  vtkNew<vtkBRDFHeadlessRenderWindow> window;
  window->SetSize(300, 300);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(0, 0, 10);
  renderer->GetActiveCamera()->SetParallelProjection(true);
  renderer->GetActiveCamera()->SetParallelScale(1.5);
  vtkNew<Interactor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<vtkBRDFDirectionWidget> widget;
  widget->SetInteractor(interactor);
  widget->SetCurrentRenderer(renderer);
  widget->SetTheta(30);
  widget->SetPhi(90);
  widget->On();
  renderer->ResetCameraClippingRange();
  window->Render();
  int steps = 0;
  vtkNew<vtkCallbackCommand> counted;
  counted->SetClientData(&steps);
  counted->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  widget->AddObserver(vtkCommand::InteractionEvent, counted);
  // Seen from above, a hundred pixels a unit: the middle of the arrow lies 1.175 sin(30 degrees) from the centre.
  drag(interactor, {150, 150 + 59}, {150 + 59, 150});
  EXPECT_EQ(steps, 8);
  EXPECT_NEAR(widget->GetTheta(), 30, 0.7);
  EXPECT_NEAR(widget->GetPhi(), 0, 0.7);
}

TEST(ErrorMapView, EveryKindOfAxesIsDrawn) {
  const auto a = material("0.3*Lambertian + 0.1*GGX(alpha=0.3)"), b = material("0.4*Lambertian");
  vtkNew<vtkBRDFErrorMapView> view;
  view->SetInputConnection(0, a->GetOutputPort());
  view->SetInputConnection(1, b->GetOutputPort());
  for (const char* axes : {"theta_i,theta_o", "theta_h,theta_d", "theta_d,phi_d", "hemisphere"})
    for (const char* measure : {"difference", "cuberoot"}) {
      view->GetErrorMap()->SetAxes(axes);
      view->GetErrorMap()->SetMeasure(measure);
      view->SetIntervals(12);
      view->SetSize(200, 160);
      EXPECT_TRUE(view->Render()) << axes << view->GetErrorText();
    }
  const ExpectErrors errors;
  view->GetErrorMap()->SetAxes("theta");
  EXPECT_FALSE(view->Render());
  EXPECT_NE(view->GetErrorText().find("hemisphere"), std::string::npos);
}

TEST(HistogramView, BarsStandOverTheirErrors) {
  const auto a = material("0.9*Lambertian"), b = material("0.4*Lambertian"), c = material("GGX(alpha=0.1)");
  vtkNew<vtkBRDFErrorMap> map;
  map->SetInputConnection(0, a->GetOutputPort());
  map->SetInputConnection(1, b->GetOutputPort());
  map->SetIntervals(9);
  vtkNew<vtkBRDFHistogramView> view;
  {
    const ExpectErrors errors;
    EXPECT_FALSE(view->Render());
  }
  view->SetErrorMap(map);
  vtkNew<vtkImageData> image;
  ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
  // One error: one bar, in the middle.
  EXPECT_TRUE(isBlue(pixelAt(image, (98 + 862) / 2 - 6, 200)));
  EXPECT_LT(count(image, isBlue), 900u * 700 / 10);
  map->SetInputConnection(0, c->GetOutputPort());
  ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
  EXPECT_GT(count(image, isBlue), 900u * 700 / 10);
}

}  // namespace
}  // namespace brdf
