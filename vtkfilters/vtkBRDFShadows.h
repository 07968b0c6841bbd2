#ifndef vtkBRDFShadows_h
#define vtkBRDFShadows_h
#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <brdf/render/ShadowCaster.h>

#include <memory>
#include <string>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;

// Shadows for vtkBRDFPolyDataMapper: rays cast on the CPU through the pixels of the picture about to be drawn, handed
// to the shader as a texture. Not wrapped: see vtkBRDFRender.
class vtkBRDFShadows
{
public:
  // Objects, lights (in the order of the renderer's) and environment, with cells of the latter: see brdf::ShadowMask.
  void SetScene(const brdf::Scene& scene, int cells)
  {
    this->Caster = std::make_unique<const brdf::ShadowCaster>(scene, static_cast<std::size_t>(cells));
  }

  // Casts rays for the renderer's camera as it stands; where `wanted` is given, through its pixels that are not 0.
  // Throws brdf::Error.
  void Cast(vtkRenderer* renderer, const int size[2], int seed, const std::vector<float>* wanted);

  // Binds the mask and gives it to the uniforms of brdf_shadows.glsl, until Deactivate.
  void Activate() { this->Texture->Activate(); }
  void SetUniforms(vtkShaderProgram* program);
  void Deactivate() { this->Texture->Deactivate(); }

  // Text of the shader, after the first Cast; `environment`: that there is one. It differs with Kind: 1 where the
  // lights besides the environment cast shadows, 2 where the environment does too.
  int Kind(bool environment) const { return environment && this->Mask.cells > 0 ? 2 : 1; }
  std::string Text(bool environment) const;

private:
  std::unique_ptr<const brdf::ShadowCaster> Caster;
  brdf::ShadowMask Mask;
  vtkNew<vtkTextureObject> Texture;
};
#endif
