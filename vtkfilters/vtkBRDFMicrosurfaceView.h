#ifndef vtkBRDFMicrosurfaceView_h
#define vtkBRDFMicrosurfaceView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkBRDFView.h"
#include "vtkNew.h" // For vtkNew

class vtkAlgorithmOutput;
class vtkBRDFMicrosurfaceGeometry;
class vtkDataObject;

/**
 * @class vtkBRDFMicrosurfaceView
 * @brief A picture of a microsurface: its relief, shaded and coloured by height
 *
 * Parallel projection, so that lengths along x and y are true along their axes; ticks in micrometres along the tile's
 * edges, a bar of colours for the heights, and what the surface turned out to be below the title. Facets are shaded as
 * they are traced, flat. Of height fields of more than 2^20 nodes every second, third, ... is drawn, and said so.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFMicrosurfaceView : public vtkBRDFView
{
public:
  static vtkBRDFMicrosurfaceView* New();
  vtkTypeMacro(vtkBRDFMicrosurfaceView, vtkBRDFView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The surface, of a pipeline. */
  void SetInputConnection(vtkAlgorithmOutput* surface);
  ///@}

  ///@{
  /** The same as a vtkBRDFMicrosurface. */
  void SetInputData(vtkDataObject* surface);
  ///@}

  ///@{
  /** Copies of the tile along x and y, 1 to 100 each; default 1, 1. */
  vtkSetVector2Macro(Tiles, int);
  vtkGetVector2Macro(Tiles, int);
  ///@}

  ///@{
  /** Azimuth of the camera about the vertical axis, degrees, 0 looking along +y with +x to the right; default 25. */
  vtkSetMacro(Azimuth, double);
  vtkGetMacro(Azimuth, double);
  ///@}

  ///@{
  /** Elevation of the camera, degrees, default 40. At 90 degrees the picture is a map. */
  vtkSetClampMacro(Elevation, double, 1, 90);
  vtkGetMacro(Elevation, double);
  ///@}

  ///@{
  /** What heights are multiplied by in the picture; 0 (default): 1, or the power of ten that makes the relief of a
   * surface of low relief at least a hundredth of its width. The picture says which. */
  vtkSetClampMacro(Exaggeration, double, 0, 1e9);
  vtkGetMacro(Exaggeration, double);
  ///@}

protected:
  vtkBRDFMicrosurfaceView();
  ~vtkBRDFMicrosurfaceView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFMicrosurfaceView(const vtkBRDFMicrosurfaceView&) = delete;
  void operator=(const vtkBRDFMicrosurfaceView&) = delete;

  vtkNew<vtkBRDFMicrosurfaceGeometry> Geometry;
  int Tiles[2] = { 1, 1 };
  double Azimuth = 25;
  double Elevation = 40;
  double Exaggeration = 0;
};
#endif
