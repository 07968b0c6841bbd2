#include "vtkBRDFLobeScene.h"

#include "vtkActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCellArray.h"
#include "vtkConeSource.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegularPolygonSource.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace vtkBRDFDrawing;
using brdf::Direction;
using brdf::fromSpherical;
using brdf::kPi;
using brdf::radians;

namespace vtkBRDFLobeScene
{
namespace
{
constexpr double Lift = 0.004; // of lines above the disc
constexpr Color StrongLine = { 0.6, 0.6, 0.63 };
constexpr Color WeakLine = { 0.8, 0.8, 0.82 };

void AddLine(const Stage& stage, const std::vector<Direction>& points, const Color& color, double width)
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
  actor->SetPosition(stage.Origin[0], stage.Origin[1], stage.Origin[2]);
  stage.Renderer->AddActor(actor);
}

void AddLabel(const Stage& stage, const std::string& text, const Direction& at, int size, const Color& color)
{
  vtkNew<vtkBillboardTextActor3D> actor;
  actor->SetInput(text.c_str());
  actor->SetPosition(stage.Origin[0] + at[0], stage.Origin[1] + at[1], stage.Origin[2] + at[2]);
  actor->GetTextProperty()->SetFontFamilyToArial();
  actor->GetTextProperty()->SetFontSize(size);
  actor->GetTextProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetTextProperty()->SetJustificationToCentered();
  actor->GetTextProperty()->SetVerticalJustificationToCentered();
  stage.Renderer->AddActor(actor);
}

Direction Scaled(const Direction& direction, double length)
{
  return { direction[0] * length, direction[1] * length, direction[2] * length };
}

void AddArrow(const Stage& stage, const Direction& from, const Direction& to, const Color& color, double width)
{
  const Direction along = brdf::normalized({ to[0] - from[0], to[1] - from[1], to[2] - from[2] });
  const double head = 0.07;
  AddLine(stage, { from, { to[0] - head * along[0], to[1] - head * along[1], to[2] - head * along[2] } }, color, width);
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
  actor->SetPosition(stage.Origin[0], stage.Origin[1], stage.Origin[2]);
  stage.Renderer->AddActor(actor);
}

std::vector<Direction> Circle(double radius, double height)
{
  std::vector<Direction> points;
  for (int k = 0; k <= 180; ++k)
  {
    points.push_back({ radius * std::cos(k * kPi / 90), radius * std::sin(k * kPi / 90), height });
  }
  return points;
}
}

void SetLights(vtkRenderer* renderer)
{
  renderer->RemoveAllLights();
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToCameraLight();
  lamp->SetPosition(-0.8, 1, 1.2);
  lamp->SetFocalPoint(0, 0, 0);
  lamp->SetIntensity(0.8);
  renderer->AddLight(lamp);
  vtkNew<vtkLight> fill;
  fill->SetLightTypeToHeadlight();
  fill->SetIntensity(0.3);
  renderer->AddLight(fill);
}

void AddGround(const Stage& stage, double thetaI, double phiI)
{
  const int text = stage.Text;
  vtkNew<vtkRegularPolygonSource> disc;
  disc->SetNumberOfSides(180);
  disc->SetRadius(1);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(disc->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.94, 0.94, 0.95);
  actor->GetProperty()->LightingOff();
  actor->SetPosition(stage.Origin[0], stage.Origin[1], stage.Origin[2]);
  stage.Renderer->AddActor(actor);

  const double line = LineWidth(text);
  for (int theta = 15; theta <= 90; theta += 15)
  {
    const bool strong = theta % 30 == 0;
    AddLine(
      stage, Circle(std::sin(radians(theta)), Lift), strong ? StrongLine : WeakLine, theta == 90 ? 1.5 * line : line);
  }
  for (int phi = 0; phi < 360; phi += 30)
  {
    const Direction rim = fromSpherical(kPi / 2, radians(phi));
    AddLine(stage, { { 0, 0, Lift }, { rim[0], rim[1], Lift } }, WeakLine, line);
    if (stage.HasRoomForAngles())
    {
      AddLabel(stage,
               (phi == 0 ? "phi = 0" : std::to_string(phi)) + "\u00b0",
               Scaled(rim, phi == 0 ? 1.14 : 1.08),
               text * 9 / 10,
               Faint);
    }
  }
  // The half circle in the plane of incidence carries the polar angles.
  std::vector<Direction> arc;
  for (int k = -90; k <= 90; ++k)
  {
    arc.push_back(fromSpherical(radians(k), radians(phiI)));
  }
  AddLine(stage, arc, StrongLine, line);
  for (int theta = -75; theta <= 75; theta += 15)
  {
    const Direction at = fromSpherical(radians(theta), radians(phiI));
    AddLine(stage, { Scaled(at, 0.985), Scaled(at, 1.015) }, StrongLine, line);
    if (theta % 30 == 0 && stage.HasRoomForAngles() && std::abs(std::abs(theta) - thetaI) > 6)
    {
      AddLabel(stage,
               (theta == 0 ? "theta = 0" : std::to_string(std::abs(theta))) + "\u00b0",
               Scaled(at, 1.07),
               text * 9 / 10,
               Faint);
    }
  }
}

void AddDirections(const Stage& stage, double thetaI, double phiI, bool light)
{
  const double line = LineWidth(stage.Text);
  const Direction wi = fromSpherical(radians(thetaI), radians(phiI));
  const Direction mirror = { -wi[0], -wi[1], wi[2] };
  const std::string angle = NumberText(thetaI, 4) + "\u00b0";
  const bool apart = thetaI > 8; // else the labels would overlap
  if (light)
  {
    AddLine(stage, { Scaled(wi, 1.1), { 0, 0, 0 } }, LightColor, 1.5 * line);
    AddArrow(stage, Scaled(wi, 1.32), Scaled(wi, 1.03), LightColor, 3 * line); // its head outside the lobes
  }
  AddArrow(stage, { 0, 0, 0 }, Scaled(mirror, apart ? 1.3 : 1.0), Faint, 1.5 * line);
  if (stage.HasRoomForNames())
  {
    AddLabel(stage, (apart ? "light " : "light and mirror ") + angle, Scaled(wi, 1.4), stage.Text, LightColor);
    if (apart)
    {
      AddLabel(stage, "mirror " + angle, Scaled(mirror, 1.4), stage.Text, Faint);
    }
  }
}

void AddHemisphere(const Stage& stage, double radius)
{
  for (int theta = 15; theta <= 90; theta += 15)
  {
    AddLine(stage,
            Circle(radius * std::sin(radians(theta)), std::max(radius * std::cos(radians(theta)), Lift)),
            StrongLine,
            LineWidth(stage.Text));
  }
  for (int phi = 0; phi < 180; phi += 30)
  {
    std::vector<Direction> arc;
    for (int k = -90; k <= 90; k += 3)
    {
      arc.push_back(Scaled(fromSpherical(radians(k), radians(phi)), radius));
    }
    AddLine(stage, arc, StrongLine, LineWidth(stage.Text));
  }
}

vtkProperty* AddSurface(const Stage& stage, vtkPolyData* surface, double scale, const Color& color, bool colored)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->SetScalarVisibility(colored);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetScale(scale);
  actor->SetPosition(stage.Origin[0], stage.Origin[1], stage.Origin[2]);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(color[0], color[1], color[2]);
  property->SetInterpolationToPhong();
  property->SetAmbient(0.25);
  property->SetDiffuse(0.75);
  property->SetSpecular(0.15);
  property->SetSpecularPower(30);
  stage.Renderer->AddActor(actor);
  return property;
}

void AddPoints(const Stage& stage, vtkPolyData* points, double scale, const Color& color, bool colored)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetScalarVisibility(colored);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-40);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetScale(scale);
  actor->SetPosition(stage.Origin[0], stage.Origin[1], stage.Origin[2]);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetPointSize(static_cast<float>(stage.Text / (colored ? 2.2 : 3.5)));
  actor->GetProperty()->SetRenderPointsAsSpheres(true);
  actor->GetProperty()->LightingOff();
  stage.Renderer->AddActor(actor);
}
}
