#include "vtkBRDFDeferredShading.h"

#include "vtkBRDFCompatibility.h"
#include VTK_BRDF_GL_LOADER_HEADER

#include "vtkBRDFShaderText.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <brdf/base/Error.h>

#include <array>
#include <map>
#include <utility>

struct vtkBRDFDeferredShading::Buffer
{
  vtkNew<vtkOpenGLFramebufferObject> Surface; // normals and places; tangents where they are needed
  std::array<int, 3> Shape{};                 // width, height, pictures
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
};

namespace
{
constexpr int kMostPixels = 1 << 24; // of 20 to 36 bytes

// Left, bottom, width and height.
std::array<int, 4> Viewport()
{
  std::array<int, 4> viewport{};
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  return viewport;
}
}

vtkBRDFDeferredShading::vtkBRDFDeferredShading() = default;
vtkBRDFDeferredShading::~vtkBRDFDeferredShading() = default;

std::shared_ptr<vtkBRDFDeferredShading::Buffer> vtkBRDFDeferredShading::BufferOf(vtkOpenGLRenderWindow* window)
{
  static std::map<vtkOpenGLRenderWindow*, std::weak_ptr<Buffer>> buffers;
  std::erase_if(buffers, [](const auto& entry) { return entry.second.expired(); });
  std::weak_ptr<Buffer>& known = buffers[window];
  std::shared_ptr<Buffer> buffer = known.lock();
  if (!buffer || buffer->Window != window) // another may have had this address
  {
    buffer = std::make_shared<Buffer>();
    buffer->Window = window;
    buffer->Surface->SetContext(window);
    known = buffer;
  }
  return buffer;
}

bool vtkBRDFDeferredShading::Possible()
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  const auto [left, bottom, width, height] = Viewport();
  return samples <= 1 && left >= 0 && bottom >= 0 && width > 0 && height > 0 &&
         static_cast<double>(left + width) * (bottom + height) <= kMostPixels;
}

std::string vtkBRDFDeferredShading::Outputs(const std::string& tangent)
{
  // VTK discards what is not above 0 in the last number.
  const std::string normal =
    "  gl_FragData[0] = vec4(normalVCVSOutput, cameraParallel != 0 ? gl_FragCoord.z : -vertexVC.z);\n";
  return tangent.empty() ? normal : normal + "  gl_FragData[1] = vec4(" + tangent + ", 0.0);\n";
}

bool vtkBRDFDeferredShading::Build(vtkOpenGLRenderWindow* window, const std::string& lighting)
{
  if (this->IsBuilt(window) && lighting == this->Lighting)
  {
    return false;
  }
  const std::string vertex(vtkBRDFShaderText::File("brdf_deferred.vert.glsl"));
  std::string fragment(vtkBRDFShaderText::File("brdf_deferred.frag.glsl"));
  vtkShaderProgram::Substitute(fragment, "//BRDF::Light::Dec", lighting, false);
  this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, vertex.c_str(), fragment.c_str(), "");
  if (!this->Quad->Program)
  {
    this->Quad.reset();
    throw brdf::Error(brdf::Error::Kind::Device, { "the shader of the material does not compile", {}, {}, {} });
  }
  this->Lighting = lighting;
  this->Window = window;
  return true;
}

// Draws into the window's buffer.
void vtkBRDFDeferredShading::Collect(vtkOpenGLRenderWindow* window,
                                     int pictures,
                                     const std::function<void()>& drawSurface)
{
  const auto [left, bottom, width, height] = Viewport();
  vtkOpenGLState* gl = window->GetState();
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  vtkOpenGLFramebufferObject* surface = this->Seen->Surface;
  // VTK would make it anew every time.
  std::array<int, 3>& shape = this->Seen->Shape;
  if (shape[0] != left + width || shape[1] != bottom + height || shape[2] < pictures)
  {
    shape = {};
    if (!surface->PopulateFramebuffer(left + width, bottom + height, true, pictures, VTK_FLOAT, true, 32, 0))
    {
      throw brdf::Error(brdf::Error::Kind::Device,
                        { "OpenGL device without framebuffers of 32-bit floats", {}, {}, {} });
    }
    shape = { left + width, bottom + height, pictures };
  }
  // What was drawn before hides the surface.
  gl->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(target));
  vtkTextureObject* depth = surface->GetDepthAttachmentAsTextureObject();
  depth->Activate();
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, left, bottom, left, bottom, width, height); // VTK's copies to the corner
  depth->Deactivate();
  surface->Bind();
  surface->ActivateDrawBuffers(static_cast<unsigned int>(pictures));
  gl->vtkglViewport(left, bottom, width, height);
  gl->vtkglScissor(left, bottom, width, height);
  const float nothing[] = { 0, 0, 0, 0 };
  for (int picture = 0; picture < pictures; ++picture)
  {
    glClearBufferfv(GL_COLOR, picture, nothing);
  }
  drawSurface();
}

void vtkBRDFDeferredShading::Draw(vtkRenderer* renderer,
                                  bool tangents,
                                  const std::function<void()>& drawSurface,
                                  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->Seen = BufferOf(window);
  vtkOpenGLState* gl = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(gl);
  vtkOpenGLState::ScopedglScissor scissor(gl);
  vtkOpenGLState::ScopedglEnableDisable blend(gl, GL_BLEND);
  gl->vtkglDisable(GL_BLEND);
  gl->PushFramebufferBindings();
  try
  {
    this->Collect(window, tangents ? 2 : 1, drawSurface);
  }
  catch (...)
  {
    gl->PopFramebufferBindings();
    throw;
  }
  gl->PopFramebufferBindings();

  window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  vtkShaderProgram* program = this->Quad->Program;
  vtkTextureObject* normals = this->Seen->Surface->GetColorAttachmentAsTextureObject(0);
  vtkTextureObject* directions = tangents ? this->Seen->Surface->GetColorAttachmentAsTextureObject(1) : nullptr;
  normals->Activate();
  program->SetUniformi("brdfSurfaceNormal", normals->GetTextureUnit());
  if (directions)
  {
    directions->Activate();
  }
  // Where any tangent will do the normal stands for none.
  program->SetUniformi("brdfSurfaceTangent", (directions ? directions : normals)->GetTextureUnit());
  vtkMatrix4x4 *worldToView, *worldToClip, *viewToClip; // transposed, as OpenGL takes them
  vtkMatrix3x3* rotation;
  auto* camera = static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera());
  camera->GetKeyMatrices(renderer, worldToView, rotation, viewToClip, worldToClip);
  vtkNew<vtkMatrix4x4> clipToView;
  vtkMatrix4x4::Invert(viewToClip, clipToView);
  program->SetUniformMatrix("brdfViewToClip", viewToClip);
  program->SetUniformMatrix("brdfClipToView", clipToView);
  program->SetUniformi("brdfParallel", camera->GetParallelProjection());
  setUniforms(program);
  vtkOpenGLState::ScopedglEnableDisable culling(gl, GL_CULL_FACE);
  gl->vtkglDisable(GL_CULL_FACE);
  this->Quad->Render();
  normals->Deactivate();
  if (directions)
  {
    directions->Deactivate();
  }
}

void vtkBRDFDeferredShading::Release()
{
  this->Quad.reset();
  this->Seen.reset();
}
