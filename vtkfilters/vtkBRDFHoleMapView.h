#ifndef vtkBRDFHoleMapView_h
#define vtkBRDFHoleMapView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkBRDFView.h"
#include "vtkNew.h" // For vtkNew

class vtkAlgorithmOutput;
class vtkBRDFHoleMap;
class vtkDataObject;

/**
 * @class vtkBRDFHoleMapView
 * @brief A picture of which cells of a table or grid are measured, filled, invalid or below the horizon
 *
 * Draws the output of a vtkBRDFHoleMap: each place as wide as its cell, in degrees, its colour the mixture of the
 * classes' colours by their shares of the cells there. The legend counts them.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFHoleMapView : public vtkBRDFView
{
public:
  static vtkBRDFHoleMapView* New();
  vtkTypeMacro(vtkBRDFHoleMapView, vtkBRDFView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The data, of a pipeline. */
  void SetInputConnection(vtkAlgorithmOutput* brdf);
  ///@}

  ///@{
  /** The same as a vtkBRDF. */
  void SetInputData(vtkDataObject* brdf);
  ///@}

  /** The filter behind the picture: set its axes there. */
  vtkBRDFHoleMap* GetHoleMap();

  ///@{
  /** Of the data, in the title. Empty (default): their description. */
  vtkSetMacro(Name, std::string);
  vtkGetMacro(Name, std::string);
  ///@}

  ///@{
  /** Along x, equal steps of the picture are equal steps of the angle's power 1 / Warp: 1 (default) linear; 2 shows
   * MERL's cells of theta_h equally wide. Of polar angles only; [0.1, 10]. */
  vtkSetClampMacro(Warp, double, 0.1, 10);
  vtkGetMacro(Warp, double);
  ///@}

protected:
  vtkBRDFHoleMapView();
  ~vtkBRDFHoleMapView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFHoleMapView(const vtkBRDFHoleMapView&) = delete;
  void operator=(const vtkBRDFHoleMapView&) = delete;

  vtkNew<vtkBRDFHoleMap> HoleMap;
  std::string Name;
  double Warp = 1;
};
#endif
