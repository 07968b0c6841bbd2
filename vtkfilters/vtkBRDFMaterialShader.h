#ifndef vtkBRDFMaterialShader_h
#define vtkBRDFMaterialShader_h
#include "vtkBRDFDraws.h"
#include "vtkBRDFShaderText.h"

#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <brdf/color/ColourSettings.h>
#include <brdf/sampling/DrawnTable.h>

#include <memory>
#include <optional>
#include <vector>

// The shader of a BRDF and what it reads on a device: its tables, draws and numbers.
class vtkBRDFMaterialShader
{
public:
  // How light from an environment is summed. With Filtered, Samples are those of all terms together.
  using Environment = vtkBRDFShaderText::Environment;

  // Takes a BRDF; throws brdf::Error where it cannot be drawn, and where there is none (null). Needs a current context.
  void Update(const brdf::BrdfPointer& brdf, const brdf::ColourNames& colours, double tolerance);

  // Present after Update.
  const vtkBRDFShaderText& Text() const { return *this->Shader; }
  // When the shader's text last changed.
  const vtkTimeStamp& StructureTime() const { return this->Structure; }
  // What is drawn of a BRDF that is no sum of lobes.
  const brdf::DrawnTable& Table() const { return this->Drawn; }

  // Binds what the shader reads, made where it is missing, until Deactivate. Throws brdf::Error.
  void Activate(vtkOpenGLRenderWindow* window, Environment environment, int samples);
  void SetUniforms(vtkShaderProgram* program) const;
  void Deactivate();

  // Forgets what is on a window's device.
  void Release(vtkOpenGLRenderWindow* window);

private:
  void Release();

  std::shared_ptr<const brdf::Brdf> Brdf;
  brdf::ColourNames Colours; // that the shader was made with
  double Tolerance = 0;      // likewise, of resampling
  std::optional<vtkBRDFShaderText> Shader;
  vtkTimeStamp Structure;
  brdf::DrawnTable Drawn;
  std::vector<vtkSmartPointer<vtkTextureObject>> Buffers; // of the shader, on the device of Window
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkBRDFDraws Draws;
  Environment Light = Environment::None; // of the drawing at hand
  std::vector<int> Samples;              // likewise, of each term
};
#endif
