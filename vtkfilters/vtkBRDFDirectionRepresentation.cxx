#include "vtkBRDFDirectionRepresentation.h"

#include "vtkActor.h"
#include "vtkBRDFLobeScene.h"
#include "vtkConeSource.h"
#include "vtkLineSource.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkWindow.h"

#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <array>
#include <cmath>

using brdf::Direction;

vtkStandardNewMacro(vtkBRDFDirectionRepresentation);

namespace
{
constexpr double Tip = 1.03; // distances from the origin
constexpr double End = 1.32;
constexpr double Middle = (Tip + End) / 2;
constexpr double HeadLength = 0.09;

Direction Scaled(const Direction& a, double s)
{
  return { s * a[0], s * a[1], s * a[2] };
}

std::array<double, 2> Displayed(vtkRenderer* renderer, const Direction& point)
{
  renderer->SetWorldPoint(point[0], point[1], point[2], 1);
  renderer->WorldToDisplay();
  return { renderer->GetDisplayPoint()[0], renderer->GetDisplayPoint()[1] };
}

Direction Undisplayed(vtkRenderer* renderer, double x, double y, double depth)
{
  renderer->SetDisplayPoint(x, y, depth);
  renderer->DisplayToWorld();
  const double* p = renderer->GetWorldPoint();
  return { p[0] / p[3], p[1] / p[3], p[2] / p[3] };
}

double DistanceToSegment(const std::array<double, 2>& p, const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  const double x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
  const double t = square > 0 ? std::clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / square, 0.0, 1.0) : 0.0;
  return std::hypot(a[0] + t * x - p[0], a[1] + t * y - p[1]);
}
}

vtkBRDFDirectionRepresentation::vtkBRDFDirectionRepresentation()
{
  this->InteractionState = Outside;
  this->Head->SetResolution(24);
  this->Head->SetHeight(HeadLength);
  this->Head->SetRadius(HeadLength / 3);
  vtkNew<vtkPolyDataMapper> shaft;
  shaft->SetInputConnection(this->Shaft->GetOutputPort());
  this->ShaftActor->SetMapper(shaft);
  vtkNew<vtkPolyDataMapper> head;
  head->SetInputConnection(this->Head->GetOutputPort());
  this->HeadActor->SetMapper(head);
  this->HeadActor->GetProperty()->SetAmbient(0.4);
  this->ShaftActor->GetProperty()->LightingOff();
  this->Highlight(0);
}

vtkBRDFDirectionRepresentation::~vtkBRDFDirectionRepresentation() = default;

void vtkBRDFDirectionRepresentation::Highlight(int on)
{
  const auto& color = vtkBRDFLobeScene::LightColor;
  const double gain = on ? 0.75 : 1;
  for (vtkActor* actor : { this->ShaftActor.Get(), this->HeadActor.Get() })
  {
    actor->GetProperty()->SetColor(gain * color[0], gain * color[1], gain * color[2]);
  }
  this->ShaftActor->GetProperty()->SetLineWidth(on ? 5 : 3);
}

int vtkBRDFDirectionRepresentation::ComputeInteractionState(int x, int y, int)
{
  this->InteractionState = Outside;
  if (this->Renderer)
  {
    const Direction w = brdf::fromSpherical(brdf::radians(this->Theta), brdf::radians(this->Phi));
    const double distance = DistanceToSegment({ static_cast<double>(x), static_cast<double>(y) },
                                              Displayed(this->Renderer, Scaled(w, Tip)),
                                              Displayed(this->Renderer, Scaled(w, End)));
    this->InteractionState = distance <= this->Tolerance ? OnArrow : Outside;
  }
  return this->InteractionState;
}

void vtkBRDFDirectionRepresentation::StartWidgetInteraction(double position[2])
{
  const Direction w = brdf::fromSpherical(brdf::radians(this->Theta), brdf::radians(this->Phi));
  const std::array<double, 2> middle = Displayed(this->Renderer, Scaled(w, Middle));
  this->Offset[0] = middle[0] - position[0];
  this->Offset[1] = middle[1] - position[1];
}

void vtkBRDFDirectionRepresentation::WidgetInteraction(double position[2])
{
  const double x = position[0] + this->Offset[0], y = position[1] + this->Offset[1];
  const Direction from = Undisplayed(this->Renderer, x, y, 0), to = Undisplayed(this->Renderer, x, y, 1);
  const Direction along = brdf::normalized({ to[0] - from[0], to[1] - from[1], to[2] - from[2] });
  const double nearest = -brdf::dot(from, along); // to the origin
  const auto at = [&](double t) {
    return Direction{ from[0] + t * along[0], from[1] + t * along[1], from[2] + t * along[2] };
  };
  const Direction closest = at(nearest);
  const double half = Middle * Middle - brdf::dot(closest, closest);
  // Where the line of sight meets the sphere, or else its outline beside it; of two places the one above the horizon,
  // or the nearer to the present direction.
  Direction chosen = closest;
  if (half > 0)
  {
    const Direction front = at(nearest - std::sqrt(half)), back = at(nearest + std::sqrt(half));
    const Direction present = brdf::fromSpherical(brdf::radians(this->Theta), brdf::radians(this->Phi));
    const bool both = front[2] > 0 && back[2] > 0;
    const bool frontNearer = brdf::dot(front, present) >= brdf::dot(back, present);
    chosen = (both ? frontNearer : front[2] > 0 || back[2] <= 0) ? front : back;
  }
  const brdf::Spherical angles =
    brdf::toSpherical(brdf::normalized({ chosen[0], chosen[1], std::max(chosen[2], 0.0) }));
  this->SetTheta(brdf::degrees(angles.theta));
  this->SetPhi(brdf::degrees(angles.phi));
  this->BuildRepresentation();
}

void vtkBRDFDirectionRepresentation::BuildRepresentation()
{
  const Direction w = brdf::fromSpherical(brdf::radians(this->Theta), brdf::radians(this->Phi));
  this->Shaft->SetPoint1(Scaled(w, End).data());
  this->Shaft->SetPoint2(Scaled(w, Tip + HeadLength).data());
  this->Head->SetDirection(Scaled(w, -1).data());
  this->Head->SetCenter(Scaled(w, Tip + HeadLength / 2).data());
}

double* vtkBRDFDirectionRepresentation::GetBounds()
{
  return this->BoundingBox;
}

void vtkBRDFDirectionRepresentation::GetActors(vtkPropCollection* actors)
{
  this->ShaftActor->GetActors(actors);
  this->HeadActor->GetActors(actors);
}

int vtkBRDFDirectionRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  this->BuildRepresentation();
  return this->ShaftActor->RenderOpaqueGeometry(viewport) + this->HeadActor->RenderOpaqueGeometry(viewport);
}

vtkTypeBool vtkBRDFDirectionRepresentation::HasTranslucentPolygonalGeometry()
{
  return 0;
}

void vtkBRDFDirectionRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ShaftActor->ReleaseGraphicsResources(window);
  this->HeadActor->ReleaseGraphicsResources(window);
}

void vtkBRDFDirectionRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Theta: " << this->Theta << " degrees\n"
     << indent << "Phi: " << this->Phi << " degrees\n"
     << indent << "Tolerance: " << this->Tolerance << " pixels\n";
}
