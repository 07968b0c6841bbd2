#include "vtkBRDFColorScale.h"

#include <algorithm>
#include <cmath>

namespace vtkBRDFDrawing
{
namespace
{
// Round numbers of every size in the range, the roundest first.
std::vector<double> TickCandidates(const ColorScale& scale)
{
  std::vector<double> all;
  const double largest = std::max(std::abs(scale.Low), std::abs(scale.High));
  if (scale.Low <= 0 && scale.High >= 0)
  {
    all.push_back(0);
  }
  if (!(largest > 0))
  {
    return all;
  }
  const int top = static_cast<int>(std::floor(std::log10(largest)));
  for (double factor : { 1.0, 5.0, 2.0 })
  {
    for (int decade = top; decade > top - 12; --decade)
    {
      for (double sign : { 1.0, -1.0 })
      {
        const double tick = sign * factor * std::pow(10, decade);
        if (tick >= scale.Low - 1e-9 * largest && tick <= scale.High + 1e-9 * largest)
        {
          all.push_back(tick);
        }
      }
    }
  }
  return all;
}

std::vector<double> Ticks(const ColorScale& scale, double pixels, int text)
{
  if (!scale.Transform)
  {
    return LinearTicks(scale.Low, scale.High, std::clamp(static_cast<int>(pixels / (2.2 * text)), 2, 10));
  }
  std::vector<double> chosen;
  for (double tick : TickCandidates(scale))
  {
    const auto close = [&](double other)
    { return std::abs(scale.Position(other) - scale.Position(tick)) * pixels < 1.7 * text; };
    if (std::none_of(chosen.begin(), chosen.end(), close))
    {
      chosen.push_back(tick);
    }
  }
  return chosen;
}
}

double ColorScale::Position(double value) const
{
  const double low = this->Transformed(this->Low);
  const double high = this->Transformed(this->High);
  const double t = (this->Transformed(value) - low) / (high - low);
  return std::isfinite(t) ? std::clamp(t, 0.0, 1.0) : 0.0;
}

ColorScale SignedScale(double high)
{
  ColorScale scale;
  scale.Low = -high;
  scale.High = high;
  scale.Signed = true;
  return scale;
}

ColorScale LogarithmicScale(double low, double high)
{
  ColorScale scale;
  scale.Low = low;
  scale.High = high;
  scale.Transform = [low](double value) { return std::log(std::max(value, low)); };
  return scale;
}

void AddColorBar(vtkRenderer* renderer,
                 const ColorScale& scale,
                 Point low,
                 Point high,
                 int text,
                 const std::string& title)
{
  const int steps = 256;
  const double height = high[1] - low[1];
  std::vector<Rectangle> strips;
  for (int i = 0; i < steps; ++i)
  {
    strips.push_back({ { low[0], low[1] + height * i / steps },
                       { high[0], low[1] + height * (i + 1) / steps },
                       scale.At((i + 0.5) / steps) });
  }
  AddRectangles(renderer, strips);
  std::vector<Line> lines = { { low, { high[0], low[1] } },
                              { { low[0], high[1] }, high },
                              { low, { low[0], high[1] } },
                              { { high[0], low[1] }, high } };
  for (double value : Ticks(scale, height, text))
  {
    const double y = low[1] + height * scale.Position(value);
    lines.push_back({ { high[0], y }, { high[0] + text / 3.0, y } });
    AddText(renderer, NumberText(value), { high[0] + text / 2.0, y }, { .Size = text, .Vertical = Align::Center });
  }
  AddLines(renderer, lines, Ink, LineWidth(text));
  if (!title.empty())
  {
    AddText(renderer,
            Shortened(title, static_cast<std::size_t>(1.85 * height / text)),
            { low[0] - 0.4 * text, (low[1] + high[1]) / 2 },
            { .Size = text, .Horizontal = Align::Center, .Vertical = Align::Low, .Angle = 90 });
  }
}
}
