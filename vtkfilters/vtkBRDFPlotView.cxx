#include "vtkBRDFPlotView.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkAxis.h"
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFArrays.h"
#include "vtkBRDFPlotData.h"
#include "vtkBrush.h"
#include "vtkChartXY.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkPlotArea.h"
#include "vtkPlotLine.h"
#include "vtkPlotPoints.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

using namespace vtkBRDFDrawing;

vtkStandardNewMacro(vtkBRDFPlotView);
vtkBRDFPlotView::vtkBRDFPlotView() = default;
vtkBRDFPlotView::~vtkBRDFPlotView() = default;

struct vtkBRDFPlotView::Plot
{
  std::vector<PlotSeries> All;
  PlotScale Scale;
  double XLow, XHigh;
};

namespace
{
constexpr Color Grid = { 0.88, 0.88, 0.90 };

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

vtkBRDFPlotView::Plot vtkBRDFPlotView::Collect()
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
  return { std::move(all), scale, low, high };
}

void vtkBRDFPlotView::AddLegend(const Plot& plot, int text, double width)
{
  // Entries in two columns where they are many.
  std::size_t entries = plot.All.size();
  const std::size_t columns = entries > 3 ? 2 : 1, rows = (entries + columns - 1) / columns;
  const double columnWidth = (width - 2 * text) / static_cast<double>(columns);
  const auto letters = static_cast<std::size_t>(std::max(8.0, (columnWidth - 3 * text) / (0.55 * text)));
  for (std::size_t k = 0; k < entries; ++k)
  {
    const PlotSeries& series = plot.All[k];
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

void vtkBRDFPlotView::AddChart(const Plot& plot, int text, const double rectangle[4])
{
  vtkNew<vtkChartXY> chart;
  chart->SetAutoSize(false);
  chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
  const auto part = [](double pixels) { return static_cast<float>(pixels); };
  chart->SetSize(vtkRectf(part(rectangle[0]), part(rectangle[1]), part(rectangle[2]), part(rectangle[3])));
  chart->SetShowLegend(false);
  const double thin = LineWidth(text);

  const auto axis = [&](int where, double low, double high, const std::vector<double>& ticks)
  {
    vtkAxis* result = chart->GetAxis(where);
    result->SetTitle("");
    result->GetLabelProperties()->SetFontFamilyToArial();
    result->GetLabelProperties()->SetFontSize(text);
    result->GetLabelProperties()->SetColor(Ink.data());
    result->GetPen()->SetColorF(Ink[0], Ink[1], Ink[2]);
    result->GetPen()->SetWidth(part(thin));
    result->GetGridPen()->SetColorF(Grid[0], Grid[1], Grid[2]);
    result->GetGridPen()->SetWidth(part(thin));
    result->SetTickLength(part(text / 3.0));
    result->SetLabelOffset(part(text / 2.0));
    result->SetBehavior(vtkAxis::FIXED);
    result->SetRange(low, high);
    vtkNew<vtkDoubleArray> positions;
    vtkNew<vtkStringArray> labels;
    for (const double tick : ticks)
    {
      positions->InsertNextValue(where == vtkAxis::LEFT ? plot.Scale.Position(tick) : tick);
      labels->InsertNextValue(NumberText(tick) + (where == vtkAxis::BOTTOM && this->XStep > 0 ? "\u00b0" : ""));
    }
    result->SetCustomTickPositions(positions, labels);
  };
  const double step = this->XStep > 0 ? this->XStep : 0;
  std::vector<double> ticks =
    LinearTicks(plot.XLow, plot.XHigh, std::max(3, static_cast<int>(rectangle[2] / text / 5)));
  if (step > 0)
  {
    ticks.clear();
    for (double k = std::ceil(plot.XLow / step - 0.01); k * step <= plot.XHigh + 0.01 * step; ++k)
    {
      ticks.push_back(k == 0 ? 0 : k * step);
    }
  }
  axis(vtkAxis::BOTTOM, plot.XLow, plot.XHigh, ticks);
  axis(vtkAxis::LEFT, 0, 1, plot.Scale.Ticks(2.2 * text / rectangle[3]));

  for (const PlotSeries& series : plot.All)
  {
    vtkNew<vtkTable> table, bars;
    vtkNew<vtkDoubleArray> x, y, low, high, barX, barY;
    x->SetName("x");
    y->SetName("y");
    low->SetName("low");
    high->SetName("high");
    barX->SetName("x");
    barY->SetName("y");
    const PlotCurve& curve = series.Curve;
    for (std::size_t i = 0; i < curve.X.size(); ++i)
    {
      if (series.Points && !std::isfinite(curve.Y[i]))
      {
        continue;
      }
      const double error = curve.Error.empty() || !std::isfinite(curve.Error[i]) ? 0 : curve.Error[i];
      x->InsertNextValue(curve.X[i]);
      y->InsertNextValue(plot.Scale.Position(curve.Y[i]));
      low->InsertNextValue(plot.Scale.Position(curve.Y[i] - error));
      high->InsertNextValue(plot.Scale.Position(curve.Y[i] + error));
      for (const double end : { curve.Y[i] - error, curve.Y[i] + error })
      {
        if (error > 0)
        {
          barX->InsertNextValue(curve.X[i]);
          barY->InsertNextValue(plot.Scale.Position(end));
        }
      }
    }
    for (vtkDoubleArray* column : { x.Get(), y.Get(), low.Get(), high.Get() })
    {
      table->AddColumn(column);
    }
    bars->AddColumn(barX);
    bars->AddColumn(barY);
    const Color& color = series.Stroke;
    if (series.Points)
    {
      if (barX->GetNumberOfTuples() > 0)
      {
        vtkNew<vtkPlotLine> lines;
        lines->SetInputData(bars, 0, 1);
        lines->SetPolyLine(false);
        lines->GetPen()->SetColorF(color[0], color[1], color[2]);
        lines->SetWidth(part(thin));
        chart->AddPlot(lines);
      }
      if (x->GetNumberOfTuples() > 0)
      {
        vtkNew<vtkPlotPoints> dots;
        dots->SetInputData(table, 0, 1);
        dots->SetMarkerStyle(vtkPlotPoints::CIRCLE);
        dots->SetMarkerSize(part(0.45 * text));
        dots->GetPen()->SetColorF(color[0], color[1], color[2]);
        chart->AddPlot(dots);
      }
      continue;
    }
    if (barX->GetNumberOfTuples() > 0)
    {
      vtkNew<vtkPlotArea> band;
      band->SetInputData(table);
      band->SetInputArray(0, "x");
      band->SetInputArray(1, "low");
      band->SetInputArray(2, "high");
      band->GetBrush()->SetColorF(color[0], color[1], color[2], 0.25);
      band->GetPen()->SetLineType(vtkPen::NO_PEN);
      chart->AddPlot(band);
    }
    // Full where it rests on data, pale elsewhere.
    for (const bool beyond : { true, false })
    {
      vtkNew<vtkTable> strokes;
      vtkNew<vtkDoubleArray> strokesX, strokesY;
      strokesX->SetName("x");
      strokesY->SetName("y");
      bool any = false;
      for (std::size_t i = 0; i < curve.X.size(); ++i)
      {
        const bool before = i > 0 && curve.IsBeyond(i) == beyond;
        const bool after = i + 1 < curve.X.size() && curve.IsBeyond(i + 1) == beyond;
        any = any || before || after;
        strokesX->InsertNextValue(curve.X[i]);
        strokesY->InsertNextValue(before || after ? plot.Scale.Position(curve.Y[i])
                                                  : std::numeric_limits<double>::quiet_NaN());
      }
      if (!any)
      {
        continue;
      }
      strokes->AddColumn(strokesX);
      strokes->AddColumn(strokesY);
      const Color stroke = beyond ? Pale(color) : color;
      vtkNew<vtkPlotLine> line;
      line->SetInputData(strokes, 0, 1);
      line->GetPen()->SetColorF(stroke[0], stroke[1], stroke[2]);
      line->SetWidth(part(1.8 * thin));
      chart->AddPlot(line);
    }
  }
  GetScene(this->GetRenderer())->AddItem(chart);

  // The chart's own titles touch the numbers.
  AddText(this->GetRenderer(),
          this->XTitle,
          { rectangle[0] + rectangle[2] / 2, rectangle[1] - 2.3 * text },
          { .Size = text, .Horizontal = Align::Center, .Vertical = Align::High });
  AddText(this->GetRenderer(),
          this->YTitle,
          { rectangle[0] - 4.4 * text, rectangle[1] + rectangle[3] / 2 },
          { .Size = text, .Horizontal = Align::Center, .Angle = 90 });

  const auto dashed = [&](Point from, Point to)
  {
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    std::vector<Line> dashes;
    for (double at = 0; at < length; at += 0.8 * text)
    {
      const double end = std::min(at + 0.4 * text, length);
      const auto point = [&](double share) -> Point {
        return { from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]) };
      };
      dashes.push_back({ point(at / length), point(end / length) });
    }
    AddLines(this->GetRenderer(), dashes, Faint, thin);
  };
  const double top = rectangle[1] + rectangle[3], right = rectangle[0] + rectangle[2];
  for (const auto& [place, name] : this->References)
  {
    const double at = rectangle[0] + rectangle[2] * (place - plot.XLow) / (plot.XHigh - plot.XLow);
    if (at >= rectangle[0] && at <= right)
    {
      dashed({ at, rectangle[1] }, { at, top });
      AddText(this->GetRenderer(),
              name,
              { at, top + 0.3 * text },
              { .Size = text * 9 / 10, .Horizontal = Align::Center, .Foreground = Faint });
    }
  }
  for (const auto& [level, name] : this->Levels)
  {
    const double at = plot.Scale.Position(level);
    if (at >= 0 && at <= 1)
    {
      const double y = rectangle[1] + at * rectangle[3];
      dashed({ rectangle[0], y }, { right, y });
      AddText(this->GetRenderer(),
              name,
              { right - 0.3 * text, y + 0.2 * text },
              { .Size = text * 9 / 10, .Horizontal = Align::High, .Foreground = Faint });
    }
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
  const std::size_t rows = plot.All.size() > 3 ? (plot.All.size() + 1) / 2 : plot.All.size();
  const double below = text * (1.2 + 1.35 * static_cast<double>(rows)), above = height - top + 1.2 * text;
  if (this->Kind == "cartesian")
  {
    const double rectangle[4] = {
      7.0 * text, below + 3.8 * text, width - 9.0 * text, height - below - 3.8 * text - above
    };
    this->AddChart(plot, text, rectangle);
    return;
  }
  const double rectangle[4] = { 1.0 * text, below, width - 2.0 * text, height - below - above + text };
  std::vector<PlotMark> references;
  for (const auto& [place, name] : this->References)
  {
    references.push_back({ place, name });
  }
  AddPolarPlot(this->GetRenderer(),
               plot.All,
               plot.Scale,
               references,
               this->XTitle,
               this->YTitle,
               this->Kind == "circle",
               text,
               rectangle);
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
