#ifndef vtkBRDFRadiancePass_h
#define vtkBRDFRadiancePass_h
#include "vtkNew.h"
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkBRDFEnvironment;
class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRenderState;
class vtkTextureObject;

// Draws the opaque props of a renderer into a framebuffer of four 32-bit floats, over an environment or a plain colour,
// and keeps the result in memory. A window's own buffers have 8 bits. Pixels on silhouettes and creases are drawn again
// at other places inside the pixel and averaged; the rest is closed to the device by its depth buffer (multisampling
// would shade every sample of every pixel on software devices). Not wrapped: see vtkBRDFRender.
class vtkBRDFRadiancePass : public vtkRenderPass
{
public:
  static vtkBRDFRadiancePass* New();
  vtkTypeMacro(vtkBRDFRadiancePass, vtkRenderPass);

  int Size[2] = { 512, 512 };
  int EdgeSamples = 8;  // places in a pixel on an edge; 1: the centre only
  double DepthStep = 0; // distance along the view from which on two neighbours are different surfaces
  vtkBRDFEnvironment* Background = nullptr; // null: the renderer's background colour, linear
  double BackgroundLevel = 0;               // level of the map of the background
  double BackgroundGain = 1;
  bool UnfilteredBackground = false; // the map itself behind the scene, not the filtered one
  // Called before each drawing of the scene with 0, 1, ..., and the pixels that will be drawn: those that are not 0, or
  // all where it is null. May throw brdf::Error.
  std::function<void(int frame, const std::vector<float>* wanted)> BeforeFrame;

  // Where set, the scene is drawn again and again, all pixels at Offset (in pixels from their centres), until this
  // returns false. It finds the frame in Pixels and may change Offset. EdgeSamples is not used then.
  std::function<bool()> AfterFrame;
  double Offset[2] = { 0, 0 };

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
  void DrawFrame(const vtkRenderState* state, int frame, const std::vector<float>* wanted, std::vector<float>& pixels);
  void DrawFrames(const vtkRenderState* state);
  void DrawBackground(vtkRenderer* renderer, vtkOpenGLRenderWindow* window);
  void DrawMask(vtkTextureObject* mask, vtkOpenGLRenderWindow* window);
  std::vector<float> FindEdges(vtkRenderer* renderer);
  void DrawEdges(const vtkRenderState* state, const std::vector<float>& mask);

  vtkNew<vtkOpenGLFramebufferObject> Buffer;
  int BufferSize[2] = { 0, 0 };
  vtkSmartPointer<vtkRenderPass> Opaque;
  std::unique_ptr<vtkOpenGLQuadHelper> BackgroundQuad, UnfilteredQuad, MaskQuad;
};
#endif
