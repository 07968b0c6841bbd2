#include "vtkBRDFMicrosurfaceView.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkBRDFColorScale.h"
#include "vtkBRDFMicrosurface.h"
#include "vtkBRDFMicrosurfaceGeometry.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <brdf/base/Error.h>
#include <brdf/geometry/Directions.h>
#include <brdf/simulate/SurfaceKinds.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace vtkBRDFDrawing;

vtkStandardNewMacro(vtkBRDFMicrosurfaceView);
vtkBRDFMicrosurfaceView::vtkBRDFMicrosurfaceView() = default;
vtkBRDFMicrosurfaceView::~vtkBRDFMicrosurfaceView() = default;

namespace
{
using brdf::Direction;

/** A parallel projection: where places of the scene are on the picture, before anything is drawn. */
struct Projection
{
  Direction Right{}, Up{}, Towards{}; ///< of the picture in the scene, unit
  Direction Focus{};
  double PixelsPerUnit = 1;
  Point Center{}; ///< of the picture that shows Focus, pixels

  Point operator()(const Direction& place) const
  {
    const Direction d = { place[0] - Focus[0], place[1] - Focus[1], place[2] - Focus[2] };
    return { Center[0] + PixelsPerUnit * brdf::dot(d, Right), Center[1] + PixelsPerUnit * brdf::dot(d, Up) };
  }
};

/** Nodes left out so that at most about a million are drawn. */
int StrideOf(const brdf::SurfaceShape& shape, int copies)
{
  const auto* field = std::get_if<brdf::HeightField>(&shape);
  const double nodes = field ? static_cast<double>(field->columns) * static_cast<double>(field->rows) * copies : 0;
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(nodes / 0x1p20))));
}

double AutomaticExaggeration(double relief, double width)
{
  return relief <= 0 || relief >= 0.01 * width ? 1 : std::pow(10, std::ceil(std::log10(0.01 * width / relief)));
}

/** The facts that say most, in one line. */
std::string NoteOf(vtkBRDFMicrosurface* surface)
{
  std::string note;
  const auto add = [&](const char* fact, const char* text, const char* unit)
  {
    const double value = surface->GetFact(fact);
    if (std::isfinite(value))
    {
      note += (note.empty() ? "" : "; ") + std::string(text) + " " + NumberText(value, 4) + unit;
    }
  };
  add("rms height", "rms height", " \u00b5m");
  add("rms slope along x", "rms slope along x", "");
  add("rms slope along y", "along y", "");
  add("spheres placed", "spheres", "");
  add("triangles", "triangles", "");
  return note;
}

void SetHillLight(vtkRenderer* renderer)
{
  // From the upper left, as on maps, and some from the eye.
  renderer->RemoveAllLights();
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToCameraLight();
  lamp->SetPosition(-1, 0.8, 1.1);
  lamp->SetFocalPoint(0, 0, 0);
  lamp->SetIntensity(0.85);
  renderer->AddLight(lamp);
  vtkNew<vtkLight> fill;
  fill->SetLightTypeToHeadlight();
  fill->SetIntensity(0.25);
  renderer->AddLight(fill);
}
}

void vtkBRDFMicrosurfaceView::SetInputConnection(vtkAlgorithmOutput* surface)
{
  this->Geometry->SetInputConnection(surface);
}

void vtkBRDFMicrosurfaceView::SetInputData(vtkDataObject* surface)
{
  this->Geometry->SetInputData(surface);
}

void vtkBRDFMicrosurfaceView::Build(int width, int height)
{
  if (this->Geometry->GetNumberOfInputConnections(0) == 0)
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "no surface", "view", "nothing", "a vtkBRDFMicrosurface" });
  }
  vtkAlgorithm* source = this->Geometry->GetInputAlgorithm(0, 0);
  if (auto* ours = vtkBRDFAlgorithm::SafeDownCast(source))
  {
    UpdateOrThrow(ours);
  }
  auto* input = vtkBRDFMicrosurface::SafeDownCast(this->Geometry->GetInputDataObject(0, 0));
  if (!input || !input->GetSurface())
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "no surface", "view", "an empty input", "a vtkBRDFMicrosurface" });
  }
  const int stride = StrideOf(input->GetSurface()->surface.shape, this->Tiles[0] * this->Tiles[1]);
  this->Geometry->SetTiles(this->Tiles);
  this->Geometry->SetStride(stride);
  UpdateOrThrow(this->Geometry);
  vtkPolyData* surface = this->Geometry->GetOutput();
  if (surface->GetNumberOfPolys() == 0)
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "nothing to draw", "view of a microsurface", "no polygons", "" });
  }
  double bounds[6];
  surface->GetBounds(bounds);
  const double low = bounds[4], high = bounds[5];
  const double sizeX = this->Tiles[0] * input->GetFact("period along x");
  const double sizeY = this->Tiles[1] * input->GetFact("period along y");
  const double stretch =
    this->Exaggeration > 0 ? this->Exaggeration : AutomaticExaggeration(high - low, std::max(sizeX, sizeY));

  const int text = TextSize(width, height);
  vtkRenderer* renderer = this->GetRenderer();
  const auto letters = static_cast<std::size_t>(1.7 * (width - 2 * text) / text);
  std::string note = NoteOf(input);
  note += (note.empty() ? "" : "; ") +
          std::string(stretch == 1 ? "heights to scale" : "heights drawn " + NumberText(stretch) + " times");
  if (stride > 1)
  {
    note += "; one node in " + std::to_string(stride) + " drawn along each axis";
  }
  const double top =
    AddHeading(renderer,
               this->GetTitle().empty() ? Shortened(Rounded(input->GetDescription()), letters) : this->GetTitle(),
               note,
               height - 0.7 * text,
               text);

  // The surface's own units are huge or tiny: drawn scaled to a width of 1.
  const double unit = 1 / std::max(sizeX, sizeY);
  const double azimuth = brdf::radians(this->Azimuth), elevation = brdf::radians(this->Elevation);
  Projection project;
  project.Towards = { -std::cos(elevation) * std::sin(azimuth),
                      -std::cos(elevation) * std::cos(azimuth),
                      std::sin(elevation) };
  project.Right = { std::cos(azimuth), -std::sin(azimuth), 0 };
  project.Up = { std::sin(elevation) * std::sin(azimuth),
                 std::sin(elevation) * std::cos(azimuth),
                 std::cos(elevation) };
  const double z = unit * stretch;
  project.Focus = { unit * (bounds[0] + bounds[1]) / 2, unit * (bounds[2] + bounds[3]) / 2, z * (low + high) / 2 };

  // As large as fits between the heading, the bar at the right and the ticks below and at the left.
  const Point from = { 5.5 * text, 4.5 * text }, to = { width - 9.0 * text, top - 1.0 * text };
  double reach[4] = { INFINITY, -INFINITY, INFINITY, -INFINITY };
  for (int corner = 0; corner < 8; ++corner)
  {
    const Point at = project(
      { unit * bounds[corner & 1], unit * bounds[2 + ((corner >> 1) & 1)], z * bounds[4 + ((corner >> 2) & 1)] });
    reach[0] = std::min(reach[0], at[0]);
    reach[1] = std::max(reach[1], at[0]);
    reach[2] = std::min(reach[2], at[1]);
    reach[3] = std::max(reach[3], at[1]);
  }
  project.PixelsPerUnit =
    std::min((to[0] - from[0]) / (reach[1] - reach[0]), (to[1] - from[1]) / (reach[3] - reach[2]));
  project.Center = { (from[0] + to[0]) / 2 - project.PixelsPerUnit * (reach[0] + reach[1]) / 2,
                     (from[1] + to[1]) / 2 - project.PixelsPerUnit * (reach[2] + reach[3]) / 2 };

  // Ticks along the two edges of the tile nearest to the eye, at the lowest height.
  const double edgeX = project.Towards[0] >= 0 ? bounds[1] : bounds[0];
  const double edgeY = project.Towards[1] > 0 ? bounds[3] : bounds[2];
  const auto axis = [&](const std::string& name, double first, double last, bool alongX)
  {
    const auto place = [&](double value, double out) -> Direction
    {
      return alongX ? Direction{ unit * value, unit * edgeY + (edgeY == bounds[2] ? -out : out), z * low }
                    : Direction{ unit * edgeX + (edgeX == bounds[0] ? -out : out), unit * value, z * low };
    };
    // Outwards on the picture, not on the ground, which may be seen at a grazing angle.
    const Point edge = project(place(first, 0)), beside = project(place(first, 1));
    const double length = std::hypot(beside[0] - edge[0], beside[1] - edge[1]);
    const Point out = { (beside[0] - edge[0]) / length, (beside[1] - edge[1]) / length };
    const auto at = [&](double value, double pixels) -> Point
    {
      const Point on = project(place(value, 0));
      return { on[0] + pixels * out[0], on[1] + pixels * out[1] };
    };
    std::vector<Line> lines{ { at(first, 0), at(last, 0) } };
    for (const double tick : LinearTicks(first, last, 6))
    {
      lines.push_back({ at(tick, 0), at(tick, 0.5 * text) });
      AddText(renderer,
              NumberText(tick, 4),
              at(tick, 1.3 * text),
              { .Size = text * 9 / 10, .Horizontal = Align::Center, .Vertical = Align::Center });
    }
    AddText(renderer,
            name,
            at((first + last) / 2, alongX ? 2.9 * text : 4.3 * text),
            { .Size = text, .Horizontal = Align::Center, .Vertical = Align::Center });
    AddLines(renderer, lines, Ink, LineWidth(text));
  };
  axis("x (\u00b5m)", bounds[0], bounds[1], true);
  axis("y (\u00b5m)", bounds[2], bounds[3], false);

  const double margin = std::max(high - low, 1e-9 * std::max({ std::abs(low), std::abs(high), sizeX })) / 2;
  ColorScale scale;
  scale.Low = high > low ? low : low - margin;
  scale.High = high > low ? high : high + margin;
  vtkNew<vtkColorTransferFunction> colors;
  for (int k = 0; k <= 64; ++k)
  {
    const Color shade = Sequential(k / 64.0);
    colors->AddRGBPoint(scale.Low + (scale.High - scale.Low) * k / 64.0, shade[0], shade[1], shade[2]);
  }
  AddColorBar(renderer,
              scale,
              { width - 7.0 * text, 4.5 * text },
              { width - 5.6 * text, top - 3.0 * text },
              text,
              "height (\u00b5m)");

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetScale(unit, unit, z);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.3);
  actor->GetProperty()->SetDiffuse(0.8);
  renderer->AddActor(actor);
  SetHillLight(renderer);

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(height / (2 * project.PixelsPerUnit));
  // Focus is shown at Center.
  camera->SetWindowCenter(1 - 2 * project.Center[0] / width, 1 - 2 * project.Center[1] / height);
  camera->SetFocalPoint(project.Focus.data());
  const double distance = 10 + z * (high - low);
  camera->SetPosition(project.Focus[0] + distance * project.Towards[0],
                      project.Focus[1] + distance * project.Towards[1],
                      project.Focus[2] + distance * project.Towards[2]);
  camera->SetViewUp(project.Up.data());
  renderer->ResetCameraClippingRange();
}

void vtkBRDFMicrosurfaceView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tiles: " << this->Tiles[0] << " " << this->Tiles[1] << "\n"
     << indent << "Azimuth: " << this->Azimuth << "\n"
     << indent << "Elevation: " << this->Elevation << "\n"
     << indent << "Exaggeration: " << this->Exaggeration << "\n";
}
