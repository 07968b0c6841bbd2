#include "vtkBRDFDrawing.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkTexturedActor2D.h"
#include "vtkUnsignedCharArray.h"

#include <brdf/base/Text.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace vtkBRDFDrawing
{
namespace
{
template<std::size_t Count>
Color Interpolated(const std::array<Color, Count>& colors, double t)
{
  const double scaled = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0) * (Count - 1);
  const auto low = std::min(static_cast<std::size_t>(scaled), Count - 2);
  const double share = scaled - static_cast<double>(low);
  Color color{};
  for (int c = 0; c < 3; ++c)
  {
    color[c] = (1 - share) * colors[low][c] + share * colors[low + 1][c];
  }
  return color;
}

void AddActor(vtkRenderer* renderer, vtkPolyData* data, const Color& color, double width)
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  renderer->AddViewProp(actor);
}
}

void AddText(vtkRenderer* renderer, const std::string& text, Point at, const TextStyle& style)
{
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->SetTextScaleModeToNone();
  actor->SetPosition(std::round(at[0]), std::round(at[1]));
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontFamilyToArial();
  property->SetFontSize(style.Size);
  property->SetBold(style.Bold);
  property->SetColor(style.Foreground[0], style.Foreground[1], style.Foreground[2]);
  property->SetOrientation(style.Angle);
  // VTK's own constants are 0 left or bottom, 1 centred, 2 right or top.
  property->SetJustification(static_cast<int>(style.Horizontal));
  property->SetVerticalJustification(static_cast<int>(style.Vertical));
  renderer->AddViewProp(actor);
}

void AddHeading(vtkRenderer* renderer, const std::string& title, const std::string& note, double top, int text)
{
  AddText(renderer, title, { 1.0 * text, top }, { .Size = text * 6 / 5, .Vertical = Align::High, .Bold = true });
  AddText(
    renderer, note, { 1.0 * text, top - 1.8 * text }, { .Size = text, .Vertical = Align::High, .Foreground = Faint });
}

void AddLines(vtkRenderer* renderer, const std::vector<Line>& lines, const Color& color, double width)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Line& line : lines)
  {
    const vtkIdType from = points->InsertNextPoint(line.From[0], line.From[1], 0);
    const vtkIdType to = points->InsertNextPoint(line.To[0], line.To[1], 0);
    cells->InsertNextCell({ from, to });
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  AddActor(renderer, data, color, width);
}

void AddRectangles(vtkRenderer* renderer, const std::vector<Rectangle>& rectangles)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (const Rectangle& r : rectangles)
  {
    const vtkIdType first = points->InsertNextPoint(r.Low[0], r.Low[1], 0);
    points->InsertNextPoint(r.High[0], r.Low[1], 0);
    points->InsertNextPoint(r.High[0], r.High[1], 0);
    points->InsertNextPoint(r.Low[0], r.High[1], 0);
    cells->InsertNextCell({ first, first + 1, first + 2, first + 3 });
    for (double component : r.Fill)
    {
      colors->InsertNextValue(static_cast<unsigned char>(std::lround(255 * std::clamp(component, 0.0, 1.0))));
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetCellData()->SetScalars(colors);
  AddActor(renderer, data, Ink, 1);
}

void AddImage(vtkRenderer* renderer, vtkImageData* image, Point low, Point high)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> corners;
  corners->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(4);
  for (const Point& corner : { Point{ 0, 0 }, Point{ 1, 0 }, Point{ 1, 1 }, Point{ 0, 1 } })
  {
    cells->InsertCellPoint(
      points->InsertNextPoint(low[0] + corner[0] * (high[0] - low[0]), low[1] + corner[1] * (high[1] - low[1]), 0));
    corners->InsertNextTuple(corner.data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetTCoords(corners);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  vtkNew<vtkTexturedActor2D> actor;
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  renderer->AddViewProp(actor);
}

void AddDots(vtkRenderer* renderer, const std::vector<Point>& centers, double radius, const Color& color)
{
  constexpr int corners = 24;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Point& center : centers)
  {
    cells->InsertNextCell(corners);
    for (int corner = 0; corner < corners; ++corner)
    {
      const double angle = 2 * std::acos(-1.0) * corner / corners;
      cells->InsertCellPoint(
        points->InsertNextPoint(center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle), 0));
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  AddActor(renderer, data, color, 1);
}

Color PaletteColor(std::size_t index)
{
  static const std::array<Color, 10> colors = { { { 0.00, 0.45, 0.70 },
                                                 { 0.80, 0.40, 0.00 },
                                                 { 0.00, 0.62, 0.45 },
                                                 { 0.80, 0.60, 0.70 },
                                                 { 0.35, 0.70, 0.90 },
                                                 { 0.90, 0.60, 0.00 },
                                                 { 0.95, 0.90, 0.25 },
                                                 { 0.50, 0.50, 0.50 },
                                                 { 0.38, 0.15, 0.45 },
                                                 { 0.45, 0.20, 0.10 } } };
  return colors[index % colors.size()];
}

Color Sequential(double t)
{
  static const std::array<Color, 11> viridis = { { { 0.267004, 0.004874, 0.329415 },
                                                   { 0.282623, 0.140926, 0.457517 },
                                                   { 0.253935, 0.265254, 0.529983 },
                                                   { 0.206756, 0.371758, 0.553117 },
                                                   { 0.163625, 0.471133, 0.558148 },
                                                   { 0.127568, 0.566949, 0.550556 },
                                                   { 0.134692, 0.658636, 0.517649 },
                                                   { 0.266941, 0.748751, 0.440573 },
                                                   { 0.477504, 0.821444, 0.318195 },
                                                   { 0.741388, 0.873449, 0.149561 },
                                                   { 0.993248, 0.906157, 0.143936 } } };
  return Interpolated(viridis, t);
}

Color Diverging(double t)
{
  static const std::array<Color, 9> blueWhiteRed = { { { 0.230, 0.299, 0.754 },
                                                       { 0.384, 0.510, 0.917 },
                                                       { 0.554, 0.690, 0.996 },
                                                       { 0.718, 0.811, 0.976 },
                                                       { 0.865, 0.865, 0.865 },
                                                       { 0.957, 0.770, 0.678 },
                                                       { 0.957, 0.603, 0.482 },
                                                       { 0.871, 0.377, 0.302 },
                                                       { 0.706, 0.016, 0.150 } } };
  return Interpolated(blueWhiteRed, t);
}

std::vector<double> LinearTicks(double low, double high, int count)
{
  std::vector<double> ticks;
  if (!(high > low) || count < 1)
  {
    return ticks;
  }
  const double power = std::pow(10, std::floor(std::log10((high - low) / count)));
  double step = power;
  for (double factor : { 2.0, 5.0, 10.0 })
  {
    if ((high - low) / step > count)
    {
      step = factor * power;
    }
  }
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
  {
    ticks.push_back(k == 0 ? 0 : k * step); // never minus zero
  }
  return ticks;
}

std::vector<double> LogarithmicTicks(double low, double high)
{
  std::vector<double> ticks;
  if (!(low > 0) || !(high > low))
  {
    return ticks;
  }
  const bool between = std::log10(high / low) < 3;
  for (double decade = std::floor(std::log10(low)); decade <= std::log10(high); ++decade)
  {
    for (double factor : { 1.0, 2.0, 5.0 })
    {
      const double tick = factor * std::pow(10, decade);
      if (tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9) && (factor == 1 || between))
      {
        ticks.push_back(tick);
      }
    }
  }
  return ticks;
}

std::string NumberText(double value, int digits)
{
  std::string text = brdf::formatNumber(*brdf::parseNumber(brdf::formatNumber(value, digits)));
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && exponent + 2 < text.size() && text[exponent + 2] == '0')
  {
    text.erase(exponent + 2, 1); // 1e-04 is 1e-4
  }
  return text;
}

std::string Rounded(const std::string& text, int digits)
{
  std::string rounded;
  for (std::size_t i = 0; i < text.size();)
  {
    const bool starts =
      text[i] >= '0' && text[i] <= '9' && (i == 0 || !(std::isalnum(text[i - 1]) || text[i - 1] == '_'));
    std::size_t end = i + 1;
    while (starts && end < text.size() &&
           (std::isdigit(text[end]) || text[end] == '.' || text[end] == 'e' ||
            (text[end - 1] == 'e' && (text[end] == '-' || text[end] == '+'))))
    {
      ++end;
    }
    const std::string piece = text.substr(i, end - i);
    const auto number = starts ? brdf::parseNumber(piece) : std::nullopt;
    rounded += number ? NumberText(*number, digits) : piece;
    i = end;
  }
  return rounded;
}

std::string Shortened(const std::string& text, std::size_t length)
{
  if (text.size() <= length || length < 8)
  {
    return text;
  }
  const std::size_t kept = length - 3;
  return text.substr(0, kept - kept / 3) + "..." + text.substr(text.size() - kept / 3);
}
}
