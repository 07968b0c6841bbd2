#ifndef vtkBRDFPlotView_h
#define vtkBRDFPlotView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkBRDFView.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <utility> // For std::pair
#include <vector>  // For std::vector

class vtkAlgorithmOutput;
class vtkTable;

namespace vtkBRDFDrawing
{
struct Plot;
}

/**
 * @class vtkBRDFPlotView
 * @brief Curves of BRDFs, with measured points and their uncertainty, in a cartesian or a polar plot
 *
 * For tables like those of vtkBRDFCurve, vtkBRDFAlbedo and vtkBRDFSpectrum: the first column is x; every other one is a
 * curve, but "standard error of NAME", which becomes the band (of points: the bar) of one standard error about NAME,
 * and "state" and "distance", which are not drawn; where the state is 2, filled or extrapolated, curves are pale. Not a
 * number interrupts a curve. A table with the field "bihemispherical" has it stated in the legend.
 *
 * The cartesian plot is a vtkChartXY. Curves have the colours of PaletteColor, one after the other; those named red,
 * green and blue have these colours, shaded by table. Points have the colour of the curve of the same table and name.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFPlotView : public vtkBRDFView
{
public:
  static vtkBRDFPlotView* New();
  vtkTypeMacro(vtkBRDFPlotView, vtkBRDFView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Adds a table of curves: a pipeline or a vtkTable. `name` for the legend. */
  void AddInputConnection(vtkAlgorithmOutput* table, const std::string& name = std::string());
  /** The same without a pipeline. */
  void AddInputData(vtkTable* table, const std::string& name = std::string());
  ///@}
  ///@{
  /** Gives the table added last points of the same column names: measurements. */
  void AddPointsConnection(vtkAlgorithmOutput* table);
  /** The same without a pipeline. */
  void AddPointsData(vtkTable* table);
  ///@}
  void RemoveAllInputs();
  int GetNumberOfInputs() const { return static_cast<int>(this->Inputs.size()); }

  ///@{
  /** "cartesian" (default); "half circle": x is a polar angle in degrees, -90 to 90, 0 up and positive to the right, as
   * goniometric diagrams have it; "circle": x is an azimuth in degrees, 0 to the right, counter-clockwise. */
  vtkSetMacro(Kind, std::string);
  vtkGetMacro(Kind, std::string);
  ///@}

  ///@{
  /** Of the values: "linear" (default), "log", "cuberoot" or "log1p" (ln(1 + value)). Ticks name the values. */
  vtkSetMacro(Scale, std::string);
  vtkGetMacro(Scale, std::string);
  ///@}

  ///@{
  /** Decades that a logarithmic scale shows below the largest value at most; 0.1 to 600, default 6. */
  vtkSetClampMacro(Decades, double, 0.1, 600);
  vtkGetMacro(Decades, double);
  ///@}

  ///@{
  /** Quantity and unit of x; empty by default. */
  vtkSetMacro(XTitle, std::string);
  vtkGetMacro(XTitle, std::string);
  ///@}

  ///@{
  /** Quantity and unit of the values; empty by default. */
  vtkSetMacro(YTitle, std::string);
  vtkGetMacro(YTitle, std::string);
  ///@}

  ///@{
  /** A line below the title; empty by default. */
  vtkSetMacro(Note, std::string);
  vtkGetMacro(Note, std::string);
  ///@}

  ///@{
  /** Degrees between ticks of x where that is an angle; 0 (default): x is none, ticks are chosen. */
  vtkSetMacro(XStep, double);
  vtkGetMacro(XStep, double);
  ///@}

  ///@{
  /** A dashed line at x with a text: "mirror direction", say. */
  void AddReference(double x, const std::string& text);
  /** A dashed line at a value with a text. */
  void AddLevel(double value, const std::string& text);
  ///@}

protected:
  vtkBRDFPlotView();
  ~vtkBRDFPlotView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFPlotView(const vtkBRDFPlotView&) = delete;
  void operator=(const vtkBRDFPlotView&) = delete;

  struct Input
  {
    vtkSmartPointer<vtkAlgorithmOutput> Connection, PointsConnection;
    vtkSmartPointer<vtkTable> Table, Points;
    std::string Name;
  };
  vtkBRDFDrawing::Plot Collect();
  void AddLegend(const vtkBRDFDrawing::Plot& plot, int text, double width);

  std::vector<Input> Inputs;
  std::vector<std::pair<double, std::string>> References, Levels;
  std::string Kind = "cartesian";
  std::string Scale = "linear";
  double Decades = 6;
  std::string XTitle;
  std::string YTitle;
  std::string Note;
  double XStep = 0;
};
#endif
