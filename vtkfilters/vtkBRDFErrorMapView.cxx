#include "vtkBRDFErrorMapView.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBRDFColorScale.h"
#include "vtkBRDFDrawing.h"
#include "vtkBRDFErrorMap.h"
#include "vtkBRDFErrorMapText.h"
#include "vtkBRDFLobeScene.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkTable.h"

#include <brdf/base/Error.h>
#include <brdf/view/ErrorAxes.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace vtkBRDFDrawing;

vtkStandardNewMacro(vtkBRDFErrorMapView);
vtkBRDFErrorMapView::vtkBRDFErrorMapView() = default;
vtkBRDFErrorMapView::~vtkBRDFErrorMapView() = default;

struct vtkBRDFErrorMapView::Layout
{
  double Width, Height;
  int Text;                                     // pixels
  Point Low;                                    // of the map
  double Side;                                  // of the map, a square
  std::array<brdf::ErrorGrid::Range, 2> Ranges; // of the map's axes
  ColorScale Scale;
  bool Logarithmic = false;

  double X(double value) const
  {
    return this->Low[0] + (value - this->Ranges[0].low) / (this->Ranges[0].high - this->Ranges[0].low) * this->Side;
  }
  double Y(double value) const
  {
    return this->Low[1] + (value - this->Ranges[1].low) / (this->Ranges[1].high - this->Ranges[1].low) * this->Side;
  }
};

vtkBRDFErrorMap* vtkBRDFErrorMapView::GetErrorMap()
{
  return this->ErrorMap;
}

void vtkBRDFErrorMapView::SetInputConnection(int index, vtkAlgorithmOutput* brdf)
{
  this->ErrorMap->SetInputConnection(index, brdf);
}

void vtkBRDFErrorMapView::SetInputData(int index, vtkDataObject* brdf)
{
  this->ErrorMap->SetInputData(index, brdf);
}

bool vtkBRDFErrorMapView::IsDisk()
{
  return this->ErrorMap->GetAxes() == "hemisphere";
}

namespace
{
// Logarithmic where asked, or where the largest value is more than ten times the median.
ColorScale ChooseScale(vtkBRDFErrorMap* map, const std::string& wanted, bool& logarithmic)
{
  if (wanted != "auto" && wanted != "linear" && wanted != "log")
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "unknown scale", "error map", wanted, "auto, linear, log" });
  }
  const double high = map->GetLargest() > 0 ? map->GetLargest() : 1;
  if (map->IsSigned())
  {
    return SignedScale(high);
  }
  ColorScale scale;
  scale.High = high;
  vtkDataArray* errors = map->GetOutput()->GetPointData()->GetScalars();
  std::vector<double> positive;
  for (vtkIdType i = 0; i < errors->GetNumberOfTuples(); ++i)
  {
    if (errors->GetComponent(i, 0) > 0)
    {
      positive.push_back(errors->GetComponent(i, 0));
    }
  }
  if (wanted == "linear" || positive.empty())
  {
    return scale;
  }
  std::sort(positive.begin(), positive.end());
  if (wanted == "auto" && high <= 10 * positive[positive.size() / 2])
  {
    return scale;
  }
  logarithmic = true;
  const double low = std::max(positive.front(), 1e-4 * high);
  return LogarithmicScale(low < high ? low : high / 10, high);
}
}

void vtkBRDFErrorMapView::AddMap(const Layout& layout)
{
  vtkImageData* image = this->ErrorMap->GetOutput();
  vtkDataArray* error = image->GetPointData()->GetArray("error");
  vtkDataArray* count = image->GetPointData()->GetArray("count");
  const int nodes = image->GetDimensions()[0];
  const double cell = layout.Side / (nodes - 1);
  std::vector<Rectangle> squares;
  squares.reserve(static_cast<std::size_t>(nodes) * nodes);
  const double overlap = 0.4; // under the next ones: viewers of vectors show a gap between areas that only touch
  const auto clipped = [&](double pixels) { return std::clamp(pixels, 0.0, layout.Side); };
  for (int y = 0; y < nodes; ++y)
  {
    for (int x = 0; x < nodes; ++x)
    {
      const vtkIdType i = static_cast<vtkIdType>(y) * nodes + x;
      if (count->GetComponent(i, 0) > 0)
      {
        squares.push_back({ { layout.Low[0] + clipped((x - 0.5) * cell), layout.Low[1] + clipped((y - 0.5) * cell) },
                            { layout.Low[0] + clipped((x + 0.5) * cell + overlap),
                              layout.Low[1] + clipped((y + 0.5) * cell + overlap) },
                            layout.Scale.Of(error->GetComponent(i, 0)) });
      }
    }
  }
  AddRectangles(this->GetRenderer(), squares);
}

// Diagonals where a point has no value.
void vtkBRDFErrorMapView::AddHatch(const Layout& layout)
{
  vtkImageData* image = this->ErrorMap->GetOutput();
  vtkDataArray* count = image->GetPointData()->GetArray("count");
  const int nodes = image->GetDimensions()[0];
  const bool disk = this->IsDisk();
  const auto empty = [&](double x, double y) // shares of the side
  {
    if (disk && std::hypot(2 * x - 1, 2 * y - 1) > 1 - 1.5 / nodes)
    {
      return false;
    }
    const auto node = [&](double t) { return std::clamp(static_cast<int>(t * (nodes - 1) + 0.5), 0, nodes - 1); };
    return count->GetComponent(static_cast<vtkIdType>(node(y)) * nodes + node(x), 0) == 0;
  };
  const int lines = 30, steps = 360;
  std::vector<Line> hatch;
  for (int line = 1 - lines; line < lines; ++line)
  {
    const double offset = static_cast<double>(line) / lines;
    for (int k = 0; k < steps; ++k)
    {
      const double x = static_cast<double>(k) / steps, y = x - offset, step = 1.0 / steps;
      if (y >= 0 && y + step <= 1 && empty(x + step / 2, y + step / 2))
      {
        hatch.push_back({ { layout.Low[0] + x * layout.Side, layout.Low[1] + y * layout.Side },
                          { layout.Low[0] + (x + step) * layout.Side, layout.Low[1] + (y + step) * layout.Side } });
      }
    }
  }
  AddLines(this->GetRenderer(), hatch, Hatch, LineWidth(layout.Text));
}

void vtkBRDFErrorMapView::AddAxes(const Layout& layout)
{
  const std::string axes = this->ErrorMap->GetAxes();
  const char* names[2] = { "incident angle theta_i (degrees)", "outgoing angle theta_o (degrees)" };
  if (axes == "theta_h,theta_d")
  {
    names[0] = "half angle theta_h (degrees)";
    names[1] = "difference angle theta_d (degrees)";
  }
  else if (axes == "theta_d,phi_d")
  {
    names[0] = "difference angle theta_d (degrees)";
    names[1] = "difference azimuth phi_d, or phi_d + 180 (degrees)";
  }
  const double tick = layout.Text / 3.0;
  const Point low = layout.Low, high = { low[0] + layout.Side, low[1] + layout.Side };
  std::vector<Line> lines = { { low, { high[0], low[1] } },
                              { { low[0], high[1] }, high },
                              { low, { low[0], high[1] } },
                              { { high[0], low[1] }, high } };
  for (int axis = 0; axis < 2; ++axis)
  {
    const int last = static_cast<int>(layout.Ranges[axis].high);
    for (int degrees = 0; degrees <= last; degrees += last > 90 ? 30 : 15)
    {
      const std::string label = std::to_string(degrees) + "\u00b0";
      const double x = axis == 0 ? layout.X(degrees) : low[0], y = axis == 0 ? low[1] : layout.Y(degrees);
      lines.push_back({ { x - (axis == 0 ? 0 : tick), y - (axis == 0 ? tick : 0) }, { x, y } });
      AddText(this->GetRenderer(),
              label,
              { x - (axis == 0 ? 0 : 1.6 * tick), y - (axis == 0 ? 1.6 * tick : 0) },
              { .Size = layout.Text,
                .Horizontal = axis == 0 ? Align::Center : Align::High,
                .Vertical = axis == 0 ? Align::High : Align::Center });
    }
  }
  AddLines(this->GetRenderer(), lines, Ink, LineWidth(layout.Text));
  AddText(this->GetRenderer(),
          names[0],
          { (low[0] + high[0]) / 2, low[1] - 2.2 * layout.Text },
          { .Size = layout.Text, .Horizontal = Align::Center, .Vertical = Align::High });
  AddText(this->GetRenderer(),
          names[1],
          { low[0] - 3.2 * layout.Text, (low[1] + high[1]) / 2 },
          { .Size = layout.Text, .Horizontal = Align::Center, .Vertical = Align::Low, .Angle = 90 });
}

// Rings of polar angle, spokes of azimuth, the light and the mirror direction.
void vtkBRDFErrorMapView::AddDiskGrid(const Layout& layout)
{
  vtkRenderer* renderer = this->GetRenderer();
  const brdf::DiskProjection projection = brdf::parseDiskProjection(this->ErrorMap->GetProjection());
  const auto at = [&](double theta, double phi)
  {
    const double r = brdf::diskRadius(projection, brdf::radians(theta));
    return Point{ layout.X(r * std::cos(brdf::radians(phi))), layout.Y(r * std::sin(brdf::radians(phi))) };
  };
  std::vector<Line> weak, rim;
  for (int theta = 15; theta <= 90; theta += 15)
  {
    for (int phi = 0; phi < 360; phi += 3)
    {
      (theta == 90 ? rim : weak).push_back({ at(theta, phi), at(theta, phi + 3) });
    }
  }
  for (int phi = 0; phi < 360; phi += 30)
  {
    weak.push_back({ at(0, phi), at(90, phi) });
  }
  AddLines(renderer, weak, Hatch, 0.7 * LineWidth(layout.Text));
  AddLines(renderer, rim, Ink, 2 * LineWidth(layout.Text));
  for (int theta : { 30, 60 })
  {
    const Point label = at(theta, 105);
    AddRectangles(renderer,
                  { { { label[0] - 0.9 * layout.Text, label[1] - 0.55 * layout.Text },
                      { label[0] + 0.9 * layout.Text, label[1] + 0.55 * layout.Text },
                      { 1, 1, 1 } } });
    AddText(renderer,
            std::to_string(theta) + "\u00b0",
            label,
            { .Size = layout.Text * 9 / 10, .Horizontal = Align::Center, .Vertical = Align::Center });
  }
  for (int phi = 0; phi < 360; phi += 30)
  {
    const Point edge = at(90, phi), center = at(0, 0);
    const double away = 1 + 1.3 * layout.Text / (layout.Side / 2);
    AddText(renderer,
            (phi == 0 ? "phi = 0" : std::to_string(phi)) + "\u00b0",
            { center[0] + away * (edge[0] - center[0]), center[1] + away * (edge[1] - center[1]) },
            { .Size = layout.Text * 9 / 10,
              .Horizontal = phi == 0 ? Align::Low : Align::Center,
              .Vertical = Align::Center,
              .Foreground = Faint });
  }
}

// Rings around the light (yellow) and the mirror direction (white), which leave visible what is there.
void vtkBRDFErrorMapView::AddLight(const Layout& layout)
{
  const double theta = brdf::radians(this->ErrorMap->GetThetaI()), phi = brdf::radians(this->ErrorMap->GetPhiI());
  const double r = brdf::diskRadius(brdf::parseDiskProjection(this->ErrorMap->GetProjection()), theta);
  const auto addRing = [&](double sign, const Color& color)
  {
    const Point center = { layout.X(sign * r * std::cos(phi)), layout.Y(sign * r * std::sin(phi)) };
    std::vector<Line> ring;
    const auto at = [&](int k)
    {
      const double angle = brdf::radians(15 * k), size = 0.65 * layout.Text;
      return Point{ center[0] + size * std::cos(angle), center[1] + size * std::sin(angle) };
    };
    for (int k = 0; k < 24; ++k)
    {
      ring.push_back({ at(k), at(k + 1) });
    }
    AddLines(this->GetRenderer(), ring, Ink, 5 * LineWidth(layout.Text));
    AddLines(this->GetRenderer(), ring, color, 2.5 * LineWidth(layout.Text));
  };
  addRing(1, vtkBRDFLobeScene::LightColor);
  addRing(-1, { 1, 1, 1 });
}

void vtkBRDFErrorMapView::AddWorst(const Layout& layout)
{
  vtkTable* table = this->ErrorMap->GetWorst();
  const vtkIdType rows = this->ShowWorst ? table->GetNumberOfRows() : 0;
  std::vector<Point> marks, labels;
  for (vtkIdType row = 0; row < rows; ++row)
  {
    marks.push_back(
      { layout.X(table->GetValueByName(row, "x").ToDouble()), layout.Y(table->GetValueByName(row, "y").ToDouble()) });
  }
  AddDots(this->GetRenderer(), marks, 0.28 * layout.Text, Ink);
  AddDots(this->GetRenderer(), marks, 0.18 * layout.Text, { 1, 1, 1 });
  for (vtkIdType row = 0; row < rows; ++row)
  {
    // Towards the map's middle, where there is room, and not on another number.
    const Point mark = marks[row];
    const double side = mark[0] > layout.Low[0] + layout.Side / 2 ? -1 : 1;
    const Point at = { mark[0] + side * 0.8 * layout.Text, mark[1] };
    const auto close = [&](const Point& other)
    { return std::abs(other[0] - at[0]) < 1.3 * layout.Text && std::abs(other[1] - at[1]) < 0.95 * layout.Text; };
    if (std::any_of(labels.begin(), labels.end(), close))
    {
      continue;
    }
    labels.push_back(at);
    const double width = (row < 9 ? 0.65 : 1.25) * layout.Text;
    AddRectangles(this->GetRenderer(),
                  { { { at[0] - width / 2, at[1] - 0.5 * layout.Text },
                      { at[0] + width / 2, at[1] + 0.5 * layout.Text },
                      { 1, 1, 1 } } });
    AddText(this->GetRenderer(),
            std::to_string(row + 1),
            at,
            { .Size = layout.Text * 4 / 5, .Horizontal = Align::Center, .Vertical = Align::Center });
  }
}

double vtkBRDFErrorMapView::AddTitles(int width, int height)
{
  vtkBRDFErrorMap* map = this->ErrorMap;
  const int text = TextSize(width, height);
  const auto letters = static_cast<std::size_t>(1.85 * (width - 2 * text) / text);
  bool logarithmic = false;
  ChooseScale(map, this->Scale, logarithmic);
  std::string note = vtkBRDFErrorMapText::Note(map) + ", largest point " + NumberText(map->GetLargest()) +
                     "; hatched: nothing to compare";
  if (logarithmic)
  {
    note += "; logarithmic colours";
  }
  if (this->IsDisk())
  {
    note += "; light (yellow) at theta_i = " + NumberText(map->GetThetaI(), 4) +
            "\u00b0, phi_i = " + NumberText(map->GetPhiI(), 4) + "\u00b0; mirror direction white; " +
            map->GetProjection() + " disk";
  }
  if (this->ShowWorst && map->GetWorst()->GetNumberOfRows() > 0)
  {
    note += "; 1, 2...: the worst directions";
  }
  vtkBRDFErrorMapText::AddNames(this->GetRenderer(), map, this->NameA, this->NameB, text, letters);
  return AddHeading(
    this->GetRenderer(),
    Shortened(this->GetTitle().empty() ? "A against B: " + map->GetQuantity() : this->GetTitle(), letters * 3 / 4),
    note,
    height - text,
    text);
}

vtkBRDFErrorMapView::Layout vtkBRDFErrorMapView::MakeLayout(int width, int height, double top)
{
  Layout layout{};
  layout.Width = width;
  layout.Height = height;
  layout.Text = TextSize(width, height);
  const double below = (this->IsDisk() ? 6 : 8) * layout.Text,
               above = height - top + (this->IsDisk() ? 2.2 : 1) * layout.Text, left = 6 * layout.Text,
               right = (this->IsDisk() ? 12 : 9) * layout.Text;
  layout.Side = std::max(10.0, std::min(width - left - right, height - below - above));
  layout.Low = { left + std::max(0.0, (width - left - right - layout.Side) / 2), below };
  layout.Ranges = brdf::ErrorGrid{ .axes = brdf::parseErrorAxes(this->ErrorMap->GetAxes()) }.ranges();
  layout.Scale = ChooseScale(this->ErrorMap, this->Scale, layout.Logarithmic);
  return layout;
}

void vtkBRDFErrorMapView::Build(int width, int height)
{
  this->ErrorMap->SetIntervals(this->Intervals > 0 ? this->Intervals : this->ErrorMap->SuggestIntervals());
  UpdateOrThrow(this->ErrorMap);
  const Layout layout = this->MakeLayout(width, height, this->AddTitles(width, height));
  this->AddMap(layout);
  this->AddHatch(layout);
  if (this->IsDisk())
  {
    this->AddDiskGrid(layout);
  }
  else
  {
    this->AddAxes(layout);
  }
  this->AddWorst(layout);
  if (this->IsDisk())
  {
    this->AddLight(layout);
  }
  const double bar = layout.Low[0] + layout.Side + (this->IsDisk() ? 5 : 2) * layout.Text;
  AddColorBar(this->GetRenderer(),
              layout.Scale,
              { bar, layout.Low[1] },
              { bar + 1.5 * layout.Text, layout.Low[1] + layout.Side },
              layout.Text);
}

void vtkBRDFErrorMapView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NameA: " << this->NameA << "\n"
     << indent << "NameB: " << this->NameB << "\n"
     << indent << "Intervals: " << this->Intervals << "\n"
     << indent << "Scale: " << this->Scale << "\n"
     << indent << "ShowWorst: " << this->ShowWorst << "\n";
}
