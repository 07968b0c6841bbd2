#include "vtkBRDFLobeView.h"

#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkBRDF.h"
#include "vtkBRDFDrawing.h"
#include "vtkBRDFLobe.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkConeSource.h"
#include "vtkDataArray.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegularPolygonSource.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <brdf/base/Error.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>
#include <brdf/view/ChannelChoice.h>
#include <brdf/view/LobeMesh.h>

#include <algorithm>
#include <cmath>

using namespace vtkBRDFDrawing;
using brdf::Direction;
using brdf::fromSpherical;
using brdf::kPi;
using brdf::radians;

vtkStandardNewMacro(vtkBRDFLobeView);

struct vtkBRDFLobeView::Input
{
  std::string Name;
  vtkSmartPointer<vtkBRDFLobe> Lobe;
};

namespace
{
constexpr Color LightColor = { 0.93, 0.66, 0.0 };
constexpr double Lift = 0.004; // of lines above the disc

vtkProperty* AddLine(vtkRenderer* renderer, const std::vector<Direction>& points, const Color& color, double width)
{
  vtkNew<vtkPoints> all;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(points.size()));
  for (const Direction& point : points)
  {
    cells->InsertCellPoint(all->InsertNextPoint(point.data()));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(all);
  data->SetLines(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
  return actor->GetProperty();
}

void AddLabel(vtkRenderer* renderer, const std::string& text, const Direction& at, int size, const Color& color)
{
  vtkNew<vtkBillboardTextActor3D> actor;
  actor->SetInput(text.c_str());
  actor->SetPosition(at[0], at[1], at[2]);
  actor->GetTextProperty()->SetFontFamilyToArial();
  actor->GetTextProperty()->SetFontSize(size);
  actor->GetTextProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetTextProperty()->SetJustificationToCentered();
  actor->GetTextProperty()->SetVerticalJustificationToCentered();
  renderer->AddActor(actor);
}

Direction Scaled(const Direction& direction, double length)
{
  return { direction[0] * length, direction[1] * length, direction[2] * length };
}

void AddArrow(vtkRenderer* renderer, const Direction& from, const Direction& to, const Color& color, double width)
{
  const Direction along = brdf::normalized({ to[0] - from[0], to[1] - from[1], to[2] - from[2] });
  const double head = 0.07;
  AddLine(
    renderer, { from, { to[0] - head * along[0], to[1] - head * along[1], to[2] - head * along[2] } }, color, width);
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(24);
  cone->SetHeight(head);
  cone->SetRadius(head / 3.5);
  cone->SetDirection(along.data());
  cone->SetCenter(to[0] - head / 2 * along[0], to[1] - head / 2 * along[1], to[2] - head / 2 * along[2]);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetAmbient(0.4);
  renderer->AddActor(actor);
}

// The colour of each point's RGB value at full brightness.
void ColorByValue(vtkPolyData* lobe)
{
  vtkDataArray* value = lobe->GetPointData()->GetArray("value");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("color");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(value->GetNumberOfTuples());
  for (vtkIdType i = 0; i < value->GetNumberOfTuples(); ++i)
  {
    double rgb[3];
    value->GetTuple(i, rgb);
    const double largest = std::max({ rgb[0], rgb[1], rgb[2] });
    for (int c = 0; c < 3; ++c)
    {
      const double encoded = largest > 0 ? brdf::encodeSrgb(rgb[c] / largest) : 0.5;
      colors->SetValue(3 * i + c, static_cast<unsigned char>(std::lround(255 * encoded)));
    }
  }
  lobe->GetPointData()->SetScalars(colors);
}
}

vtkBRDFLobeView::vtkBRDFLobeView()
  : Inputs(std::make_unique<std::vector<Input>>())
{
}

vtkBRDFLobeView::~vtkBRDFLobeView() = default;

void vtkBRDFLobeView::AddInputConnection(vtkAlgorithmOutput* brdf, const std::string& name)
{
  this->Inputs->push_back({ name, vtkSmartPointer<vtkBRDFLobe>::New() });
  this->Inputs->back().Lobe->SetInputConnection(brdf);
  this->Modified();
}

void vtkBRDFLobeView::AddInputData(vtkDataObject* brdf, const std::string& name)
{
  this->Inputs->push_back({ name, vtkSmartPointer<vtkBRDFLobe>::New() });
  this->Inputs->back().Lobe->SetInputData(brdf);
  this->Modified();
}

void vtkBRDFLobeView::RemoveAllInputs()
{
  this->Inputs->clear();
  this->Modified();
}

int vtkBRDFLobeView::GetNumberOfInputs() const
{
  return static_cast<int>(this->Inputs->size());
}

double vtkBRDFLobeView::UpdateLobes()
{
  double length = 0;
  for (Input& input : *this->Inputs)
  {
    input.Lobe->SetThetaI(this->ThetaI);
    input.Lobe->SetPhiI(this->PhiI);
    input.Lobe->SetTransform(this->Transform);
    input.Lobe->SetChannel(this->Channel);
    input.Lobe->SetIlluminant(this->Illuminant);
    input.Lobe->SetObserver(this->Observer);
    input.Lobe->SetAdaptation(this->Adaptation);
    input.Lobe->SetResolution(this->Resolution);
    input.Lobe->SetTolerance(this->Tolerance);
    UpdateOrThrow(input.Lobe);
    length = std::max(length, input.Lobe->GetMaximumLength());
  }
  if (this->Length > 0)
  {
    return this->Length;
  }
  return length > 0 ? length : 1;
}

void vtkBRDFLobeView::AddLobes(double length)
{
  for (std::size_t i = 0; i < this->Inputs->size(); ++i)
  {
    vtkNew<vtkPolyData> surface;
    surface->ShallowCopy((*this->Inputs)[i].Lobe->GetOutput());
    const bool colored = i == 0 && this->Channel == "rgb";
    if (colored)
    {
      ColorByValue(surface);
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface);
    mapper->SetScalarVisibility(colored);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetScale(1 / length);
    const Color color = PaletteColor(i);
    vtkProperty* property = actor->GetProperty();
    property->SetColor(color[0], color[1], color[2]);
    property->SetInterpolationToPhong();
    property->SetAmbient(0.25);
    property->SetDiffuse(0.75);
    property->SetSpecular(0.15);
    property->SetSpecularPower(30);
    property->SetOpacity(i == 0 ? 1 : 0.45);
    this->GetRenderer()->AddActor(actor);
  }
}

void vtkBRDFLobeView::AddGround(int text)
{
  vtkRenderer* renderer = this->GetRenderer();
  vtkNew<vtkRegularPolygonSource> disc;
  disc->SetNumberOfSides(180);
  disc->SetRadius(1);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(disc->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.94, 0.94, 0.95);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);

  const double phiI = radians(this->PhiI);
  const double line = LineWidth(text);
  const auto circle = [](double radius, double height)
  {
    std::vector<Direction> points;
    for (int k = 0; k <= 180; ++k)
    {
      points.push_back({ radius * std::cos(k * kPi / 90), radius * std::sin(k * kPi / 90), height });
    }
    return points;
  };
  for (int theta = 15; theta <= 90; theta += 15)
  {
    const bool strong = theta % 30 == 0;
    AddLine(renderer,
            circle(std::sin(radians(theta)), Lift),
            strong ? Color{ 0.6, 0.6, 0.63 } : Color{ 0.8, 0.8, 0.82 },
            theta == 90 ? 1.5 * line : line);
  }
  for (int phi = 0; phi < 360; phi += 30)
  {
    const Direction rim = fromSpherical(kPi / 2, radians(phi));
    AddLine(renderer, { { 0, 0, Lift }, { rim[0], rim[1], Lift } }, { 0.8, 0.8, 0.82 }, line);
    AddLabel(renderer,
             (phi == 0 ? "phi = 0" : std::to_string(phi)) + "\u00b0",
             Scaled(rim, phi == 0 ? 1.14 : 1.08),
             text * 9 / 10,
             Faint);
  }
  // The half circle in the plane of incidence carries the polar angles.
  std::vector<Direction> arc;
  for (int k = -90; k <= 90; ++k)
  {
    arc.push_back(fromSpherical(radians(k), phiI));
  }
  AddLine(renderer, arc, { 0.6, 0.6, 0.63 }, line);
  for (int theta = -75; theta <= 75; theta += 15)
  {
    const Direction at = fromSpherical(radians(theta), phiI);
    AddLine(renderer, { Scaled(at, 0.985), Scaled(at, 1.015) }, { 0.6, 0.6, 0.63 }, line);
    if (theta % 30 == 0 && std::abs(std::abs(theta) - this->ThetaI) > 6) // else the arrow's label says it
    {
      AddLabel(renderer,
               (theta == 0 ? "theta = 0" : std::to_string(std::abs(theta))) + "\u00b0",
               Scaled(at, 1.07),
               text * 9 / 10,
               Faint);
    }
  }
}

void vtkBRDFLobeView::AddDirections(int text)
{
  vtkRenderer* renderer = this->GetRenderer();
  const Direction wi = fromSpherical(radians(this->ThetaI), radians(this->PhiI));
  const Direction mirror = { -wi[0], -wi[1], wi[2] };
  const std::string angle = NumberText(this->ThetaI, 6) + "\u00b0";
  AddLine(renderer, { Scaled(wi, 1.1), { 0, 0, 0 } }, LightColor, 1.5 * LineWidth(text));
  AddArrow(renderer, Scaled(wi, 1.32), Scaled(wi, 1.03), LightColor, 3 * LineWidth(text)); // its head outside the lobes
  AddLabel(renderer, "light " + angle, Scaled(wi, 1.38), text, LightColor);
  AddArrow(renderer, { 0, 0, 0 }, Scaled(mirror, 1.3), Faint, 1.5 * LineWidth(text));
  AddLabel(renderer, "mirror " + angle, Scaled(mirror, 1.38), text, Faint);
}

void vtkBRDFLobeView::AddCaptions(int width, int height, double length)
{
  vtkRenderer* renderer = this->GetRenderer();
  const int text = TextSize(width, height);
  const std::string quantity = brdf::lobeTransformLabel(brdf::parseLobeTransform(this->Transform));
  AddText(renderer,
          this->GetTitle().empty() ? "Lobe length: " + quantity : this->GetTitle(),
          { 1.0 * text, height - 1.0 * text },
          { .Size = text * 6 / 5, .Vertical = Align::High, .Bold = true });
  AddText(renderer,
          this->Channel + "; theta_i = " + NumberText(this->ThetaI, 6) +
            "\u00b0, phi_i = " + NumberText(this->PhiI, 6) + "\u00b0; rim and half circle: " + NumberText(length),
          { 1.0 * text, height - 2.8 * text },
          { .Size = text, .Vertical = Align::High, .Foreground = Faint });
  const auto letters = static_cast<std::size_t>(1.85 * (width - 4 * text) / text);
  double y = 0.8 * text + 1.5 * text * (static_cast<double>(this->Inputs->size()) - 1);
  std::vector<Rectangle> keys;
  for (std::size_t i = 0; i < this->Inputs->size(); ++i, y -= 1.5 * text)
  {
    const Input& input = (*this->Inputs)[i];
    const auto* brdf = vtkBRDF::SafeDownCast(input.Lobe->GetInputDataObject(0, 0));
    const std::string largest = "  (largest " + NumberText(input.Lobe->GetMaximumLength()) + ")";
    AddText(renderer,
            Shortened(input.Name.empty() ? Rounded(brdf->GetDescription()) : input.Name, letters - largest.size()) +
              largest,
            { 2.6 * text, y },
            { .Size = text });
    const Point low = { 1.0 * text, y - 0.05 * text };
    const Point high = { 2.0 * text, y + 0.85 * text };
    keys.push_back({ low, high, PaletteColor(i) });
    if (i == 0 && this->Channel == "rgb") // has its own colours
    {
      keys.back() = { low, { low[0] + text / 3.0, high[1] }, { 0.85, 0.2, 0.2 } };
      keys.push_back({ { low[0] + text / 3.0, low[1] }, { high[0] - text / 3.0, high[1] }, { 0.2, 0.65, 0.2 } });
      keys.push_back({ { high[0] - text / 3.0, low[1] }, high, { 0.2, 0.3, 0.85 } });
    }
  }
  AddRectangles(renderer, keys);
}

void vtkBRDFLobeView::PlaceCamera(int width, int height)
{
  const Direction from = fromSpherical(radians(90 - this->CameraElevation), radians(this->PhiI + this->CameraAzimuth));
  vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
  const Direction focus = { 0, 0, 0.42 };
  camera->SetFocalPoint(focus.data());
  const double distance = 6;
  camera->SetPosition(focus[0] + distance * from[0], focus[1] + distance * from[1], focus[2] + distance * from[2]);
  camera->SetViewUp(0, 0, 1);
  const double halfHeight = std::max(1.12, 1.5 * height / width); // the arrows' labels reach 1.5 from the centre
  camera->SetViewAngle(2 * brdf::degrees(std::atan(halfHeight / distance)));
  camera->SetClippingRange(1, 20);
}

void vtkBRDFLobeView::Build(int width, int height)
{
  if (this->Inputs->empty())
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "nothing to draw", "lobe view", "no BRDF", "one or more" });
  }
  const double length = this->UpdateLobes();
  const int text = TextSize(width, height);
  vtkRenderer* renderer = this->GetRenderer();
  renderer->SetUseDepthPeeling(true);
  renderer->SetMaximumNumberOfPeels(8);
  this->PlaceCamera(width, height);
  this->AddGround(text);
  this->AddLobes(length);
  this->AddDirections(text);
  this->AddCaptions(width, height, length);
}

void vtkBRDFLobeView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ThetaI: " << this->ThetaI << " degrees\n"
     << indent << "PhiI: " << this->PhiI << " degrees\n"
     << indent << "Transform: " << this->Transform << "\n"
     << indent << "Channel: " << this->Channel << "\n"
     << indent << "Illuminant: " << this->Illuminant << "\n"
     << indent << "Observer: " << this->Observer << "\n"
     << indent << "Adaptation: " << this->Adaptation << "\n"
     << indent << "Resolution: " << this->Resolution << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "Length: " << this->Length << "\n"
     << indent << "CameraAzimuth: " << this->CameraAzimuth << " degrees\n"
     << indent << "CameraElevation: " << this->CameraElevation << " degrees\n";
}
