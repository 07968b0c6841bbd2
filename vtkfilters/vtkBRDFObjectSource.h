#ifndef vtkBRDFObjectSource_h
#define vtkBRDFObjectSource_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For std::string

/**
 * @class vtkBRDFObjectSource
 * @brief Makes or reads an object to render: a surface with normals and tangents
 *
 * Object is the name of a shape (GetShapeNames) or a file: .ply, .obj, .stl, .vtp, .gltf or .glb (told by the ending;
 * of glTF the default scene with its nodes' transforms). Shapes lie about the origin with +y up; parametric ones are
 * scaled to lie within distance 1 of it. The same surfaces are drawn by vtkBRDFRender and the reference renderer.
 *
 * What a file lacks is made: normals (splitting edges sharper than 40 degrees) and tangents (from texture coordinates,
 * else around the vertical: brdf::addTangents). Triangles without an area are dropped. An object that cannot be drawn
 * (no polygons, corners that are no points, numbers that are not finite, more than 2^26 points or triangles) is an
 * error and the output is empty.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFObjectSource : public vtkPolyDataAlgorithm
{
public:
  static vtkBRDFObjectSource* New();
  vtkTypeMacro(vtkBRDFObjectSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** A shape's name or a file; default "sphere". */
  vtkSetMacro(Object, std::string);
  vtkGetMacro(Object, std::string);
  ///@}

  /** Names of the shapes, separated by spaces. */
  static std::string GetShapeNames();

  /** Why the last update failed, in one line; empty when it succeeded. */
  std::string GetErrorText() const { return this->ErrorText; }

protected:
  vtkBRDFObjectSource();
  ~vtkBRDFObjectSource() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkBRDFObjectSource(const vtkBRDFObjectSource&) = delete;
  void operator=(const vtkBRDFObjectSource&) = delete;

  std::string Object = "sphere";
  std::string ErrorText;
};
#endif
