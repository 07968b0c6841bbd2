#ifndef vtkBRDFShaderProbe_h
#define vtkBRDFShaderProbe_h
#include "vtkBRDFFiltersModule.h" // For export macro

#include "vtkNew.h" // For vtkNew

#include <string> // For std::string
#include <vector> // For std::vector

class vtkBRDFHeadlessRenderWindow;

/**
 * @class vtkBRDFShaderProbe
 * @brief Values of GLSL expressions for many inputs
 *
 * Runs GLSL where pictures run it, in a fragment shader on a headless context, one fragment an input, and reads the
 * 32-bit floats back: how the GLSL of a formula is held against its value on the processor. One thread at a time.
 * C++ only; throws brdf::Error (kind Device).
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFShaderProbe
{
public:
  struct Column
  {
    std::string Name;
    std::vector<float> Values;
  };

  /** A samplerBuffer that the functions declare, with its texels of four floats. */
  struct Buffer
  {
    std::string Name;
    std::vector<float> Texels;
  };

  /** Throws when there is no headless OpenGL 3.3 context. */
  vtkBRDFShaderProbe();
  ~vtkBRDFShaderProbe();
  vtkBRDFShaderProbe(const vtkBRDFShaderProbe&) = delete;
  void operator=(const vtkBRDFShaderProbe&) = delete;

  /**
   * The `expressions` (1 to 4, each a float, over the names of the columns and the `functions`, GLSL 3.30 without
   * #version) for each row of `columns`, which all have the same length: result[k][i] is expression k at row i.
   * An error of compilation names the line and shows it.
   */
  std::vector<std::vector<float>> Evaluate(
    const std::string& functions, const std::vector<Column>& columns, const std::vector<std::string>& expressions,
    const std::vector<Buffer>& buffers = {});

  /** OpenGL's own name and version. */
  std::string GetDeviceDescription();

private:
  vtkNew<vtkBRDFHeadlessRenderWindow> Window;
};
#endif
