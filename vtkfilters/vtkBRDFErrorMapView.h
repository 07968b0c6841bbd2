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
 * Draws the output of a vtkBRDFErrorMap: each point as a coloured square over two angles in degrees, or over the
 * hemisphere as a disk seen from above with its grid of polar angle and azimuth, the light and the mirror direction; a
 * scale with the quantity's unit, the means and the names of A and B. Magnitudes are in viridis, signed differences in
 * blue to red about zero; hatched is where there is nothing to compare. The worst directions are marked and numbered as
 * in the filter's table of them.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFErrorMapView : public vtkBRDFView
{
public:
  static vtkBRDFErrorMapView* New();
  vtkTypeMacro(vtkBRDFErrorMapView, vtkBRDFView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** A (a fit, say; index 0) or B (the reference; index 1), of a pipeline. */
  void SetInputConnection(int index, vtkAlgorithmOutput* brdf);
  ///@}

  ///@{
  /** The same as a vtkBRDF. */
  void SetInputData(int index, vtkDataObject* brdf);
  ///@}

  /** The filter behind the picture: set its measure, axes, channel and azimuths there. */
  vtkBRDFErrorMap* GetErrorMap();

  ///@{
  /** Name of A below the picture. Empty (default): its description. */
  vtkSetMacro(NameA, std::string);
  vtkGetMacro(NameA, std::string);
  ///@}

  ///@{
  /** Name of B below the picture. Empty (default): its description. */
  vtkSetMacro(NameB, std::string);
  vtkGetMacro(NameB, std::string);
  ///@}

  ///@{
  /** Intervals along each axis; 0 (default): as the data allow, see vtkBRDFErrorMap::SuggestIntervals. */
  vtkSetClampMacro(Intervals, int, 0, 1000);
  vtkGetMacro(Intervals, int);
  ///@}

  ///@{
  /** Colours over the values: "linear", "log" (over at most four decades; not for signed differences), or "auto"
   * (default): log where the largest value is more than ten times the median. */
  vtkSetMacro(Scale, std::string);
  vtkGetMacro(Scale, std::string);
  ///@}

  ///@{
  /** Mark the worst directions; default on. */
  vtkSetMacro(ShowWorst, bool);
  vtkGetMacro(ShowWorst, bool);
  vtkBooleanMacro(ShowWorst, bool);
  ///@}

protected:
  vtkBRDFErrorMapView();
  ~vtkBRDFErrorMapView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFErrorMapView(const vtkBRDFErrorMapView&) = delete;
  void operator=(const vtkBRDFErrorMapView&) = delete;

  struct Layout;
  Layout MakeLayout(int width, int height, double top);
  bool IsDisk();
  void AddMap(const Layout& layout);
  void AddHatch(const Layout& layout);
  void AddAxes(const Layout& layout);
  void AddDiskGrid(const Layout& layout);
  void AddLight(const Layout& layout);
  void AddWorst(const Layout& layout);
  double AddTitles(int width, int height);

  vtkNew<vtkBRDFErrorMap> ErrorMap;
  std::string NameA;
  std::string NameB;
  int Intervals = 0;
  std::string Scale = "auto";
  bool ShowWorst = true;
};
#endif
