#include "vtkBRDFPlotData.h"

#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <cmath>

namespace vtkBRDFDrawing
{
namespace
{
constexpr Color Grid = { 0.86, 0.86, 0.88 };

/** Where things lie in the plot. */
struct Polar
{
  Point Center;
  double Radius;
  bool Full;

  /** A full circle has 0 to the right and counts counter-clockwise, half a one has 0 up and counts to the right. */
  Point At(double degrees, double share) const
  {
    const double angle = brdf::radians(this->Full ? degrees : 90 - degrees);
    const double r = this->Radius * std::clamp(share, 0.0, 1.0);
    return { this->Center[0] + r * std::cos(angle), this->Center[1] + r * std::sin(angle) };
  }
  double Low() const { return this->Full ? -180 : -90; }
  double High() const { return this->Full ? 180 : 90; }
};

void AddArc(std::vector<Line>& lines, const Polar& polar, double share)
{
  const int steps = 90;
  for (int k = 0; k < steps; ++k)
  {
    const auto angle = [&](int at) { return polar.Low() + (polar.High() - polar.Low()) * at / steps; };
    lines.push_back({ polar.At(angle(k), share), polar.At(angle(k + 1), share) });
  }
}

void AddGrid(vtkRenderer* renderer, const Polar& polar, const PlotScale& scale, int text)
{
  std::vector<Line> grid, rim;
  std::vector<double> ticks = scale.Ticks(2.2 * text / polar.Radius);
  for (const double tick : ticks)
  {
    AddArc(grid, polar, scale.Position(tick));
  }
  const int step = polar.Full ? 30 : 15;
  for (int degrees = static_cast<int>(polar.Low()); degrees <= static_cast<int>(polar.High()); degrees += step)
  {
    grid.push_back({ polar.Center, polar.At(degrees, 1) });
    if (polar.Full && degrees == -180)
    {
      continue;
    }
    Point at = polar.At(degrees, 1);
    const Point outward = { (at[0] - polar.Center[0]) / polar.Radius, (at[1] - polar.Center[1]) / polar.Radius };
    at = { at[0] + 0.5 * text * outward[0], at[1] + 0.5 * text * outward[1] };
    const auto align = [](double direction) {
      return direction > 0.2 ? Align::Low : direction < -0.2 ? Align::High : Align::Center;
    };
    AddText(renderer,
            std::to_string(degrees) + "\u00b0",
            at,
            { .Size = text, .Horizontal = align(outward[0]), .Vertical = align(outward[1]) });
  }
  AddLines(renderer, grid, Grid, LineWidth(text));
  AddArc(rim, polar, 1);
  if (!polar.Full)
  {
    rim.push_back({ polar.At(-90, 1), polar.At(90, 1) });
  }
  AddLines(renderer, rim, Ink, LineWidth(text));
}

// Values are written under the horizon, or along a ray between two of the grid's.
void AddValues(vtkRenderer* renderer, const Polar& polar, const PlotScale& scale, const std::string& title, int text)
{
  for (const double tick : scale.Ticks((polar.Full ? 2.5 : 4.0) * text / polar.Radius))
  {
    const double share = scale.Position(tick);
    if (polar.Full)
    {
      AddText(renderer,
              NumberText(tick),
              polar.At(75, share),
              { .Size = text * 9 / 10, .Horizontal = Align::Center, .Vertical = Align::Center, .Foreground = Faint });
      continue;
    }
    for (const double side : { -90.0, 90.0 })
    {
      if (side > 0 && share < 1e-6)
      {
        continue;
      }
      const Point at = polar.At(side, share);
      AddText(renderer,
              NumberText(tick),
              { at[0], at[1] - 0.4 * text },
              { .Size = text, .Horizontal = Align::Center, .Vertical = Align::High });
    }
  }
  const Point below = polar.Full ? Point{ polar.Center[0], polar.Center[1] - polar.Radius - 2.6 * text }
                                 : Point{ polar.Center[0], polar.Center[1] - 2.0 * text };
  AddText(renderer,
          title,
          below,
          { .Size = text, .Horizontal = Align::Center, .Vertical = polar.Full ? Align::Center : Align::High });
}

void AddSeries(vtkRenderer* renderer, const Polar& polar, const PlotScale& scale, const PlotSeries& series, int text)
{
  const PlotCurve& curve = series.Curve;
  const auto at = [&](std::size_t i, double value) { return polar.At(curve.X[i], scale.Position(value)); };
  const bool errors = !curve.Error.empty();
  std::vector<Line> strokes, pale, bars;
  std::vector<Point> dots;
  for (std::size_t i = 0; i < curve.X.size(); ++i)
  {
    if (!std::isfinite(curve.Y[i]))
    {
      continue;
    }
    if (errors && curve.Error[i] > 0)
    {
      bars.push_back({ at(i, curve.Y[i] - curve.Error[i]), at(i, curve.Y[i] + curve.Error[i]) });
    }
    if (series.Points)
    {
      dots.push_back(at(i, curve.Y[i]));
    }
    else if (i > 0 && std::isfinite(curve.Y[i - 1]))
    {
      (curve.IsBeyond(i) ? pale : strokes).push_back({ at(i - 1, curve.Y[i - 1]), at(i, curve.Y[i]) });
    }
  }
  if (series.Points)
  {
    AddLines(renderer, bars, series.Stroke, LineWidth(text));
    AddDots(renderer, dots, 0.22 * text, series.Stroke);
    return;
  }
  // The band as its two edges: it may be narrower than the line.
  for (const double sign : { -1.0, 1.0 })
  {
    std::vector<Line> edge;
    for (std::size_t i = 1; errors && i < curve.X.size(); ++i)
    {
      const double from = curve.Y[i - 1] + sign * curve.Error[i - 1], to = curve.Y[i] + sign * curve.Error[i];
      if (std::isfinite(from) && std::isfinite(to))
      {
        edge.push_back({ at(i - 1, from), at(i, to) });
      }
    }
    AddLines(renderer, edge, Pale(series.Stroke), LineWidth(text));
  }
  AddLines(renderer, pale, Pale(series.Stroke), 1.8 * LineWidth(text));
  AddLines(renderer, strokes, series.Stroke, 1.8 * LineWidth(text));
}

// An arrow on the rim, outside the angles' names.
void AddMark(vtkRenderer* renderer, const Polar& polar, const PlotMark& mark, int text)
{
  const Point rim = polar.At(mark.At, 1);
  const Point out = { (rim[0] - polar.Center[0]) / polar.Radius, (rim[1] - polar.Center[1]) / polar.Radius };
  const auto away = [&](double distance, double aside) -> Point
  {
    return { rim[0] + distance * text * out[0] - aside * text * out[1],
             rim[1] + distance * text * out[1] + aside * text * out[0] };
  };
  AddLines(renderer,
           { { away(-1.2, 0), away(0.2, 0) }, { away(-1.2, 0), away(-0.7, 0.3) }, { away(-1.2, 0), away(-0.7, -0.3) } },
           Faint,
           1.5 * LineWidth(text));
  const Point at = away(3.2, 0);
  AddText(renderer,
          mark.Text,
          at,
          { .Size = text,
            .Horizontal = out[0] > 0.2    ? Align::Low
                          : out[0] < -0.2 ? Align::High
                                          : Align::Center,
            .Vertical = Align::Center,
            .Foreground = Faint });
}
}

void AddPolarPlot(vtkRenderer* renderer, const Plot& plot, bool full, int text, const double rectangle[4])
{
  Polar polar;
  polar.Full = full;
  const double width = rectangle[2] - 10 * text, height = rectangle[3] - (full ? 7.5 : 5.5) * text;
  polar.Radius = std::max(4.0, full ? std::min(width, height) / 2 : std::min(width / 2, height));
  polar.Center = { rectangle[0] + rectangle[2] / 2,
                   full ? rectangle[1] + 4 * text + height / 2
                        : rectangle[1] + 3.6 * text + (height - polar.Radius) / 2 };
  AddGrid(renderer, polar, plot.Scale, text);
  for (const PlotSeries& one : plot.Series)
  {
    AddSeries(renderer, polar, plot.Scale, one, text);
  }
  AddValues(renderer, polar, plot.Scale, plot.YTitle + " over " + plot.XTitle, text);
  for (const PlotMark& mark : plot.References)
  {
    AddMark(renderer, polar, mark, text);
  }
}
}
