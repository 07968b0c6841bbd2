#include "vtkBRDFErrorMapView.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBRDF.h"
#include "vtkBRDFDrawing.h"
#include "vtkBRDFErrorMap.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"

#include <brdf/base/Error.h>

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
  int Text;      // pixels
  Point Low;     // of the map
  double Side;   // of the map, a square
  double BarLow; // x of the scale bar
  double BarWidth;

  double X(double degrees) const { return this->Low[0] + degrees / 90 * this->Side; }
  double Y(double degrees) const { return this->Low[1] + degrees / 90 * this->Side; }
};

struct vtkBRDFErrorMapView::ColorScale
{
  bool Signed = false;
  bool Logarithmic = false;
  double Low = 0;
  double High = 1;

  double Position(double value) const
  {
    const double t = this->Logarithmic
                       ? std::log(std::max(value, this->Low) / this->Low) / std::log(this->High / this->Low)
                       : (value - this->Low) / (this->High - this->Low);
    return std::clamp(t, 0.0, 1.0);
  }
  Color At(double t) const { return this->Signed ? Diverging(t) : Sequential(t); }
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

vtkBRDFErrorMapView::ColorScale vtkBRDFErrorMapView::ChooseScale()
{
  if (this->Scale != "auto" && this->Scale != "linear" && this->Scale != "log")
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "unknown scale", "error map", this->Scale, "auto, linear, log" });
  }
  ColorScale scale;
  scale.Signed = this->ErrorMap->GetMeasure() == "difference";
  scale.High = this->ErrorMap->GetLargest() > 0 ? this->ErrorMap->GetLargest() : 1;
  if (scale.Signed)
  {
    scale.Low = -scale.High;
    return scale;
  }
  vtkPointData* data = this->ErrorMap->GetOutput()->GetPointData();
  std::vector<double> positive;
  for (vtkIdType i = 0; i < data->GetScalars()->GetNumberOfTuples(); ++i)
  {
    if (data->GetScalars()->GetComponent(i, 0) > 0)
    {
      positive.push_back(data->GetScalars()->GetComponent(i, 0));
    }
  }
  if (this->Scale == "linear" || positive.empty())
  {
    return scale;
  }
  std::sort(positive.begin(), positive.end());
  if (this->Scale == "log" || scale.High > 10 * positive[positive.size() / 2])
  {
    scale.Logarithmic = true;
    scale.Low = std::max(positive.front(), 1e-4 * scale.High);
    if (!(scale.Low < scale.High))
    {
      scale.Low = scale.High / 10;
    }
  }
  return scale;
}

void vtkBRDFErrorMapView::AddMap(const Layout& layout, const ColorScale& scale)
{
  vtkImageData* image = this->ErrorMap->GetOutput();
  vtkDataArray* error = image->GetPointData()->GetArray("error");
  vtkDataArray* count = image->GetPointData()->GetArray("count");
  const int nodes = image->GetDimensions()[0];
  const double half = image->GetSpacing()[0] / 2;
  std::vector<Rectangle> squares;
  squares.reserve(static_cast<std::size_t>(nodes) * nodes);
  for (int y = 0; y < nodes; ++y)
  {
    for (int x = 0; x < nodes; ++x)
    {
      const vtkIdType i = static_cast<vtkIdType>(y) * nodes + x;
      const Point low = { layout.X(std::max((2 * x - 1) * half, 0.0)), layout.Y(std::max((2 * y - 1) * half, 0.0)) };
      const Point high = { layout.X(std::min((2 * x + 1) * half, 90.0)), layout.Y(std::min((2 * y + 1) * half, 90.0)) };
      if (count->GetComponent(i, 0) > 0)
      {
        squares.push_back({ low, high, scale.At(scale.Position(error->GetComponent(i, 0))) });
      }
    }
  }
  AddRectangles(this->GetRenderer(), squares);

  // Diagonals, in quarter degrees, where a point has no value.
  const auto empty = [&](double x, double y)
  {
    const auto node = [&](double degrees)
    { return std::min(static_cast<int>((degrees + half) / (2 * half)), nodes - 1); };
    return count->GetComponent(static_cast<vtkIdType>(node(y)) * nodes + node(x), 0) == 0;
  };
  const double step = 0.25;
  std::vector<Line> hatch;
  for (int offset = -87; offset < 90; offset += 3)
  {
    for (double x = std::max(offset, 0); x < std::min(offset + 90, 90); x += step)
    {
      const double y = x - offset;
      if (empty(x + step / 2, y + step / 2))
      {
        hatch.push_back({ { layout.X(x), layout.Y(y) }, { layout.X(x + step), layout.Y(y + step) } });
      }
    }
  }
  AddLines(this->GetRenderer(), hatch, Hatch, LineWidth(layout.Text));
}

void vtkBRDFErrorMapView::AddAxes(const Layout& layout)
{
  const bool half = this->ErrorMap->GetAxes() == "theta_h,theta_d";
  const double tick = layout.Text / 3.0;
  std::vector<Line> lines = { { { layout.X(0), layout.Y(0) }, { layout.X(90), layout.Y(0) } },
                              { { layout.X(0), layout.Y(90) }, { layout.X(90), layout.Y(90) } },
                              { { layout.X(0), layout.Y(0) }, { layout.X(0), layout.Y(90) } },
                              { { layout.X(90), layout.Y(0) }, { layout.X(90), layout.Y(90) } } };
  for (int degrees = 0; degrees <= 90; degrees += 15)
  {
    lines.push_back({ { layout.X(degrees), layout.Y(0) - tick }, { layout.X(degrees), layout.Y(0) } });
    lines.push_back({ { layout.X(0) - tick, layout.Y(degrees) }, { layout.X(0), layout.Y(degrees) } });
    const std::string label = std::to_string(degrees) + "\u00b0";
    AddText(this->GetRenderer(),
            label,
            { layout.X(degrees), layout.Y(0) - 1.6 * tick },
            { .Size = layout.Text, .Horizontal = Align::Center, .Vertical = Align::High });
    AddText(this->GetRenderer(),
            label,
            { layout.X(0) - 1.6 * tick, layout.Y(degrees) },
            { .Size = layout.Text, .Horizontal = Align::High, .Vertical = Align::Center });
  }
  AddLines(this->GetRenderer(), lines, Ink, LineWidth(layout.Text));
  AddText(this->GetRenderer(),
          half ? "half angle theta_h (degrees)" : "incident angle theta_i (degrees)",
          { layout.X(45), layout.Y(0) - 2.2 * layout.Text },
          { .Size = layout.Text, .Horizontal = Align::Center, .Vertical = Align::High });
  AddText(this->GetRenderer(),
          half ? "difference angle theta_d (degrees)" : "outgoing angle theta_o (degrees)",
          { layout.X(0) - 3.2 * layout.Text, layout.Y(45) },
          { .Size = layout.Text, .Horizontal = Align::Center, .Vertical = Align::Low, .Angle = 90 });
}

void vtkBRDFErrorMapView::AddScaleBar(const Layout& layout, const ColorScale& scale)
{
  const int steps = 256;
  std::vector<Rectangle> strips;
  for (int i = 0; i < steps; ++i)
  {
    strips.push_back({ { layout.BarLow, layout.Y(90.0 * i / steps) },
                       { layout.BarLow + layout.BarWidth, layout.Y(90.0 * (i + 1) / steps) },
                       scale.At((i + 0.5) / steps) });
  }
  AddRectangles(this->GetRenderer(), strips);
  const double right = layout.BarLow + layout.BarWidth;
  std::vector<Line> lines = { { { layout.BarLow, layout.Y(0) }, { right, layout.Y(0) } },
                              { { layout.BarLow, layout.Y(90) }, { right, layout.Y(90) } },
                              { { layout.BarLow, layout.Y(0) }, { layout.BarLow, layout.Y(90) } },
                              { { right, layout.Y(0) }, { right, layout.Y(90) } } };
  const std::vector<double> ticks =
    scale.Logarithmic ? LogarithmicTicks(scale.Low, scale.High) : LinearTicks(scale.Low, scale.High, 8);
  for (double value : ticks)
  {
    const double y = layout.Y(90 * scale.Position(value));
    lines.push_back({ { right, y }, { right + layout.Text / 3.0, y } });
    AddText(this->GetRenderer(),
            NumberText(value),
            { right + layout.Text / 2.0, y },
            { .Size = layout.Text, .Vertical = Align::Center });
  }
  AddLines(this->GetRenderer(), lines, Ink, LineWidth(layout.Text));
}

void vtkBRDFErrorMapView::AddTitles(const Layout& layout, const ColorScale& scale)
{
  vtkBRDFErrorMap* map = this->ErrorMap;
  vtkRenderer* renderer = this->GetRenderer();
  const double left = layout.Text;
  const auto described = [map](int port)
  { return Rounded(vtkBRDF::SafeDownCast(map->GetInputDataObject(port, 0))->GetDescription()); };
  AddText(renderer,
          this->GetTitle().empty() ? "Where A differs from B: " + map->GetQuantity() : this->GetTitle(),
          { left, layout.Height - layout.Text },
          { .Size = layout.Text * 6 / 5, .Vertical = Align::High, .Bold = true });
  AddText(renderer,
          map->GetChannel() + ", " + map->GetSampling() + "; overall mean " + NumberText(map->GetOverallMean()) +
            ", largest " + NumberText(map->GetLargest()) + (scale.Logarithmic ? "; logarithmic scale" : "") +
            "; hatched: nothing to compare",
          { left, layout.Height - 2.8 * layout.Text },
          { .Size = layout.Text, .Vertical = Align::High, .Foreground = Faint });
  const auto letters = static_cast<std::size_t>(1.85 * (layout.Width - 2 * left) / layout.Text);
  AddText(renderer,
          "A: " + Shortened(this->NameA.empty() ? described(0) : this->NameA, letters),
          { left, 2.2 * layout.Text },
          { .Size = layout.Text });
  AddText(renderer,
          "B: " + Shortened(this->NameB.empty() ? described(1) : this->NameB, letters),
          { left, 0.8 * layout.Text },
          { .Size = layout.Text });
}

void vtkBRDFErrorMapView::Build(int width, int height)
{
  this->ErrorMap->SetIntervals(this->Intervals > 0 ? this->Intervals : this->ErrorMap->SuggestIntervals());
  UpdateOrThrow(this->ErrorMap);
  Layout layout{};
  layout.Width = width;
  layout.Height = height;
  layout.Text = TextSize(width, height);
  const double below = 8 * layout.Text, above = 5.5 * layout.Text, left = 6 * layout.Text, right = 9 * layout.Text;
  layout.Side = std::max(10.0, std::min(width - left - right, height - below - above));
  layout.Low = { left + std::max(0.0, (width - left - right - layout.Side) / 2), below };
  layout.BarLow = layout.X(90) + 2 * layout.Text;
  layout.BarWidth = 1.5 * layout.Text;
  const ColorScale scale = this->ChooseScale();
  this->AddMap(layout, scale);
  this->AddAxes(layout);
  this->AddScaleBar(layout, scale);
  this->AddTitles(layout, scale);
}

void vtkBRDFErrorMapView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NameA: " << this->NameA << "\n"
     << indent << "NameB: " << this->NameB << "\n"
     << indent << "Intervals: " << this->Intervals << "\n"
     << indent << "Scale: " << this->Scale << "\n";
}
