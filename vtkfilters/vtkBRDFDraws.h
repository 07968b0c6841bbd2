#ifndef vtkBRDFDraws_h
#define vtkBRDFDraws_h
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <brdf/material/Brdf.h>

#include <map>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

// Draws made in advance (brdf::ViewerDraws) of a shader's terms on a device, for each number of samples asked for.
class vtkBRDFDraws
{
public:
  // The terms (vtkBRDFShaderText::DrawnTerms); draws of the last ones are forgotten.
  void SetTerms(std::vector<brdf::BrdfPointer> terms);
  bool HasTerms() const { return !this->Terms.empty(); }
  void Release();

  // Makes and binds draws with `samples` of each term, where they are missing, until Deactivate. Throws brdf::Error.
  void Activate(vtkOpenGLRenderWindow* window, const std::vector<int>& samples);
  void SetUniforms(vtkShaderProgram* program) const;
  void Deactivate();

private:
  struct Buffer
  {
    std::vector<int> Shapes;
    std::vector<float> Units;
    vtkSmartPointer<vtkTextureObject> Texture;
  };
  Buffer Make(vtkOpenGLRenderWindow* window, const std::vector<int>& samples) const;

  std::vector<brdf::BrdfPointer> Terms;
  std::map<std::vector<int>, Buffer> Buffers; // by samples
  const Buffer* Current = nullptr;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
};
#endif
