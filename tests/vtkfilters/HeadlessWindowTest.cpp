#include "Support.h"

#include <gtest/gtest.h>

#include <vtkActor.h>
#include <vtkBRDFHeadlessRenderWindow.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>

namespace brdf {
namespace {

using test::Pixel;
using test::pixelAt;

/// A window of one background colour with a green triangle over its lower left half.
struct Scene {
  explicit Scene(double red) {
    window->SetSize(60, 40);
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(-10, -10, 0);
    points->InsertNextPoint(10, -10, 0);
    points->InsertNextPoint(-10, 10, 0);
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({0, 1, 2});
    vtkNew<vtkPolyData> triangle;
    triangle->SetPoints(points);
    triangle->SetPolys(cells);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(triangle);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0, 1, 0);
    actor->GetProperty()->LightingOff();
    renderer->AddActor(actor);
    renderer->SetBackground(red, 0, 0);
    renderer->GetActiveCamera()->ParallelProjectionOn();
    renderer->GetActiveCamera()->SetParallelScale(2);  // the corners of the window are inside the triangle's square
    renderer->GetActiveCamera()->SetPosition(0, 0, 1);
    renderer->GetActiveCamera()->SetClippingRange(0.5, 2);
    window->AddRenderer(renderer);
  }
  vtkSmartPointer<vtkImageData> draw() {
    window->Render();
    vtkNew<vtkWindowToImageFilter> capture;
    capture->SetInput(window);
    capture->ReadFrontBufferOff();
    capture->ShouldRerenderOff();
    capture->Update();
    return capture->GetOutput();
  }
  vtkNew<vtkBRDFHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
};

class HeadlessWindow : public testing::Test {
 protected:
  void SetUp() override {
    unsetenv("DISPLAY");
    vtkNew<vtkBRDFHeadlessRenderWindow> window;
    ASSERT_TRUE(window->IsAvailable()) << window->GetErrorText();
  }
};

TEST_F(HeadlessWindow, DrawsWithoutADisplay) {
  Scene scene(1);
  const auto image = scene.draw();
  EXPECT_EQ(image->GetDimensions()[0], 60);
  EXPECT_EQ(image->GetDimensions()[1], 40);
  EXPECT_EQ(pixelAt(image, 2, 2), (Pixel{0, 255, 0}));
  EXPECT_EQ(pixelAt(image, 57, 37), (Pixel{255, 0, 0}));
  EXPECT_NE(scene.window->GetDeviceDescription().find("OpenGL"), std::string::npos);
}

TEST_F(HeadlessWindow, SeveralWindowsTakeTurns) {
  Scene red(1), black(0);
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_EQ(pixelAt(red.draw(), 57, 37), (Pixel{255, 0, 0}));
    EXPECT_EQ(pixelAt(black.draw(), 57, 37), (Pixel{0, 0, 0}));
  }
}

TEST_F(HeadlessWindow, ResizesAndDrawsAgain) {
  Scene scene(1);
  scene.draw();
  for (int size : {500, 10, 200}) {
    scene.window->SetSize(size, size / 2);
    const auto image = scene.draw();
    EXPECT_EQ(image->GetDimensions()[0], size);
    EXPECT_EQ(image->GetDimensions()[1], size / 2);
    EXPECT_EQ(pixelAt(image, 0, 0), (Pixel{0, 255, 0}));
    EXPECT_EQ(pixelAt(image, size - 1, size / 2 - 1), (Pixel{255, 0, 0}));
  }
}

TEST_F(HeadlessWindow, LivesAndDiesInAnyOrder) {
  Scene survivor(1);
  survivor.draw();
  for (int round = 0; round < 10; ++round) {
    Scene other(0);
    if (round % 2) other.draw();
  }
  EXPECT_EQ(pixelAt(survivor.draw(), 57, 37), (Pixel{255, 0, 0}));
}

}  // namespace
}  // namespace brdf
