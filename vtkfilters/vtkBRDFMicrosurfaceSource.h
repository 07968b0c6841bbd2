#ifndef vtkBRDFMicrosurfaceSource_h
#define vtkBRDFMicrosurfaceSource_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

class vtkBRDFMicrosurface;
class vtkStringArray;

/**
 * @class vtkBRDFMicrosurfaceSource
 * @brief Makes a microsurface from an expression, an image of heights or a mesh
 *
 * Without an input the surface is an expression, such as "grooves(width=4, spacing=20, angle=60)", "gaussian(rms=0.2,
 * correlation=2)", "heightfield(file=h.png, depth=3)" or "mesh(file=x.ply)"; see GetKinds().
 *
 * With a vtkImageData as input (optional, port 0), the first component of its point scalars times HeightScale are the
 * heights in micrometres at its points, one layer of them; its spacing is in micrometres, and the tile repeats: the
 * point after the last is the first again. With a vtkPolyData, its polygons are the surface, in micrometres, outer
 * sides counter-clockwise, repeated with Period.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFMicrosurfaceSource : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFMicrosurfaceSource* New();
  vtkTypeMacro(vtkBRDFMicrosurfaceSource, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkBRDFMicrosurface* GetOutput();

  ///@{
  /** The surface where there is no input; default "grooves". */
  vtkSetMacro(Surface, std::string);
  vtkGetMacro(Surface, std::string);
  ///@}

  ///@{
  /** Micrometres a unit of an image's scalars; may be negative; default 1. */
  vtkSetMacro(HeightScale, double);
  vtkGetMacro(HeightScale, double);
  ///@}

  ///@{
  /** Period of a mesh along x and y, micrometres, default 0, 0; where it is 0, its extent. */
  vtkSetVector2Macro(Period, double);
  vtkGetVector2Macro(Period, double);
  ///@}

  /** Names of the kinds of surfaces. */
  static void GetKinds(vtkStringArray* names);

protected:
  vtkBRDFMicrosurfaceSource();
  ~vtkBRDFMicrosurfaceSource() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFMicrosurfaceSource(const vtkBRDFMicrosurfaceSource&) = delete;
  void operator=(const vtkBRDFMicrosurfaceSource&) = delete;

  std::string Surface = "grooves";
  double HeightScale = 1;
  double Period[2] = { 0, 0 };
};
#endif
