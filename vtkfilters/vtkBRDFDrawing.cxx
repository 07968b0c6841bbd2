#include "vtkBRDFDrawing.h"

#include "vtkBrush.h"
#include "vtkCellArray.h"
#include "vtkContext2D.h"
#include "vtkContextActor.h"
#include "vtkContextItem.h"
#include "vtkContextScene.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRect.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <brdf/base/Text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>

namespace
{
/** A piece of a drawing on the scene of a renderer, from where it goes to the screen and to files of vectors alike. */
class vtkBRDFDrawingItem : public vtkContextItem
{
public:
  static vtkBRDFDrawingItem* New();
  vtkTypeMacro(vtkBRDFDrawingItem, vtkContextItem);
  bool Paint(vtkContext2D* painter) override
  {
    this->Painting(painter);
    return true;
  }
  std::function<void(vtkContext2D*)> Painting;
};
vtkStandardNewMacro(vtkBRDFDrawingItem);
}

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

void AddPainting(vtkRenderer* renderer, std::function<void(vtkContext2D*)> painting)
{
  vtkNew<vtkBRDFDrawingItem> item;
  item->Painting = std::move(painting);
  GetScene(renderer)->AddItem(item);
}

std::array<unsigned char, 4> Bytes(const Color& color)
{
  std::array<unsigned char, 4> bytes{ 0, 0, 0, 255 };
  for (int c = 0; c < 3; ++c)
  {
    bytes[c] = static_cast<unsigned char>(std::lround(255 * std::clamp(color[c], 0.0, 1.0)));
  }
  return bytes;
}

void AddPolygons(vtkRenderer* renderer, vtkPolyData* data, vtkUnsignedCharArray* colors)
{
  AddPainting(renderer,
              [data = vtkSmartPointer<vtkPolyData>(data),
               colors = vtkSmartPointer<vtkUnsignedCharArray>(colors)](vtkContext2D* painter)
              {
                painter->GetPen()->SetLineType(vtkPen::NO_PEN);
                painter->DrawPolyData(0, 0, data, colors, VTK_SCALAR_MODE_USE_CELL_DATA);
              });
}
}

vtkContextScene* GetScene(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  if (auto* last = vtkContextActor::SafeDownCast(props->GetLastProp()))
  {
    return last->GetScene();
  }
  vtkNew<vtkContextActor> actor;
  renderer->AddViewProp(actor);
  return actor->GetScene();
}

void AddText(vtkRenderer* renderer, const std::string& text, Point at, const TextStyle& style)
{
  AddPainting(renderer,
              [text, at, style](vtkContext2D* painter)
              {
                vtkTextProperty* property = painter->GetTextProp();
                property->SetFontFamilyToArial();
                property->SetFontSize(style.Size);
                property->SetBold(style.Bold);
                property->SetItalic(false);
                property->SetColor(style.Foreground[0], style.Foreground[1], style.Foreground[2]);
                property->SetOpacity(1);
                property->SetOrientation(style.Angle);
                // VTK's own constants are 0 left or bottom, 1 centred, 2 right or top.
                property->SetJustification(static_cast<int>(style.Horizontal));
                property->SetVerticalJustification(static_cast<int>(style.Vertical));
                painter->ApplyTextProp(property);
                painter->DrawString(
                  static_cast<float>(std::round(at[0])), static_cast<float>(std::round(at[1])), text.c_str());
              });
}

double AddHeading(vtkRenderer* renderer, const std::string& title, const std::string& note, double top, int text)
{
  AddText(renderer, title, { 1.0 * text, top }, { .Size = text * 6 / 5, .Vertical = Align::High, .Bold = true });
  const auto letters = static_cast<std::size_t>(std::max(20.0, (renderer->GetSize()[0] - 2 * text) / (0.54 * text)));
  std::vector<std::string> lines;
  std::string rest = note;
  while (rest.size() > letters)
  {
    const std::size_t at = rest.rfind("; ", letters);
    if (at == std::string::npos)
    {
      break;
    }
    lines.push_back(rest.substr(0, at + 1));
    rest.erase(0, at + 2);
  }
  lines.push_back(rest);
  double y = top - 1.8 * text;
  for (const std::string& line : lines)
  {
    AddText(renderer, line, { 1.0 * text, y }, { .Size = text, .Vertical = Align::High, .Foreground = Faint });
    y -= 1.35 * text;
  }
  return y;
}

void AddLines(vtkRenderer* renderer, const std::vector<Line>& lines, const Color& color, double width)
{
  std::vector<float> points;
  points.reserve(4 * lines.size());
  for (const Line& line : lines)
  {
    for (const double number : { line.From[0], line.From[1], line.To[0], line.To[1] })
    {
      points.push_back(static_cast<float>(number));
    }
  }
  if (points.empty())
  {
    return;
  }
  AddPainting(renderer,
              [points, color, width](vtkContext2D* painter) mutable
              {
                painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
                painter->GetPen()->SetColorF(color[0], color[1], color[2]);
                painter->GetPen()->SetOpacity(255);
                painter->GetPen()->SetWidth(static_cast<float>(width));
                painter->DrawLines(points.data(), static_cast<int>(points.size() / 2));
              });
}

void AddRectangles(vtkRenderer* renderer, const std::vector<Rectangle>& rectangles)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (const Rectangle& r : rectangles)
  {
    const vtkIdType first = points->InsertNextPoint(r.Low[0], r.Low[1], 0);
    points->InsertNextPoint(r.High[0], r.Low[1], 0);
    points->InsertNextPoint(r.High[0], r.High[1], 0);
    points->InsertNextPoint(r.Low[0], r.High[1], 0);
    cells->InsertNextCell({ first, first + 1, first + 2, first + 3 });
    colors->InsertNextTypedTuple(Bytes(r.Fill).data());
  }
  if (rectangles.empty())
  {
    return;
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  AddPolygons(renderer, data, colors);
}

void AddImage(vtkRenderer* renderer, vtkImageData* image, Point low, Point high)
{
  const vtkRectf place(static_cast<float>(low[0]),
                       static_cast<float>(low[1]),
                       static_cast<float>(high[0] - low[0]),
                       static_cast<float>(high[1] - low[1]));
  AddPainting(renderer,
              [image = vtkSmartPointer<vtkImageData>(image), place](vtkContext2D* painter)
              { painter->DrawImage(place, image); });
}

void AddDots(vtkRenderer* renderer, const std::vector<Point>& centers, double radius, const Color& color)
{
  constexpr int corners = 24;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (const Point& center : centers)
  {
    cells->InsertNextCell(corners);
    for (int corner = 0; corner < corners; ++corner)
    {
      const double angle = 2 * std::acos(-1.0) * corner / corners;
      cells->InsertCellPoint(
        points->InsertNextPoint(center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle), 0));
    }
    colors->InsertNextTypedTuple(Bytes(color).data());
  }
  if (centers.empty())
  {
    return;
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  AddPolygons(renderer, data, colors);
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
