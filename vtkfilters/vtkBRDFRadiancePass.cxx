#include "vtkBRDFRadiancePass.h"

#include "vtkBRDFCompatibility.h"
#include VTK_BRDF_GL_LOADER_HEADER

#include "vtkBRDFEnvironment.h"
#include "vtkBRDFShaderText.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkBRDFRadiancePass);

vtkBRDFRadiancePass::vtkBRDFRadiancePass()
  : Drawn(vtkSmartPointer<vtkOpenGLFramebufferObject>::New())
  , Resolved(vtkSmartPointer<vtkOpenGLFramebufferObject>::New())
{
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkSmartPointer<vtkLightsPass>::New());
  passes->AddItem(vtkSmartPointer<vtkOpaquePass>::New());
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  this->Opaque = camera;
}

vtkBRDFRadiancePass::~vtkBRDFRadiancePass() = default;

void vtkBRDFRadiancePass::Render(const vtkRenderState* state)
{
  // An exception through vtkRenderWindow::Render would leave the window marked as rendering.
  this->Pixels.clear();
  this->ErrorText.clear();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(state->GetRenderer()->GetRenderWindow());
  window->GetState()->PushFramebufferBindings();
  try
  {
    this->Draw(state);
  }
  catch (const std::exception& error)
  {
    this->ErrorText = error.what();
  }
  window->GetState()->PopFramebufferBindings();
}

void vtkBRDFRadiancePass::Draw(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* gl = window->GetState();
  GLint largest = 0, mostSamples = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  glGetIntegerv(GL_MAX_SAMPLES, &mostSamples);
  const int width = this->Size[0], height = this->Size[1];
  if (std::max(width, height) > largest)
  {
    throw brdf::Error(brdf::Error::Kind::Device,
                      { "picture too large for the OpenGL device",
                        {},
                        std::to_string(width) + " x " + std::to_string(height),
                        "at most " + std::to_string(largest) + " pixels a side" });
  }
  vtkOpenGLState::ScopedglViewport savedViewport(gl);
  vtkOpenGLState::ScopedglScissor savedScissor(gl);
  const int samples = std::min(this->MultiSamples, static_cast<int>(mostSamples));
  this->Drawn->SetContext(window);
  this->Resolved->SetContext(window);
  // Textures where there is one sample, renderbuffers where there are more.
  if (!this->Drawn->PopulateFramebuffer(width, height, samples == 0, 1, VTK_FLOAT, true, 32, samples) ||
      (samples > 0 && !this->Resolved->PopulateFramebuffer(width, height, true, 1, VTK_FLOAT, false, 0, 0)))
  {
    throw brdf::Error(brdf::Error::Kind::Device,
                      { "OpenGL device without a framebuffer of 32-bit floats", {}, {}, {} });
  }
  this->Drawn->Bind();
  this->Drawn->StartNonOrtho(width, height);
  gl->vtkglViewport(0, 0, width, height);
  gl->vtkglScissor(0, 0, width, height);
  gl->vtkglEnable(GL_DEPTH_TEST);
  gl->vtkglDisable(GL_BLEND);
  if (samples > 0)
  {
    gl->vtkglEnable(GL_MULTISAMPLE);
  }
  vtkRenderState drawing(renderer);
  drawing.SetPropArrayAndCount(state->GetPropArray(), state->GetPropArrayCount());
  drawing.SetFrameBuffer(this->Drawn);
  this->Opaque->Render(&drawing);
  this->NumberOfRenderedProps = this->Opaque->GetNumberOfRenderedProps();
  if (this->Background)
  {
    this->DrawBackground(renderer, window);
  }
  vtkOpenGLFramebufferObject* result = this->Drawn;
  if (samples > 0)
  {
    this->Drawn->Bind(GL_READ_FRAMEBUFFER);
    this->Drawn->ActivateReadBuffer(0);
    this->Resolved->Bind(GL_DRAW_FRAMEBUFFER);
    this->Resolved->ActivateDrawBuffer(0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    result = this->Resolved;
  }
  result->Bind(GL_READ_FRAMEBUFFER);
  result->ActivateReadBuffer(0);
  this->Pixels.resize(std::size_t{ 4 } * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, this->Pixels.data());
  gl->vtkglEnable(GL_BLEND);
}

void vtkBRDFRadiancePass::DrawBackground(vtkRenderer* renderer, vtkOpenGLRenderWindow* window)
{
  vtkTextureObject* texture = this->Background->GetRadianceTexture(window);
  if (!this->Quad)
  {
    this->Quad =
      std::make_unique<vtkOpenGLQuadHelper>(window,
                                            std::string(vtkBRDFShaderText::File("brdf_background.vert.glsl")).c_str(),
                                            std::string(vtkBRDFShaderText::File("brdf_background.frag.glsl")).c_str(),
                                            "");
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  if (!this->Quad->Program)
  {
    throw brdf::Error(brdf::Error::Kind::Device, { "the background's shader does not compile", {}, {}, {} });
  }
  // From clip coordinates to directions of the map: projection and view rotation undone, then the map's own rotation.
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> view, matrix;
  view->DeepCopy(camera->GetModelViewTransformMatrix());
  for (int axis = 0; axis < 3; ++axis)
  {
    view->SetElement(axis, 3, 0);
  }
  const double aspect = static_cast<double>(this->Size[0]) / this->Size[1];
  vtkMatrix4x4::Multiply4x4(camera->GetProjectionTransformMatrix(aspect, -1, 1), view, matrix);
  matrix->Invert();
  const double angle = vtkMath::RadiansFromDegrees(this->Background->GetRotation());
  vtkNew<vtkMatrix4x4> rotation;
  rotation->SetElement(0, 0, std::cos(angle));
  rotation->SetElement(0, 2, -std::sin(angle));
  rotation->SetElement(2, 0, std::sin(angle));
  rotation->SetElement(2, 2, std::cos(angle));
  vtkMatrix4x4::Multiply4x4(rotation, matrix, matrix);
  matrix->Transpose(); // OpenGL takes columns first
  texture->Activate();
  vtkShaderProgram* program = this->Quad->Program;
  program->SetUniformMatrix("brdfClipToEnvironment", matrix);
  program->SetUniformf("brdfLevel", static_cast<float>(this->BackgroundLevel));
  program->SetUniformf("brdfGain", static_cast<float>(this->BackgroundGain));
  program->SetUniformi("brdfRadianceMap", texture->GetTextureUnit());
  vtkOpenGLState* gl = window->GetState();
  gl->vtkglDepthFunc(GL_LEQUAL);
  gl->vtkglDepthMask(GL_FALSE);
  this->Quad->Render();
  gl->vtkglDepthMask(GL_TRUE);
  texture->Deactivate();
}

void vtkBRDFRadiancePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Drawn->ReleaseGraphicsResources(window);
  this->Resolved->ReleaseGraphicsResources(window);
  this->Opaque->ReleaseGraphicsResources(window);
  if (this->Quad)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
}
