#ifndef vtkBRDFPlotData_h
#define vtkBRDFPlotData_h
// What a plot shows: curves read from tables, and the scale of their values. For .cxx files only.

#include "vtkBRDFDrawing.h"

#include <string>
#include <vector>

class vtkTable;

namespace vtkBRDFDrawing
{
struct PlotCurve
{
  std::string Name;                ///< of the column
  std::vector<double> X, Y, Error; ///< Error: empty, or one standard error of each Y
  std::vector<bool> Beyond;        ///< empty, or whether a point is filled or extrapolated

  /** Whether an end of the stroke from point i - 1 to i is. */
  bool IsBeyond(std::size_t i) const { return !this->Beyond.empty() && (this->Beyond[i - 1] || this->Beyond[i]); }
};

/** A colour for what does not rest on data, and for the edges of bands. */
Color Pale(const Color& color);

/** The curves of a table: see vtkBRDFPlotView. Throws brdf::Error for a table that has none. */
std::vector<PlotCurve> CurvesOf(vtkTable* table);

/** A range of values on an axis from 0 to 1. */
class PlotScale
{
public:
  enum class Kind
  {
    Linear,
    Log,
    CubeRoot,
    Log1p
  };
  /** "linear", "log", "cuberoot", "log1p"; throws brdf::Error for another name. */
  static Kind Parse(const std::string& name);

  /** For these curves, with room above; `levels` are values to show as well. `decades`: of a logarithmic scale at most.
   */
  PlotScale(Kind kind, const std::vector<const PlotCurve*>& curves, const std::vector<double>& levels, double decades);

  /** For a map in colours: all of the range of the values but the largest hundredth and, in logarithms, the smallest
   * one, which would take most of the colours for few places (a grazing highlight has no bound). */
  static PlotScale OfMap(Kind kind, const std::vector<const PlotCurve*>& values, double decades);

  /** Between two values, exactly. */
  PlotScale(Kind kind, double low, double high);

  /** Where a value lies; below 0 or above 1 where it is out of the range, -0.1 for 0 and less on a logarithmic scale.
   */
  double Position(double value) const;
  double GetLow() const { return this->Low; }
  double GetHigh() const { return this->High; }
  /** Round values, ascending, at least `gap` apart on the axis. */
  std::vector<double> Ticks(double gap) const;

private:
  double Transformed(double value) const;

  Kind ScaleKind;
  double Low = 0, High = 1; // values
  double From = 0, To = 1;  // transformed
};

struct PlotSeries
{
  PlotCurve Curve;
  std::string Legend;
  Color Stroke;
  bool Points = false; ///< measurements
};

/** A dashed line across the plot, with a text. */
struct PlotMark
{
  double At; ///< a value of x, or of y
  std::string Text;
};

/** What vtkBRDFPlotView draws. */
struct Plot
{
  std::vector<PlotSeries> Series;
  PlotScale Scale;
  double XLow, XHigh;
  double XStep = 0;                 ///< degrees between ticks of x; 0: x is no angle
  std::vector<PlotMark> References; ///< at values of x
  std::vector<PlotMark> Levels;     ///< at values
  std::string XTitle, YTitle;
};

/** Draws the cartesian plot, a vtkChartXY whose axes stand on the sides of a rectangle (x, y, width, height; pixels).
 * `text`: the size of the text in pixels. */
void AddCartesianPlot(vtkRenderer* renderer, const Plot& plot, int text, const double rectangle[4]);

/** Draws the polar plot in a rectangle: see vtkBRDFPlotView's kinds "half circle" and, where `full`, "circle". */
void AddPolarPlot(vtkRenderer* renderer, const Plot& plot, bool full, int text, const double rectangle[4]);
}

#endif
