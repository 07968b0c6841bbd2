#ifndef vtkBRDFMicrosurfaceGeometry_h
#define vtkBRDFMicrosurfaceGeometry_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

class vtkImageData;
class vtkPolyData;

/**
 * @class vtkBRDFMicrosurfaceGeometry
 * @brief A microsurface as polygons to look at, and its heights as an image
 *
 * Output port 0: vtkPolyData of Tiles copies, lengths in micrometres, with the point array "height" (z). Of a height
 * field all of its triangles, those that are traced; of a mesh its own; of a packing of spheres polygons about them and
 * the plane z = 0, where it is there. Output port 1: of a height field the heights of one tile as a vtkImageData
 * "height" whose spacing is in micrometres; else empty.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFMicrosurfaceGeometry : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFMicrosurfaceGeometry* New();
  vtkTypeMacro(vtkBRDFMicrosurfaceGeometry, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The polygons. */
  vtkPolyData* GetOutput();
  /** The heights. */
  vtkImageData* GetHeights();

  ///@{
  /** Copies of the tile along x and y, 1 to 100 each; default 1, 1. More than 2^26 triangles are refused. */
  vtkSetVector2Macro(Tiles, int);
  vtkGetVector2Macro(Tiles, int);
  ///@}

  ///@{
  /** Only every Stride-th node of a height field along each axis, for pictures of large ones: 1 (default) or more. */
  vtkSetClampMacro(Stride, int, 1, 65536);
  vtkGetMacro(Stride, int);
  ///@}

protected:
  vtkBRDFMicrosurfaceGeometry();
  ~vtkBRDFMicrosurfaceGeometry() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request,
                         vtkInformationVector** inputs,
                         vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFMicrosurfaceGeometry(const vtkBRDFMicrosurfaceGeometry&) = delete;
  void operator=(const vtkBRDFMicrosurfaceGeometry&) = delete;

  int Tiles[2] = { 1, 1 };
  int Stride = 1;
};
#endif
