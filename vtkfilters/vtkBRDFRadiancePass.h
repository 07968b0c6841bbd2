#ifndef vtkBRDFRadiancePass_h
#define vtkBRDFRadiancePass_h
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkBRDFEnvironment;
class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;

// Draws the opaque props of a renderer into a framebuffer of four 32-bit floats, over an environment or a plain colour,
// and keeps the result in memory. A window's own buffers have 8 bits. Not wrapped: see vtkBRDFRender.
class vtkBRDFRadiancePass : public vtkRenderPass
{
public:
  static vtkBRDFRadiancePass* New();
  vtkTypeMacro(vtkBRDFRadiancePass, vtkRenderPass);

  int Size[2] = { 512, 512 };
  int MultiSamples = 4;                     // along silhouettes; 0 for none; cut to what the device has
  vtkBRDFEnvironment* Background = nullptr; // null: the renderer's background colour, linear
  double BackgroundLevel = 0;               // mip level of the background
  double BackgroundGain = 1;

  // Result: R, G, B, A, rows from the bottom; empty when it failed, and then why, in one line.
  std::vector<float> Pixels;
  std::string ErrorText;

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkBRDFRadiancePass();
  ~vtkBRDFRadiancePass() override;

private:
  vtkBRDFRadiancePass(const vtkBRDFRadiancePass&) = delete;
  void operator=(const vtkBRDFRadiancePass&) = delete;

  void Draw(const vtkRenderState* state); // throws brdf::Error
  void DrawBackground(vtkRenderer* renderer, vtkOpenGLRenderWindow* window);

  vtkSmartPointer<vtkOpenGLFramebufferObject> Drawn, Resolved;
  vtkSmartPointer<vtkRenderPass> Opaque;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};
#endif
