#ifndef vtkBRDFErrorMapView_h
#define vtkBRDFErrorMapView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkBRDFView.h"
#include "vtkNew.h" // For vtkNew

class vtkAlgorithmOutput;
class vtkBRDFErrorMap;
class vtkDataObject;

/**
 * @class vtkBRDFErrorMapView
 * @brief A picture of where two BRDFs differ
 *
 * Draws the output of a vtkBRDFErrorMap: each point as a coloured square over two angles in degrees, a scale with the
 * quantity's unit, the means and the names of A and B. Magnitudes are in viridis, signed differences in blue to red
 * about zero; hatched is where there is nothing to compare.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFErrorMapView : public vtkBRDFView
{
public:
  static vtkBRDFErrorMapView* New();
  vtkTypeMacro(vtkBRDFErrorMapView, vtkBRDFView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** A (a fit, say; index 0) and B (the reference; index 1): a pipeline, or a vtkBRDF. */
  void SetInputConnection(int index, vtkAlgorithmOutput* brdf);
  void SetInputData(int index, vtkDataObject* brdf);
  ///@}

  /** The filter behind the picture: set its measure, axes, channel and azimuths there. */
  vtkBRDFErrorMap* GetErrorMap();

  ///@{
  /** Names of A and B below the picture; empty: their descriptions. */
  vtkSetMacro(NameA, std::string);
  vtkGetMacro(NameA, std::string);
  vtkSetMacro(NameB, std::string);
  vtkGetMacro(NameB, std::string);
  ///@}

  ///@{
  /** Intervals of 90 degrees; 0 (default): as the data allow, see vtkBRDFErrorMap::SuggestIntervals. */
  vtkSetClampMacro(Intervals, int, 0, 1000);
  vtkGetMacro(Intervals, int);
  ///@}

  ///@{
  /** Colours over the values: "linear", "log" (over at most four decades; not for signed differences), or "auto"
   * (default): log where the largest value is more than ten times the median. */
  vtkSetMacro(Scale, std::string);
  vtkGetMacro(Scale, std::string);
  ///@}

protected:
  vtkBRDFErrorMapView();
  ~vtkBRDFErrorMapView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFErrorMapView(const vtkBRDFErrorMapView&) = delete;
  void operator=(const vtkBRDFErrorMapView&) = delete;

  struct Layout;
  struct ColorScale;
  ColorScale ChooseScale();
  void AddMap(const Layout& layout, const ColorScale& scale);
  void AddAxes(const Layout& layout);
  void AddScaleBar(const Layout& layout, const ColorScale& scale);
  void AddTitles(const Layout& layout, const ColorScale& scale);

  vtkNew<vtkBRDFErrorMap> ErrorMap;
  std::string NameA;
  std::string NameB;
  int Intervals = 0;
  std::string Scale = "auto";
};
#endif
