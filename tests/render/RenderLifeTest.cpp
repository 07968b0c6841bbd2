// What renders for hours: sweeps of parameters, windows that come and go, pictures of many sizes. No OpenGL error (the
// fixture fails on any message of VTK, and drains glGetError itself), no compilation, nothing left behind.
#include "RenderScene.h"

#include <vtkActor.h>
#include <vtkBRDFPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkWindowToImageFilter.h>

#include <dlfcn.h>

#include <cstdint>
#include <fstream>

namespace {

using rendertest::Render;
using rendertest::Rgb;

/// An OpenGL function of the context that is current.
template <class Function>
Function openGl(const char* name) {
  static void* library = dlopen("libGL.so.1", RTLD_NOW | RTLD_GLOBAL);
  static void* other = library ? library : dlopen("libOpenGL.so.0", RTLD_NOW | RTLD_GLOBAL);
  return reinterpret_cast<Function>(other ? dlsym(other, name) : nullptr);
}

/// OpenGL's first error since the last call, 0 for none.
unsigned int openGlError() {
  static const auto getError = openGl<unsigned int (*)()>("glGetError");
  return getError ? getError() : ~0u;
}

/// Textures, buffers and programs alive in the current context, by asking for each of the first numbers.
int openGlObjects() {
  using Asks = unsigned char (*)(unsigned int);
  int count = 0;
  for (const char* name : {"glIsTexture", "glIsBuffer", "glIsProgram", "glIsFramebuffer", "glIsShader"}) {
    const auto asks = openGl<Asks>(name);
    if (!asks) return -1;
    for (unsigned int number = 1; number < 4000; ++number) count += asks(number) != 0;
  }
  return count;
}

/// Resident memory of the process in MiB.
double residentMemory() {
  std::ifstream file("/proc/self/statm");
  double size = 0, resident = 0;
  file >> size >> resident;
  return resident * 4096 / (1 << 20);
}

class RenderLife : public Render {
 protected:
  /// What is left of the window's OpenGL errors; the window of the last drawing is current.
  void expectNoError() { EXPECT_EQ(openGlError(), 0u); }
};

/// A window that leaves its context current where VTK frees what it held, as vtkGenericOpenGLRenderWindow does.
class ForgetfulWindow : public vtkBRDFHeadlessRenderWindow {
 public:
  static ForgetfulWindow* New();
  vtkTypeMacro(ForgetfulWindow, vtkBRDFHeadlessRenderWindow);
  void PushContext() override { MakeCurrent(); }
  void PopContext() override {}
};
vtkStandardNewMacro(ForgetfulWindow);

/// A window of a user's own with a mapper that may move between windows.
template <class Window = vtkBRDFHeadlessRenderWindow>
struct OwnWindow {
  OwnWindow() {
    window->SetSize(40, 40);
    window->AddRenderer(renderer);
    renderer->AutomaticLightCreationOff();
  }
  void show(vtkActor* actor) {
    renderer->AddActor(actor);
    renderer->ResetCamera();
  }
  Rgb middle() {
    window->Render();
    vtkNew<vtkWindowToImageFilter> capture;
    capture->SetInput(window);
    capture->ReadFrontBufferOff();
    capture->ShouldRerenderOff();
    capture->Update();
    const auto* rgb = static_cast<const unsigned char*>(capture->GetOutput()->GetScalarPointer(20, 20, 0));
    return {double(rgb[0]), double(rgb[1]), double(rgb[2])};
  }
  vtkNew<Window> window;
  vtkNew<vtkRenderer> renderer;
};

/// A sphere that lights up in a white furnace.
struct OwnSphere {
  OwnSphere() {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(64);
    sphere->SetPhiResolution(64);
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkBRDF> material;
    material->SetBrdf(brdf::parseMaterialExpression("(0.8,0.4,0.2)*Lambertian + 0.05*GGX(alpha=0.3)"));
    mapper->SetBRDFData(material);
    mapper->SetEnvironment(environment);
    mapper->EncodeForDisplayOn();
    actor->SetMapper(mapper);
  }
  vtkNew<vtkBRDFPolyDataMapper> mapper;
  vtkNew<vtkBRDFEnvironment> environment;
  vtkNew<vtkActor> actor;
};

}  // namespace

TEST_F(RenderLife, AThousandStepsOfAParameterLeaveNothingBehind) {
  render_->SetSize(8, 8);
  render_->SetNumberOfSamples(8);
  render_->SetEnvironment(environment_);
  const auto step = [&](int number) {
    const double t = number / 1000.0;
    draw("(" + std::to_string(t) + ",0.2,0.3)*Lambertian + " + std::to_string(1 - t) +
         "*GGX(alpha=" + std::to_string(0.01 + 0.9 * t) + ", ior=" + std::to_string(1.2 + t) +
         ") + 0.1*Ward(ax=0.2, ay=" + std::to_string(0.1 + 0.3 * t) + ")");
  };
  for (int number = 0; number < 50; ++number) step(number);  // what is made once is there
  const int builds = render_->GetNumberOfShaderBuilds(), objects = openGlObjects();
  const double memory = residentMemory();
  ASSERT_GT(objects, 5);
  for (int number = 50; number < 1050; ++number) {
    step(number % 1000);
    ASSERT_EQ(openGlError(), 0u) << number;
  }
  EXPECT_EQ(render_->GetNumberOfShaderBuilds(), builds);
  EXPECT_EQ(openGlObjects(), objects);
  // A leak of a picture or an expression a step would be 1 kB and more: 1 MiB.
  EXPECT_LT(residentMemory() - memory, 1);
}

TEST_F(RenderLife, ModesAndMapsComeAndGo) {
  render_->SetSize(8, 8);
  render_->SetEnvironment(environment_);
  render_->SetMaximumSamples(16);
  const auto round = [&](int number) {
    render_->SetMode(number % 2);
    environment_->SetConstant(1, 1 + number % 3, 1);
    draw("0.5*Lambertian + GGX(alpha=0.3)");
    EXPECT_NEAR(pixel(4, 4)[1] / pixel(4, 4)[0], 1 + number % 3, 0.02);
  };
  for (int number = 0; number < 6; ++number) round(number);
  const int objects = openGlObjects();
  for (int number = 6; number < 36; ++number) {
    round(number);
    expectNoError();
  }
  EXPECT_EQ(openGlObjects(), objects);
}

TEST_F(RenderLife, EverySizeInTurn) {
  render_->SetEnvironment(environment_);
  for (const int mode : {vtkBRDFRender::MODE_INTERACTIVE, vtkBRDFRender::MODE_CONVERGING}) {
    render_->SetMode(mode);
    render_->SetMaximumSamples(16);
    for (const auto& [width, height] : {std::pair{64, 64}, {1, 1}, {200, 3}, {16, 16}, {3, 200}, {64, 64}}) {
      render_->SetSize(width, height);
      draw("0.5*Lambertian");
      ASSERT_EQ(render_->GetOutput()->GetDimensions()[0], width);
      ASSERT_EQ(render_->GetOutput()->GetDimensions()[1], height);
      EXPECT_NEAR(pixel(width / 2, height / 2)[0], 0.5, 0.15) << width << " x " << height;
      expectNoError();
    }
  }
}

TEST_F(RenderLife, AMapperMovesToAnotherWindow) {
  OwnSphere sphere;
  OwnWindow<> first;
  first.show(sphere.actor);
  const Rgb before = first.middle();
  EXPECT_GT(before[0], before[1] + 20);
  {
    OwnWindow<> second;
    first.renderer->RemoveActor(sphere.actor);
    second.show(sphere.actor);
    EXPECT_EQ(second.middle(), before);
    expectNoError();
    second.renderer->RemoveActor(sphere.actor);
  }  // this window is gone, and with it what the mapper had there
  first.show(sphere.actor);
  EXPECT_EQ(first.middle(), before);
  expectNoError();
}

TEST_F(RenderLife, WindowsAreDestroyedAndMadeAnewUnderAMapper) {
  OwnSphere sphere;
  Rgb before{};
  for (int round = 0; round < 6; ++round) {
    OwnWindow<> window;
    window.window->SetSize(40, 40);
    window.show(sphere.actor);
    if (round == 3) continue;  // never drawn
    const Rgb found = window.middle();
    if (round == 0) before = found;
    EXPECT_EQ(found, before) << round;
    expectNoError();
  }
}

TEST_F(RenderLife, AWindowKeepsItsMapperWhileOthersThatShareItComeAndGo) {
  OwnSphere sphere;
  OwnWindow<> kept;
  kept.show(sphere.actor);
  const Rgb before = kept.middle();
  const int objects = openGlObjects();
  for (int round = 0; round < 4; ++round) {
    OwnWindow<> passing;
    passing.show(sphere.actor);
    EXPECT_EQ(passing.middle(), before) << round;
    expectNoError();
    if (round % 2) passing.renderer->RemoveActor(sphere.actor);
    EXPECT_EQ(kept.middle(), before) << round;
    expectNoError();
    EXPECT_EQ(openGlObjects(), objects) << round;
  }
  EXPECT_EQ(kept.middle(), before);
}

// Both kinds of window: those that go back to the context that was current, and those that do not.
template <class Window>
class TwoWindows : public RenderLife {};
using Windows = testing::Types<vtkBRDFHeadlessRenderWindow, ForgetfulWindow>;
TYPED_TEST_SUITE(TwoWindows, Windows);

TYPED_TEST(TwoWindows, DrawAMapperInTurn) {
  OwnSphere sphere;
  OwnWindow<TypeParam> first, second;
  first.show(sphere.actor);
  second.show(sphere.actor);
  const Rgb before = first.middle();
  EXPECT_GT(before[0], before[1] + 20);
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(second.middle(), before) << round;
    this->expectNoError();
    EXPECT_EQ(first.middle(), before) << round;
    this->expectNoError();
  }
}

TYPED_TEST(TwoWindows, LightTwoMappersWithOneEnvironment) {
  OwnSphere one, two;
  two.mapper->SetEnvironment(one.environment);
  for (const int mode : {vtkBRDFPolyDataMapper::MODE_INTERACTIVE, vtkBRDFPolyDataMapper::MODE_CONVERGING}) {
    one.mapper->SetMode(mode);
    two.mapper->SetMode(mode);
    OwnWindow<TypeParam> first;
    first.show(one.actor);
    Rgb before{};
    {
      OwnWindow<TypeParam> second;
      second.show(two.actor);
      before = first.middle();
      EXPECT_GT(before[0], before[1] + 20);
      for (int round = 0; round < 3; ++round) {
        EXPECT_EQ(second.middle(), before) << round;
        this->expectNoError();
        EXPECT_EQ(first.middle(), before) << round;
        this->expectNoError();
      }
      one.environment->SetConstant(1, 0, 0);  // new light for both
      EXPECT_EQ(second.middle()[1], 0);
      EXPECT_EQ(first.middle()[1], 0);
      one.environment->SetConstant(1, 1, 1);
      EXPECT_EQ(second.middle(), before);
    }
    EXPECT_EQ(first.middle(), before) << "beside a window that is gone";
    this->expectNoError();
    first.renderer->RemoveActor(one.actor);
  }
}
