#ifndef vtkBRDFHistogramView_h
#define vtkBRDFHistogramView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkBRDFView.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkBRDFErrorMap;

/**
 * @class vtkBRDFHistogramView
 * @brief A picture of how often two BRDFs differ by how much
 *
 * Draws the histogram of a vtkBRDFErrorMap: bars over the error of single pairs of directions (logarithmic where errors
 * are of many sizes), their height the number of pairs, or the share of all by solid angle where the map chooses the
 * directions, both on a logarithmic axis. Lines mark quantiles, whose values are written, and the mean that the map
 * states.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFHistogramView : public vtkBRDFView
{
public:
  static vtkBRDFHistogramView* New();
  vtkTypeMacro(vtkBRDFHistogramView, vtkBRDFView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The filter whose errors are drawn. */
  void SetErrorMap(vtkBRDFErrorMap* map);
  vtkBRDFErrorMap* GetErrorMap();
  ///@}

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

protected:
  vtkBRDFHistogramView();
  ~vtkBRDFHistogramView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFHistogramView(const vtkBRDFHistogramView&) = delete;
  void operator=(const vtkBRDFHistogramView&) = delete;

  struct Axes;
  Axes MakeAxes(int width, int height, double top);
  void AddBars(const Axes& axes);
  void AddAxes(const Axes& axes);
  void AddQuantiles(const Axes& axes);

  vtkSmartPointer<vtkBRDFErrorMap> ErrorMap;
  std::string NameA;
  std::string NameB;
};
#endif
