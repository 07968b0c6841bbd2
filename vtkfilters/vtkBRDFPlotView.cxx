#include "vtkBRDFPlotView.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFArrays.h"
#include "vtkBRDFPlotData.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkTable.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

using namespace vtkBRDFDrawing;

vtkStandardNewMacro(vtkBRDFPlotView);
vtkBRDFPlotView::vtkBRDFPlotView() = default;
vtkBRDFPlotView::~vtkBRDFPlotView() = default;

namespace
{
// Channels named after a colour have it, lighter and darker by turns for further tables.
Color SeriesColor(const std::string& name, std::size_t table, std::size_t index)
{
  const std::map<std::string, Color> colors = { { "red", { 0.80, 0.15, 0.15 } },
                                                { "green", { 0.10, 0.55, 0.20 } },
                                                { "blue", { 0.10, 0.30, 0.80 } } };
  const auto found = colors.find(name);
  if (found == colors.end())
  {
    return PaletteColor(index);
  }
  Color color = found->second;
  for (double& component : color)
  {
    component = table % 3 == 1 ? 0.5 + 0.5 * component : table % 3 == 2 ? 0.5 * component : component;
  }
  return color;
}

vtkTable* Updated(vtkAlgorithmOutput* connection, vtkTable* table)
{
  if (!connection)
  {
    return table;
  }
  connection->GetProducer()->Update(connection->GetIndex());
  return vtkTable::SafeDownCast(connection->GetProducer()->GetOutputDataObject(connection->GetIndex()));
}

std::vector<PlotMark> MarksOf(const std::vector<std::pair<double, std::string>>& marks)
{
  std::vector<PlotMark> result;
  for (const auto& [at, text] : marks)
  {
    result.push_back({ at, text });
  }
  return result;
}

// What a legend says of the whole of an albedo.
std::string Whole(vtkTable* table, std::size_t channel)
{
  const std::vector<double> values = vtkBRDFArrays::FieldNumbers(table->GetFieldData(), "bihemispherical");
  const std::vector<double> errors =
    vtkBRDFArrays::FieldNumbers(table->GetFieldData(), "standard error of bihemispherical");
  return channel < values.size() && channel < errors.size()
           ? ": bihemispherical " + NumberText(values[channel], 4) + " \u00b1 " + NumberText(errors[channel], 1)
           : std::string();
}
}

void vtkBRDFPlotView::AddInputConnection(vtkAlgorithmOutput* table, const std::string& name)
{
  this->Inputs.push_back({ table, nullptr, nullptr, nullptr, name });
  this->Modified();
}

void vtkBRDFPlotView::AddInputData(vtkTable* table, const std::string& name)
{
  this->Inputs.push_back({ nullptr, nullptr, table, nullptr, name });
  this->Modified();
}

void vtkBRDFPlotView::AddPointsConnection(vtkAlgorithmOutput* table)
{
  if (!this->Inputs.empty())
  {
    this->Inputs.back().PointsConnection = table;
    this->Modified();
  }
}

void vtkBRDFPlotView::AddPointsData(vtkTable* table)
{
  if (!this->Inputs.empty())
  {
    this->Inputs.back().Points = table;
    this->Modified();
  }
}

void vtkBRDFPlotView::RemoveAllInputs()
{
  this->Inputs.clear();
  this->References.clear();
  this->Levels.clear();
  this->Modified();
}

void vtkBRDFPlotView::AddReference(double x, const std::string& text)
{
  this->References.push_back({ x, text });
  this->Modified();
}

void vtkBRDFPlotView::AddLevel(double value, const std::string& text)
{
  this->Levels.push_back({ value, text });
  this->Modified();
}

Plot vtkBRDFPlotView::Collect()
{
  if (this->Inputs.empty())
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "nothing to plot", "plot", "no input", "a table of curves" });
  }
  std::vector<PlotSeries> all;
  std::size_t index = 0;
  for (std::size_t k = 0; k < this->Inputs.size(); ++k)
  {
    const Input& input = this->Inputs[k];
    for (vtkAlgorithmOutput* connection : { input.Connection.Get(), input.PointsConnection.Get() })
    {
      if (auto* producer = connection ? vtkBRDFAlgorithm::SafeDownCast(connection->GetProducer()) : nullptr)
      {
        UpdateOrThrow(producer);
      }
    }
    vtkTable* table = Updated(input.Connection, input.Table);
    vtkTable* points = Updated(input.PointsConnection, input.Points);
    const std::vector<PlotCurve> curves = CurvesOf(table);
    const std::vector<PlotCurve> measured =
      points && points->GetNumberOfRows() > 0 ? CurvesOf(points) : std::vector<PlotCurve>();
    for (const PlotCurve& curve : curves)
    {
      const Color color = SeriesColor(curve.Name, k, index++);
      const bool several = curves.size() > 1 || input.Name.empty();
      const std::string whole = Whole(table, static_cast<std::size_t>(&curve - curves.data()));
      const std::string legend =
        input.Name + (several ? (input.Name.empty() ? "" : ", ") + curve.Name : "") + whole +
        (!whole.empty() || curve.Error.empty() ||
             std::none_of(curve.Error.begin(), curve.Error.end(), [](double e) { return e > 0; })
           ? ""
           : " (band: 1 standard error)");
      all.push_back({ curve, legend, color, false });
      for (const PlotCurve& samples : measured)
      {
        if (samples.Name == curve.Name)
        {
          all.push_back(
            { samples, samples.Error.empty() ? "measured" : "measured, bars: 1 standard error", color, true });
        }
      }
    }
  }
  std::vector<const PlotCurve*> curves;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const PlotSeries& series : all)
  {
    curves.push_back(&series.Curve);
    for (const double x : series.Curve.X)
    {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  }
  if (!(low < high))
  {
    low = std::isfinite(low) ? low - 1 : 0;
    high = low + 2;
  }
  // Angles end at a tick: the last point of a curve is a little above the horizon.
  if (this->XStep > 0 && low >= 0 && high > 89 && high < 90)
  {
    high = 90;
  }
  std::vector<double> levels;
  for (const auto& [level, name] : this->Levels)
  {
    levels.push_back(level);
  }
  const PlotScale scale(PlotScale::Parse(this->Scale), curves, levels, this->Decades);
  return { std::move(all),        scale,        low,         high, this->XStep, MarksOf(this->References),
           MarksOf(this->Levels), this->XTitle, this->YTitle };
}

void vtkBRDFPlotView::AddLegend(const Plot& plot, int text, double width)
{
  // Entries in two columns where they are many.
  std::size_t entries = plot.Series.size();
  const std::size_t columns = entries > 3 ? 2 : 1, rows = (entries + columns - 1) / columns;
  const double columnWidth = (width - 2 * text) / static_cast<double>(columns);
  const auto letters = static_cast<std::size_t>(std::max(8.0, (columnWidth - 3 * text) / (0.55 * text)));
  for (std::size_t k = 0; k < entries; ++k)
  {
    const PlotSeries& series = plot.Series[k];
    const double x = text + columnWidth * static_cast<double>(k / rows);
    const double y = text * (0.4 + 1.35 * static_cast<double>(rows - 1 - k % rows));
    const double middle = y + 0.36 * text;
    if (series.Points)
    {
      AddDots(this->GetRenderer(), { { x + 0.7 * text, middle } }, 0.27 * text, series.Stroke);
    }
    else
    {
      AddRectangles(this->GetRenderer(),
                    { { { x, middle - 0.09 * text }, { x + 1.4 * text, middle + 0.09 * text }, series.Stroke } });
    }
    AddText(this->GetRenderer(), Shortened(series.Legend, letters), { x + 2 * text, y }, { .Size = text });
  }
}

void vtkBRDFPlotView::Build(int width, int height)
{
  if (this->Kind != "cartesian" && this->Kind != "half circle" && this->Kind != "circle")
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "unknown kind of plot", "plot", this->Kind, "cartesian, half circle, circle" });
  }
  const Plot plot = this->Collect();
  const int text = TextSize(width, height);
  const double top = AddHeading(this->GetRenderer(), this->GetTitle(), this->Note, height - 0.7 * text, text);
  this->AddLegend(plot, text, width);
  const std::size_t rows = plot.Series.size() > 3 ? (plot.Series.size() + 1) / 2 : plot.Series.size();
  const double below = text * (1.2 + 1.35 * static_cast<double>(rows)), above = height - top + 1.2 * text;
  if (this->Kind == "cartesian")
  {
    const double rectangle[4] = {
      7.0 * text, below + 3.8 * text, width - 9.0 * text, height - below - 3.8 * text - above
    };
    AddCartesianPlot(this->GetRenderer(), plot, text, rectangle);
    return;
  }
  const double rectangle[4] = { 1.0 * text, below, width - 2.0 * text, height - below - above + text };
  AddPolarPlot(this->GetRenderer(), plot, this->Kind == "circle", text, rectangle);
}

void vtkBRDFPlotView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Inputs: " << this->Inputs.size() << "\n"
     << indent << "Kind: " << this->Kind << "\n"
     << indent << "Scale: " << this->Scale << "\n"
     << indent << "Decades: " << this->Decades << "\n"
     << indent << "XTitle: " << this->XTitle << "\n"
     << indent << "YTitle: " << this->YTitle << "\n"
     << indent << "Note: " << this->Note << "\n"
     << indent << "XStep: " << this->XStep << "\n";
}
