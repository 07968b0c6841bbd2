// The cartesian plot of vtkBRDFPlotView.
#include "vtkBRDFPlotData.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChartXY.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPlotArea.h"
#include "vtkPlotLine.h"
#include "vtkPlotPoints.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vtkBRDFDrawing
{
namespace
{
constexpr Color Grid = { 0.88, 0.88, 0.90 };

float Part(double pixels)
{
  return static_cast<float>(pixels);
}

void SetAxis(vtkChartXY* chart,
             int where,
             double low,
             double high,
             const std::vector<double>& ticks,
             const Plot& plot,
             int text)
{
  vtkAxis* axis = chart->GetAxis(where);
  axis->SetTitle("");
  axis->GetLabelProperties()->SetFontFamilyToArial();
  axis->GetLabelProperties()->SetFontSize(text);
  axis->GetLabelProperties()->SetColor(Ink.data());
  axis->GetPen()->SetColorF(Ink[0], Ink[1], Ink[2]);
  axis->GetPen()->SetWidth(Part(LineWidth(text)));
  axis->GetGridPen()->SetColorF(Grid[0], Grid[1], Grid[2]);
  axis->GetGridPen()->SetWidth(Part(LineWidth(text)));
  axis->SetTickLength(Part(text / 3.0));
  axis->SetLabelOffset(Part(text / 2.0));
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(low, high);
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const double tick : ticks)
  {
    positions->InsertNextValue(where == vtkAxis::LEFT ? plot.Scale.Position(tick) : tick);
    labels->InsertNextValue(NumberText(tick) + (where == vtkAxis::BOTTOM && plot.XStep > 0 ? "\u00b0" : ""));
  }
  axis->SetCustomTickPositions(positions, labels);
}

// The curve as strokes: full where it rests on data, pale elsewhere.
void AddStrokes(vtkChartXY* chart, const PlotCurve& curve, const PlotScale& scale, const Color& color, int text)
{
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
      strokesY->InsertNextValue(before || after ? scale.Position(curve.Y[i])
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
    line->SetWidth(Part(1.8 * LineWidth(text)));
    chart->AddPlot(line);
  }
}

// Points with their bars, or a curve with its band.
void AddSeries(vtkChartXY* chart, const PlotSeries& series, const PlotScale& scale, int text)
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
    y->InsertNextValue(scale.Position(curve.Y[i]));
    low->InsertNextValue(scale.Position(curve.Y[i] - error));
    high->InsertNextValue(scale.Position(curve.Y[i] + error));
    for (const double end : { curve.Y[i] - error, curve.Y[i] + error })
    {
      if (error > 0)
      {
        barX->InsertNextValue(curve.X[i]);
        barY->InsertNextValue(scale.Position(end));
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
      lines->SetWidth(Part(LineWidth(text)));
      chart->AddPlot(lines);
    }
    if (x->GetNumberOfTuples() > 0)
    {
      vtkNew<vtkPlotPoints> dots;
      dots->SetInputData(table, 0, 1);
      dots->SetMarkerStyle(vtkPlotPoints::CIRCLE);
      dots->SetMarkerSize(Part(0.45 * text));
      dots->GetPen()->SetColorF(color[0], color[1], color[2]);
      chart->AddPlot(dots);
    }
    return;
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
  AddStrokes(chart, curve, scale, color, text);
}

void AddDashes(vtkRenderer* renderer, Point from, Point to, int text)
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
  AddLines(renderer, dashes, Faint, LineWidth(text));
}

void AddMarks(vtkRenderer* renderer, const Plot& plot, int text, const double rectangle[4])
{
  const double top = rectangle[1] + rectangle[3], right = rectangle[0] + rectangle[2];
  for (const auto& [place, name] : plot.References)
  {
    const double at = rectangle[0] + rectangle[2] * (place - plot.XLow) / (plot.XHigh - plot.XLow);
    if (at >= rectangle[0] && at <= right)
    {
      AddDashes(renderer, { at, rectangle[1] }, { at, top }, text);
      AddText(renderer,
              name,
              { at, top + 0.3 * text },
              { .Size = text * 9 / 10, .Horizontal = Align::Center, .Foreground = Faint });
    }
  }
  for (const auto& [level, name] : plot.Levels)
  {
    const double at = plot.Scale.Position(level);
    if (at >= 0 && at <= 1)
    {
      const double y = rectangle[1] + at * rectangle[3];
      AddDashes(renderer, { rectangle[0], y }, { right, y }, text);
      AddText(renderer,
              name,
              { right - 0.3 * text, y + 0.2 * text },
              { .Size = text * 9 / 10, .Horizontal = Align::High, .Foreground = Faint });
    }
  }
}
}

void AddCartesianPlot(vtkRenderer* renderer, const Plot& plot, int text, const double rectangle[4])
{
  vtkNew<vtkChartXY> chart;
  chart->SetAutoSize(false);
  chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
  chart->SetSize(vtkRectf(Part(rectangle[0]), Part(rectangle[1]), Part(rectangle[2]), Part(rectangle[3])));
  chart->SetShowLegend(false);
  const double step = plot.XStep;
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
  SetAxis(chart, vtkAxis::BOTTOM, plot.XLow, plot.XHigh, ticks, plot, text);
  SetAxis(chart, vtkAxis::LEFT, 0, 1, plot.Scale.Ticks(2.2 * text / rectangle[3]), plot, text);

  for (const PlotSeries& series : plot.Series)
  {
    AddSeries(chart, series, plot.Scale, text);
  }
  GetScene(renderer)->AddItem(chart);

  // The chart's own titles touch the numbers.
  AddText(renderer,
          plot.XTitle,
          { rectangle[0] + rectangle[2] / 2, rectangle[1] - 2.3 * text },
          { .Size = text, .Horizontal = Align::Center, .Vertical = Align::High });
  AddText(renderer,
          plot.YTitle,
          { rectangle[0] - 4.4 * text, rectangle[1] + rectangle[3] / 2 },
          { .Size = text, .Horizontal = Align::Center, .Angle = 90 });

  AddMarks(renderer, plot, text, rectangle);
}
}
