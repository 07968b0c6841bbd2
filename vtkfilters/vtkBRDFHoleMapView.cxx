#include "vtkBRDFHoleMapView.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBRDF.h"
#include "vtkBRDFAngleAxes.h"
#include "vtkBRDFArrays.h"
#include "vtkBRDFHoleMap.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"

#include <brdf/view/HoleMap.h>

#include <algorithm>
#include <cmath>

using namespace vtkBRDFDrawing;

vtkStandardNewMacro(vtkBRDFHoleMapView);
vtkBRDFHoleMapView::vtkBRDFHoleMapView() = default;
vtkBRDFHoleMapView::~vtkBRDFHoleMapView() = default;

namespace
{
// Measured, filled, invalid, below the horizon: apart in lightness, too (Okabe and Ito 2008).
const std::array<Color, 4> ClassColors = {
  { { 0.00, 0.45, 0.70 }, { 0.95, 0.90, 0.25 }, { 0.84, 0.37, 0.00 }, { 0.86, 0.86, 0.88 } }
};

AngleAxis AxisOf(const std::string& name, const std::vector<double>& edges, double warp)
{
  const double low = edges.front(), high = edges.back();
  AngleAxis axis = AngleAxis::OfSlice(name, 1);
  if (name == "phi_difference")
  {
    axis.Title = "azimuth phi_o - phi_i (degrees)";
  }
  const double exponent = name.rfind("phi", 0) == 0 || low < 0 ? 1 : 1 / warp;
  const auto power = [exponent](double value) { return std::pow(value, exponent); };
  axis.Position = [=](double value)
  { return exponent == 1 ? (value - low) / (high - low) : (power(value) - power(low)) / (power(high) - power(low)); };
  axis.Ticks.clear();
  const double span = high - low, step = span > 270 ? 60 : span > 135 ? 30 : span > 60 ? 15 : span > 30 ? 10 : 0;
  if (step == 0)
  {
    axis.Ticks = LinearTicks(low, high, 7);
    return axis;
  }
  for (double tick = std::ceil(low / step - 1e-9) * step; tick <= high + 1e-9; tick += step)
  {
    axis.Ticks.push_back(tick == 0 ? 0 : tick);
  }
  return axis;
}
}

vtkBRDFHoleMap* vtkBRDFHoleMapView::GetHoleMap()
{
  return this->HoleMap;
}

void vtkBRDFHoleMapView::SetInputConnection(vtkAlgorithmOutput* brdf)
{
  this->HoleMap->SetInputConnection(brdf);
}

void vtkBRDFHoleMapView::SetInputData(vtkDataObject* brdf)
{
  this->HoleMap->SetInputData(brdf);
}

void vtkBRDFHoleMapView::Build(int width, int height)
{
  UpdateOrThrow(this->HoleMap);
  vtkImageData* map = this->HoleMap->GetOutput();
  vtkFieldData* fields = map->GetFieldData();
  const std::vector<double> xEdges = vtkBRDFArrays::FieldNumbers(fields, "x edges"),
                            yEdges = vtkBRDFArrays::FieldNumbers(fields, "y edges");
  auto* names = vtkStringArray::SafeDownCast(fields->GetAbstractArray("axes"));
  const AngleAxis x = AxisOf(names->GetValue(0), xEdges, this->Warp), y = AxisOf(names->GetValue(1), yEdges, 1);
  const int text = TextSize(width, height);
  vtkRenderer* renderer = this->GetRenderer();

  vtkIdType total = 0;
  for (int kind = 0; kind < 4; ++kind)
  {
    total += this->HoleMap->GetNumberOfCells(kind);
  }
  auto* layout = vtkStringArray::SafeDownCast(fields->GetAbstractArray("layout"));
  const std::string name =
    this->Name.empty() ? vtkBRDF::SafeDownCast(this->HoleMap->GetInputDataObject(0, 0))->GetDescription() : this->Name;
  const double top =
    AddHeading(renderer,
               this->GetTitle().empty() ? "What the cells hold: " + name : this->GetTitle(),
               std::to_string(total) + " cells, " + layout->GetValue(0) + "; colours mix over all other axes",
               height - 0.7 * text,
               text);

  const double low = 1.0 * text, legend = 15.0 * text;
  const PanelGrid grid(1, width - legend - text, top - low, text);
  const PanelPlace place = grid.Place(0, 0.5 * text, low);
  vtkDataArray* counts[4];
  for (std::size_t kind = 0; kind < 4; ++kind)
  {
    counts[kind] = map->GetPointData()->GetArray(std::string(brdf::HoleMap::kNames[kind]).c_str());
  }
  std::vector<Rectangle> rectangles;
  const auto at = [&](const AngleAxis& axis, double value, int side)
  { return place.Low[side] + std::clamp(axis.Position(value), 0.0, 1.0) * place.Side; };
  for (std::size_t j = 0; j + 1 < yEdges.size(); ++j)
  {
    for (std::size_t i = 0; i + 1 < xEdges.size(); ++i)
    {
      const auto point = static_cast<vtkIdType>(j * (xEdges.size() - 1) + i);
      Color color{};
      double all = 0;
      for (std::size_t kind = 0; kind < 4; ++kind)
      {
        const double count = counts[kind]->GetTuple1(point);
        all += count;
        for (int c = 0; c < 3; ++c)
        {
          color[c] += count * ClassColors[kind][c];
        }
      }
      for (double& component : color)
      {
        component /= std::max(all, 1.0);
      }
      rectangles.push_back(
        { { at(x, xEdges[i], 0), at(y, yEdges[j], 1) }, { at(x, xEdges[i + 1], 0), at(y, yEdges[j + 1], 1) }, color });
    }
  }
  AddRectangles(renderer, rectangles);
  AddAngleAxes(renderer, x, y, place, text);

  double line = place.Low[1] + place.Side - text;
  const double left = place.Low[0] + place.Side + 1.5 * text;
  for (int kind = 0; kind < 4; ++kind)
  {
    const vtkIdType count = this->HoleMap->GetNumberOfCells(kind);
    AddRectangles(renderer, { { { left, line }, { left + text, line + text }, ClassColors[kind] } });
    AddText(renderer, std::string(brdf::HoleMap::kNames[kind]), { left + 1.5 * text, line }, { .Size = text });
    AddText(renderer,
            std::to_string(count) + " (" +
              NumberText(100.0 * static_cast<double>(count) / std::max<double>(total, 1), 3) + " %)",
            { left + 1.5 * text, line - 1.3 * text },
            { .Size = text, .Foreground = Faint });
    line -= 3.4 * text;
  }
}

void vtkBRDFHoleMapView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->Name << "\n" << indent << "Warp: " << this->Warp << "\n";
}
