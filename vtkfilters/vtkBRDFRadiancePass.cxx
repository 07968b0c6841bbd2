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
#include <brdf/models/Model.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkBRDFRadiancePass);

namespace
{
std::unique_ptr<vtkOpenGLQuadHelper> MakeQuad(vtkOpenGLRenderWindow* window,
                                              const char* fragmentFile,
                                              const std::string& declarations)
{
  const std::string vertex(vtkBRDFShaderText::File("brdf_background.vert.glsl"));
  std::string fragment(vtkBRDFShaderText::File(fragmentFile));
  vtkShaderProgram::Substitute(fragment, "//BRDF::Map::Dec", declarations, false);
  auto quad = std::make_unique<vtkOpenGLQuadHelper>(window, vertex.c_str(), fragment.c_str(), "");
  if (!quad->Program)
  {
    throw brdf::Error(brdf::Error::Kind::Device, { "a shader does not compile", fragmentFile, {}, {} });
  }
  return quad;
}
}

vtkBRDFRadiancePass::vtkBRDFRadiancePass()
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
    this->Pixels.clear();
    this->ErrorText = error.what();
  }
  window->GetState()->PopFramebufferBindings();
}

void vtkBRDFRadiancePass::Draw(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* gl = window->GetState();
  GLint largest = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
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
  this->Buffer->SetContext(window);
  if (width != this->BufferSize[0] || height != this->BufferSize[1]) // VTK would make it anew every time
  {
    this->BufferSize[0] = 0;
    if (!this->Buffer->PopulateFramebuffer(width, height, true, 1, VTK_FLOAT, true, 32, 0))
    {
      throw brdf::Error(brdf::Error::Kind::Device,
                        { "OpenGL device without a framebuffer of 32-bit floats", {}, {}, {} });
    }
    std::copy_n(this->Size, 2, this->BufferSize);
  }
  if (this->AfterFrame)
  {
    this->DrawFrames(state);
    gl->vtkglEnable(GL_BLEND);
    return;
  }
  this->DrawFrame(state, 0, nullptr, this->Pixels);
  if (this->EdgeSamples > 1)
  {
    const std::vector<float> mask = this->FindEdges(renderer);
    if (std::find(mask.begin(), mask.end(), 1.0f) != mask.end())
    {
      this->DrawEdges(state, mask);
    }
  }
  gl->vtkglEnable(GL_BLEND);
}

void vtkBRDFRadiancePass::DrawFrames(const vtkRenderState* state)
{
  vtkCamera* camera = state->GetRenderer()->GetActiveCamera();
  double center[2];
  camera->GetWindowCenter(center);
  int frame = 0;
  do
  {
    camera->SetWindowCenter(center[0] + 2 * this->Offset[0] / this->Size[0],
                            center[1] + 2 * this->Offset[1] / this->Size[1]);
    this->DrawFrame(state, frame++, nullptr, this->Pixels);
    camera->SetWindowCenter(center[0], center[1]);
  } while (this->AfterFrame());
}

// Draws the scene; where the renderer preserves its depth buffer, only into what is open in it.
void vtkBRDFRadiancePass::DrawFrame(const vtkRenderState* state,
                                    int frame,
                                    const std::vector<float>* wanted,
                                    std::vector<float>& pixels)
{
  const int width = this->Size[0], height = this->Size[1];
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* gl = window->GetState();
  if (this->BeforeFrame)
  {
    this->BeforeFrame(frame, wanted);
  }
  this->Buffer->Bind();
  this->Buffer->StartNonOrtho(width, height);
  gl->vtkglViewport(0, 0, width, height);
  gl->vtkglScissor(0, 0, width, height);
  gl->vtkglEnable(GL_DEPTH_TEST);
  gl->vtkglDisable(GL_BLEND);
  gl->vtkglDepthFunc(GL_LEQUAL);
  vtkRenderState drawing(renderer);
  drawing.SetPropArrayAndCount(state->GetPropArray(), state->GetPropArrayCount());
  drawing.SetFrameBuffer(this->Buffer);
  this->Opaque->Render(&drawing);
  this->NumberOfRenderedProps = this->Opaque->GetNumberOfRenderedProps();
  if (this->Background)
  {
    this->DrawBackground(renderer, window);
  }
  this->Buffer->Bind();
  this->Buffer->ActivateReadBuffer(0);
  pixels.resize(std::size_t{ 4 } * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels.data());
}

// 1 for the pixels of a frame just drawn next to a silhouette or a step in depth, else 0.
std::vector<float> vtkBRDFRadiancePass::FindEdges(vtkRenderer* renderer)
{
  const int width = this->Size[0], height = this->Size[1];
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<float> depth(count), mask(count, 0.0f);
  glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
  // Distances along the view; nothing is at 1.
  double range[2];
  renderer->GetActiveCamera()->GetClippingRange(range);
  const bool parallel = renderer->GetActiveCamera()->GetParallelProjection() != 0;
  std::vector<float> distance(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double z = depth[i];
    distance[i] = static_cast<float>(z >= 1     ? 1e30
                                     : parallel ? range[0] + z * (range[1] - range[0])
                                                : range[0] * range[1] / (range[1] - z * (range[1] - range[0])));
  }
  const auto step = static_cast<float>(this->DepthStep);
  const auto mark = [&](std::ptrdiff_t at, std::ptrdiff_t stride)
  {
    // Second differences: a slope is no edge. A silhouette in front of nothing is one by any measure.
    const auto i = static_cast<std::size_t>(at);
    const float before = distance[static_cast<std::size_t>(at - stride)], here = distance[i],
                after = distance[static_cast<std::size_t>(at + stride)];
    if (std::abs(before - here - (here - after)) > step)
    {
      mask[static_cast<std::size_t>(at - stride)] = mask[i] = mask[static_cast<std::size_t>(at + stride)] = 1.0f;
    }
  };
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(y) * width + x;
      if (x > 0 && x + 1 < width)
      {
        mark(at, 1);
      }
      if (y > 0 && y + 1 < height)
      {
        mark(at, width);
      }
    }
  }
  return mask;
}

void vtkBRDFRadiancePass::DrawEdges(const vtkRenderState* state, const std::vector<float>& mask)
{
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkCamera* camera = renderer->GetActiveCamera();
  double center[2];
  camera->GetWindowCenter(center);
  vtkNew<vtkTextureObject> texture;
  texture->SetContext(window);
  texture->Create2DFromRaw(static_cast<unsigned int>(this->Size[0]),
                           static_cast<unsigned int>(this->Size[1]),
                           1,
                           VTK_FLOAT,
                           const_cast<float*>(mask.data())); // VTK's signature; it reads only
  std::vector<float> sum(this->Pixels.size(), 0.0f), pixels;
  renderer->PreserveDepthBufferOn();
  for (int sample = 0; sample < this->EdgeSamples; ++sample)
  {
    // Points of the R2 sequence (M. Roberts, 2018) over the pixel, the first its centre.
    const double x = std::fmod(0.5 + 0.7548776662466927 * sample, 1) - 0.5;
    const double y = std::fmod(0.5 + 0.5698402909980532 * sample, 1) - 0.5;
    camera->SetWindowCenter(center[0] + 2 * x / this->Size[0], center[1] + 2 * y / this->Size[1]);
    this->DrawMask(texture, window);
    this->DrawFrame(state, sample, &mask, pixels);
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      for (std::size_t channel = 0; channel < 4 && mask[i] > 0; ++channel)
      {
        sum[4 * i + channel] += pixels[4 * i + channel];
      }
    }
  }
  renderer->PreserveDepthBufferOff();
  camera->SetWindowCenter(center[0], center[1]);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    for (std::size_t channel = 0; channel < 4 && mask[i] > 0; ++channel)
    {
      this->Pixels[4 * i + channel] = sum[4 * i + channel] / static_cast<float>(this->EdgeSamples);
    }
  }
}

void vtkBRDFRadiancePass::DrawMask(vtkTextureObject* mask, vtkOpenGLRenderWindow* window)
{
  if (!this->MaskQuad)
  {
    this->MaskQuad = MakeQuad(window, "brdf_mask.frag.glsl", {});
  }
  window->GetShaderCache()->ReadyShaderProgram(this->MaskQuad->Program);
  vtkOpenGLState* gl = window->GetState();
  this->Buffer->Bind();
  this->Buffer->StartNonOrtho(this->Size[0], this->Size[1]);
  gl->vtkglViewport(0, 0, this->Size[0], this->Size[1]);
  gl->vtkglDisable(GL_SCISSOR_TEST);
  gl->vtkglEnable(GL_DEPTH_TEST);
  gl->vtkglDepthMask(GL_TRUE);
  gl->vtkglDepthFunc(GL_ALWAYS);
  gl->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  mask->Activate();
  this->MaskQuad->Program->SetUniformi("brdfMask", mask->GetTextureUnit());
  this->MaskQuad->Render();
  mask->Deactivate();
  gl->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl->vtkglDepthFunc(GL_LEQUAL);
}

void vtkBRDFRadiancePass::DrawBackground(vtkRenderer* renderer, vtkOpenGLRenderWindow* window)
{
  auto& quad = this->UnfilteredBackground ? this->UnfilteredQuad : this->BackgroundQuad;
  if (!quad)
  {
    std::string declarations(vtkBRDFShaderText::File("brdf_map.glsl"));
    if (this->UnfilteredBackground)
    {
      declarations = brdf::Model::glslPrelude() + std::string(vtkBRDFShaderText::File("brdf_light.glsl")) +
                     "#define BRDF_UNFILTERED\n" + declarations;
    }
    quad = MakeQuad(window, "brdf_background.frag.glsl", declarations);
  }
  window->GetShaderCache()->ReadyShaderProgram(quad->Program);
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
  this->Background->UpdateTextures(window, this->UnfilteredBackground);
  this->Background->ActivateTextures();
  vtkShaderProgram* program = quad->Program;
  program->SetUniformMatrix("brdfClipToEnvironment", matrix);
  program->SetUniformf("brdfLevel", static_cast<float>(this->BackgroundLevel));
  program->SetUniformf("brdfGain", static_cast<float>(this->BackgroundGain));
  this->Background->SetUniforms(program);
  vtkOpenGLState* gl = window->GetState();
  gl->vtkglDepthFunc(GL_LEQUAL);
  gl->vtkglDepthMask(GL_FALSE);
  quad->Render();
  gl->vtkglDepthMask(GL_TRUE);
  this->Background->DeactivateTextures();
}

void vtkBRDFRadiancePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Buffer->ReleaseGraphicsResources(window);
  this->BufferSize[0] = 0;
  this->Opaque->ReleaseGraphicsResources(window);
  this->BackgroundQuad.reset();
  this->UnfilteredQuad.reset();
  this->MaskQuad.reset();
}
