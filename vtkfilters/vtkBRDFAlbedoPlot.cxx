#include "vtkBRDFAlbedoPlot.h"

#include "vtkDataArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <map>

using namespace vtkBRDFDrawing;

namespace
{
/** Channels named after a colour have it. */
Color CurveColor(const std::string& name, std::size_t index)
{
  const std::map<std::string, Color> colors = { { "red", { 0.80, 0.15, 0.15 } },
                                                { "green", { 0.10, 0.55, 0.20 } },
                                                { "blue", { 0.10, 0.30, 0.80 } } };
  const auto found = colors.find(name);
  return found == colors.end() ? PaletteColor(index) : found->second;
}
}

void vtkBRDFDrawing::AddAlbedoPlot(vtkRenderer* renderer,
                                   vtkTable* table,
                                   Point from,
                                   Point to,
                                   int size,
                                   const Color& alarm)
{
  const double text = size;
  const Point low = { from[0] + 5 * text, from[1] + 4 * text };
  const Point high = { to[0] - 9 * text, to[1] - text };
  double top = 1.1;
  for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
  {
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      if (std::string(table->GetColumnName(column)) != "theta")
      {
        top = std::max(top, 1.05 * table->GetValue(row, column).ToDouble());
      }
    }
  }
  const auto x = [&](double degrees) { return low[0] + degrees / 90 * (high[0] - low[0]); };
  const auto y = [&](double value) { return low[1] + value / top * (high[1] - low[1]); };
  std::vector<Line> axes = { { { x(0), y(0) }, { x(90), y(0) } }, { { x(0), y(0) }, { x(0), y(top) } } };
  for (int degrees = 0; degrees <= 90; degrees += 15)
  {
    axes.push_back({ { x(degrees), y(0) - text / 3 }, { x(degrees), y(0) } });
    AddText(renderer,
            std::to_string(degrees) + "\u00b0",
            { x(degrees), y(0) - text / 2 },
            { .Size = size, .Horizontal = Align::Center, .Vertical = Align::High });
  }
  for (double value : LinearTicks(0, top, 6))
  {
    axes.push_back({ { x(0) - text / 3, y(value) }, { x(0), y(value) } });
    AddText(renderer,
            NumberText(value),
            { x(0) - text / 2, y(value) },
            { .Size = size, .Horizontal = Align::High, .Vertical = Align::Center });
  }
  AddLines(renderer, axes, Ink, LineWidth(size));
  std::vector<Line> bound;
  for (double degrees = 0; degrees < 90; degrees += 2)
  {
    bound.push_back({ { x(degrees), y(1) }, { x(degrees + 1), y(1) } });
  }
  AddLines(renderer, bound, alarm, LineWidth(size));
  AddText(renderer,
          "white furnace: all light",
          { high[0] + text / 2, y(1) },
          { .Size = size * 3 / 4, .Vertical = Align::Center, .Foreground = alarm });
  AddText(renderer,
          "angle of the light from the normal, theta_i (degrees)",
          { x(45), low[1] - 2.2 * text },
          { .Size = size, .Horizontal = Align::Center, .Vertical = Align::High });
  AddText(renderer,
          "directional albedo",
          { low[0] - 3.6 * text, y(top / 2) },
          { .Size = size, .Horizontal = Align::Center, .Vertical = Align::Low, .Angle = 90 });
  std::size_t curve = 0;
  for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
  {
    const std::string name = table->GetColumnName(column);
    if (name == "theta")
    {
      continue;
    }
    const Color color = CurveColor(name, curve++);
    std::vector<Line> lines;
    Point last = { 0, 0 };
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      const Point at = { x(table->GetValueByName(row, "theta").ToDouble()),
                         y(table->GetValue(row, column).ToDouble()) };
      if (row > 0)
      {
        lines.push_back({ last, at });
      }
      last = at;
    }
    AddLines(renderer, lines, color, 2 * LineWidth(size));
    AddText(renderer,
            name,
            { x(0) + text + 7 * text * static_cast<double>(curve - 1), y(top) + text / 4 },
            { .Size = size, .Vertical = Align::High, .Foreground = color, .Bold = true });
  }
}
