#ifndef vtkBRDFSurfaceMaterial_h
#define vtkBRDFSurfaceMaterial_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFParaViewModule.h" // For export macro

class vtkPolyData;

/**
 * @class vtkBRDFSurfaceMaterial
 * @brief A surface that carries its material to where it is drawn
 *
 * Input 0: the surface, vtkPolyData. Input 1: the material, any vtkBRDF. The output is the surface in triangles, with
 * normals (splitting edges sharper than 40 degrees) and tangents where it had none, and the material in its field data:
 * the string "vtkBRDF" describes it, the bytes "vtkBRDF.container" are a .vtkhdf file of it. ParaView may draw in
 * another process than the one that made the material; data of surfaces are what it brings there. The representation
 * "BRDF under light" (vtkBRDFSurfaceRepresentation) draws it.
 */
class VTKBRDFPARAVIEW_EXPORT vtkBRDFSurfaceMaterial : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFSurfaceMaterial* New();
  vtkTypeMacro(vtkBRDFSurfaceMaterial, vtkBRDFAlgorithm);

  vtkPolyData* GetOutput();

  /** Name of the array of bytes. */
  static const char* GetArrayName() { return "vtkBRDF.container"; }

protected:
  vtkBRDFSurfaceMaterial();
  ~vtkBRDFSurfaceMaterial() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFSurfaceMaterial(const vtkBRDFSurfaceMaterial&) = delete;
  void operator=(const vtkBRDFSurfaceMaterial&) = delete;
};
#endif
