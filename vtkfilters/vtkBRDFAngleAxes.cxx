#include "vtkBRDFAngleAxes.h"

#include "vtkBRDFPlotData.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vtkBRDFDrawing
{
AngleAxis AngleAxis::OfSlice(const std::string& angle, double warp)
{
  const std::map<std::string, std::string> words = {
    { "theta_h", "half angle theta_h" },     { "theta_d", "difference angle theta_d" },
    { "theta_i", "incident angle theta_i" }, { "theta_o", "outgoing angle theta_o" },
    { "phi", "azimuth phi_o - phi_i" },      { "phi_d", "azimuth of the difference phi_d" }
  };
  const auto found = words.find(angle);
  AngleAxis axis;
  axis.Title = (found == words.end() ? angle : found->second) + " (degrees)";
  axis.Unit = "\u00b0";
  if (warp == 1)
  {
    axis.Ticks = { 0, 15, 30, 45, 60, 75, 90 };
    axis.Position = [](double degrees) { return degrees / 90; };
  }
  else
  {
    axis.Ticks =
      warp > 1 ? std::vector<double>{ 0, 1, 5, 15, 30, 45, 60, 90 } : std::vector<double>{ 0, 30, 60, 75, 90 };
    axis.Position = [warp](double degrees) { return std::pow(degrees / 90, 1 / warp); };
  }
  return axis;
}

AngleAxis AngleAxis::OfCurve(const std::string& angle)
{
  AngleAxis axis = OfSlice(angle, 1);
  const bool azimuth = angle.rfind("phi", 0) == 0;
  if (azimuth || angle == "theta_o")
  {
    const double end = azimuth ? 180 : 90;
    axis.Ticks = { -end, -2 * end / 3, -end / 3, 0, end / 3, 2 * end / 3, end };
    axis.Position = [end](double degrees) { return (degrees + end) / (2 * end); };
  }
  return axis;
}

AngleAxis AngleAxis::Plain(const std::string& title, double low, double high)
{
  AngleAxis axis;
  axis.Title = title;
  axis.Ticks = LinearTicks(low, high, 7);
  axis.Position = [low, high](double value) { return (value - low) / (high - low); };
  return axis;
}

std::string AngleAxis::NameOf(const AngleAxis& x, const AngleAxis& y)
{
  const auto bare = [](const std::string& title) { return title.substr(0, title.find(" (")); };
  return bare(x.Title) + " and " + bare(y.Title);
}

PanelGrid::PanelGrid(std::size_t count, double width, double height, int text)
  : Count(count)
  , Width(width)
  , Height(height)
  , RoomLeft(5.2 * text)
  , RoomBelow(3.9 * text)
  , RoomAbove(1.8 * text)
{
  for (std::size_t columns = 1; columns <= count; ++columns)
  {
    const std::size_t rows = (count + columns - 1) / columns;
    const double side = std::min(width / static_cast<double>(columns) - 1.2 * this->RoomLeft,
                                 height / static_cast<double>(rows) - this->RoomBelow - this->RoomAbove);
    if (side > this->Side)
    {
      this->Side = side;
      this->Columns = columns;
    }
  }
  this->Side = std::max(this->Side, 8.0);
}

PanelPlace PanelGrid::Place(std::size_t index, double left, double low) const
{
  const std::size_t rows = (this->Count + this->Columns - 1) / this->Columns;
  const double cellWidth = this->Width / static_cast<double>(this->Columns);
  const double cellHeight = this->Height / static_cast<double>(rows);
  const double x = left + cellWidth * static_cast<double>(index % this->Columns);
  const double y = low + cellHeight * static_cast<double>(rows - 1 - index / this->Columns);
  return { { x + this->RoomLeft + std::max(0.0, (cellWidth - 1.2 * this->RoomLeft - this->Side) / 2),
             y + this->RoomBelow + std::max(0.0, (cellHeight - this->RoomBelow - this->RoomAbove - this->Side) / 2) },
           this->Side };
}

void AddAngleAxes(vtkRenderer* renderer, const AngleAxis& x, const AngleAxis& y, const PanelPlace& place, int text)
{
  const double left = place.Low[0], low = place.Low[1], side = place.Side, right = left + side, high = low + side;
  const double tick = text / 3.0;
  std::vector<Line> lines = { { { left, low }, { right, low } },
                              { { left, high }, { right, high } },
                              { { left, low }, { left, high } },
                              { { right, low }, { right, high } } };
  for (const bool vertical : { false, true })
  {
    const AngleAxis& axis = vertical ? y : x;
    const double apart = (vertical ? 1.5 : 2.8) * text / side;
    std::vector<double> labelled;
    // The ends first, then what fits between.
    std::vector<double> order = axis.Ticks;
    if (order.size() > 1)
    {
      std::rotate(order.begin() + 1, order.end() - 1, order.end());
    }
    for (const double value : order)
    {
      const double at = axis.Position(value);
      const Point foot = vertical ? Point{ left, low + at * side } : Point{ left + at * side, low };
      lines.push_back({ { foot[0] - (vertical ? tick : 0), foot[1] - (vertical ? 0 : tick) }, foot });
      if (std::any_of(labelled.begin(), labelled.end(), [&](double other) { return std::abs(other - at) < apart; }))
      {
        continue;
      }
      labelled.push_back(at);
      AddText(renderer,
              NumberText(value) + axis.Unit,
              { foot[0] - (vertical ? 1.6 * tick : 0), foot[1] - (vertical ? 0 : 1.6 * tick) },
              { .Size = text,
                .Horizontal = vertical ? Align::High : Align::Center,
                .Vertical = vertical ? Align::Center : Align::High });
    }
  }
  AddLines(renderer, lines, Ink, LineWidth(text));
  // A title longer than its axis says its last word only: the symbol.
  const auto fitting = [&](const std::string& title)
  {
    if (0.52 * text * static_cast<double>(title.size()) < side)
    {
      return title;
    }
    const std::string bare = title.substr(0, title.find(" ("));
    return bare.substr(bare.rfind(' ') == std::string::npos ? 0 : bare.rfind(' ') + 1);
  };
  AddText(renderer,
          fitting(x.Title),
          { left + side / 2, low - 2.2 * text },
          { .Size = text, .Horizontal = Align::Center, .Vertical = Align::High });
  AddText(renderer,
          fitting(y.Title),
          { left - 3.4 * text, low + side / 2 },
          { .Size = text, .Horizontal = Align::Center, .Vertical = Align::Low, .Angle = 90 });
}

void AddHatches(vtkRenderer* renderer,
                const int size[2],
                const std::vector<unsigned char>& states,
                const PanelPlace& place,
                int text)
{
  const double pixelX = place.Side / size[0], pixelY = place.Side / size[1];
  const double gap = 0.8 * text, step = std::max(0.25 * text, 1.0);
  const auto stateAt = [&](double x, double y)
  {
    const auto column = std::clamp(static_cast<int>(x / pixelX), 0, size[0] - 1);
    const auto row = std::clamp(static_cast<int>(y / pixelY), 0, size[1] - 1);
    return states[static_cast<std::size_t>(row) * static_cast<std::size_t>(size[0]) + static_cast<std::size_t>(column)];
  };
  std::vector<Line> lines;
  for (const bool rising : { true, false })
  {
    for (double offset = -place.Side; offset < (rising ? 1 : 2) * place.Side; offset += gap)
    {
      // Along each diagonal, stretches of one kind.
      Point start{}, end{};
      bool open = false;
      const auto close = [&]
      {
        if (open)
        {
          lines.push_back(
            { { place.Low[0] + start[0], place.Low[1] + start[1] }, { place.Low[0] + end[0], place.Low[1] + end[1] } });
        }
        open = false;
      };
      for (double x = 0; x < place.Side; x += step)
      {
        const double next = std::min(x + step, place.Side);
        const double y = rising ? x + offset : offset - x, nextY = rising ? next + offset : offset - next;
        const double middleX = (x + next) / 2, middleY = (y + nextY) / 2;
        const bool inside = std::min(y, nextY) >= 0 && std::max(y, nextY) <= place.Side;
        const unsigned char state = inside ? stateAt(middleX, middleY) : 1;
        if (state == 0 || (state == 3 && rising))
        {
          if (!open)
          {
            start = { x, y };
          }
          end = { next, nextY };
          open = true;
        }
        else
        {
          close();
        }
      }
      close();
    }
  }
  AddLines(renderer, lines, Hatch, LineWidth(text));
}

void AddDataEdges(vtkRenderer* renderer,
                  const int size[2],
                  const std::vector<unsigned char>& states,
                  const PanelPlace& place,
                  int text)
{
  const auto at = [&](int x, int y)
  { return states[static_cast<std::size_t>(y) * static_cast<std::size_t>(size[0]) + static_cast<std::size_t>(x)]; };
  const auto differ = [](unsigned char a, unsigned char b) { return (a == 1 && b == 2) || (a == 2 && b == 1); };
  const auto point = [&](int x, int y) -> Point {
    return { place.Low[0] + place.Side * x / size[0], place.Low[1] + place.Side * y / size[1] };
  };
  std::vector<Line> lines;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      if (x > 0 && differ(at(x - 1, y), at(x, y)))
      {
        lines.push_back({ point(x, y), point(x, y + 1) });
      }
      if (y > 0 && differ(at(x, y - 1), at(x, y)))
      {
        lines.push_back({ point(x, y), point(x + 1, y) });
      }
    }
  }
  AddLines(renderer, lines, { 1, 1, 1 }, LineWidth(text));
}

void AddValueBar(vtkRenderer* renderer,
                 const PlotScale& scale,
                 const std::string& title,
                 Point low,
                 Point high,
                 int text)
{
  constexpr int steps = 256;
  std::vector<Rectangle> strips;
  const auto y = [&](double share) { return low[1] + share * (high[1] - low[1]); };
  for (int k = 0; k < steps; ++k)
  {
    strips.push_back(
      { { low[0], y(1.0 * k / steps) }, { high[0], y((k + 1.0) / steps) }, Sequential((k + 0.5) / steps) });
  }
  AddRectangles(renderer, strips);
  std::vector<Line> lines = { { { low[0], low[1] }, { high[0], low[1] } },
                              { { low[0], high[1] }, { high[0], high[1] } },
                              { { low[0], low[1] }, { low[0], high[1] } },
                              { { high[0], low[1] }, { high[0], high[1] } } };
  for (const double tick : scale.Ticks(2.0 * text / (high[1] - low[1])))
  {
    const double at = y(scale.Position(tick));
    lines.push_back({ { high[0], at }, { high[0] + text / 3.0, at } });
    AddText(renderer, NumberText(tick), { high[0] + text / 2.0, at }, { .Size = text, .Vertical = Align::Center });
  }
  AddLines(renderer, lines, Ink, LineWidth(text));
  AddText(renderer, title, { low[0], high[1] + 0.6 * text }, { .Size = text });
}
}
