#ifndef vtkBRDFDeferredShading_h
#define vtkBRDFDeferredShading_h
#include "vtkWeakPointer.h"

#include <functional>
#include <memory>
#include <string>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;

// Draws a surface in two steps: first, for each pixel, the point of it that is seen there, by a shader that costs next
// to nothing; then light on those points, in one quadrilateral. Devices shade blocks of pixels together, at least 2 x 2
// of them and 4 x 2 in software, whatever part of them a triangle covers: on a mesh of triangles of a few pixels an
// expensive shader runs three times as long as on the quadrilateral.
class vtkBRDFDeferredShading
{
public:
  vtkBRDFDeferredShading();
  ~vtkBRDFDeferredShading();

  // Whether the framebuffer that is bound can be drawn to so: it has one sample a pixel, and not too many pixels.
  static bool Possible();

  // The program that shades, by `lighting`: GLSL with brdfReflected of brdf_surface.glsl. Whether it had to be built;
  // throws brdf::Error where it does not compile.
  bool Build(vtkOpenGLRenderWindow* window, const std::string& lighting);
  bool IsBuilt(vtkOpenGLRenderWindow* window) const { return this->Quad && this->Window == window; }

  // Lets `drawSurface` draw triangles, whose fragments write Outputs() in place of a colour, and shades what is seen of
  // them into the framebuffer that is bound, with its depths. `setUniforms` gets the program, bound.
  void Draw(vtkRenderer* renderer,
            bool tangents,
            const std::function<void()>& drawSurface,
            const std::function<void(vtkShaderProgram*)>& setUniforms);
  // GLSL assignments. `tangent`: an expression, in view coordinates; empty where the material needs none.
  static std::string Outputs(const std::string& tangent);

  void Release();

private:
  struct Buffer;
  static std::shared_ptr<Buffer> BufferOf(vtkOpenGLRenderWindow* window);
  void Collect(vtkOpenGLRenderWindow* window, int pictures, const std::function<void()>& drawSurface);

  std::shared_ptr<Buffer> Seen; // of a window: all mappers that draw in it take turns with one
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::string Lighting;                         // that Quad was made of
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // that it was made for
};
#endif
