#include "vtkBRDFLobeView.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBRDF.h"
#include "vtkBRDFColourSettings.h"
#include "vtkBRDFDirectionRepresentation.h"
#include "vtkBRDFDirectionWidget.h"
#include "vtkBRDFDrawing.h"
#include "vtkBRDFLobePlan.h"
#include "vtkBRDFLobeScene.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <brdf/base/Error.h>
#include <brdf/material/Brdf.h>

#include <algorithm>
#include <cmath>

using namespace vtkBRDFDrawing;
using vtkBRDFLobeScene::Stage;

vtkStandardNewMacro(vtkBRDFLobeView);

namespace
{
void SetColors(vtkPolyData* surface, const char* array, const ColorScale& scale)
{
  vtkDataArray* values = surface->GetPointData()->GetArray(array);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("shown");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const Color color = scale.Of(values->GetComponent(i, 0));
    for (int c = 0; c < 3; ++c)
    {
      colors->SetTypedComponent(i, c, static_cast<unsigned char>(std::lround(255 * color[c])));
    }
  }
  surface->GetPointData()->SetScalars(colors);
}
}

vtkBRDFLobeView::vtkBRDFLobeView()
  : Inputs(std::make_unique<std::vector<Input>>())
{
}

vtkBRDFLobeView::~vtkBRDFLobeView()
{
  this->EnableInteraction(nullptr);
}

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

vtkBRDFDirectionWidget* vtkBRDFLobeView::GetDirectionWidget()
{
  return this->Widget;
}

void vtkBRDFLobeView::EnableInteraction(vtkRenderWindowInteractor* interactor)
{
  if (this->Widget)
  {
    this->Widget->RemoveAllObservers();
    this->Widget->SetEnabled(0);
    this->Widget->SetInteractor(nullptr);
    this->Widget = nullptr;
  }
  this->CameraPlaced = false;
  if (!interactor)
  {
    return;
  }
  this->SetRenderWindow(interactor->GetRenderWindow());
  this->Widget = vtkSmartPointer<vtkBRDFDirectionWidget>::New();
  this->Widget->SetInteractor(interactor);
  this->Widget->SetDefaultRenderer(this->GetRenderer());
  this->Widget->SetCurrentRenderer(this->GetRenderer());
  vtkNew<vtkCallbackCommand> dragged;
  dragged->SetClientData(this);
  dragged->SetCallback(&vtkBRDFLobeView::Dragged);
  this->Widget->AddObserver(vtkCommand::InteractionEvent, dragged);
  this->Widget->AddObserver(vtkCommand::EndInteractionEvent, dragged);
}

void vtkBRDFLobeView::Dragged(vtkObject*, unsigned long event, void* view, void*)
{
  auto* self = static_cast<vtkBRDFLobeView*>(view);
  const auto rounded = [](double degrees) { return std::round(10 * degrees) / 10; };
  self->SetThetaI(std::clamp(rounded(self->Widget->GetTheta()), 0.0, 89.0));
  self->SetPhiI(rounded(self->Widget->GetPhi()));
  self->Moving = event == vtkCommand::InteractionEvent;
  self->Render();
}

std::string vtkBRDFLobeView::ColourOfLobes() const
{
  return this->Colour != "auto" ? this->Colour : this->Channel == "rgb" ? "true" : "material";
}

bool vtkBRDFLobeView::IsColored(std::size_t input) const
{
  return !this->IsDifference() && this->ColourOfLobes() != "material" && (input == 0 || this->Layout == "side");
}

std::string vtkBRDFLobeView::NameOf(std::size_t input) const
{
  const Input& one = (*this->Inputs)[input];
  return one.Name.empty() ? Rounded(one.Data()->GetDescription()) : one.Name;
}

double vtkBRDFLobeView::UpdateLobes()
{
  double length = 0;
  for (std::size_t i = 0; i < (this->IsDifference() ? 1 : this->Inputs->size()); ++i)
  {
    vtkBRDFLobe* lobe = (*this->Inputs)[i].Lobe;
    lobe->SetThetaI(this->ThetaI);
    lobe->SetPhiI(this->PhiI);
    lobe->SetTransform(this->Transform);
    lobe->SetFloor(this->Floor);
    lobe->SetChannel(this->Channel);
    vtkBRDFColourSettings::Copy(this, lobe);
    lobe->SetResolution(this->Moving ? std::max(this->Resolution - 1, 0) : this->Resolution);
    lobe->SetTolerance(this->Moving ? 8 * this->Tolerance : this->Tolerance);
    lobe->SetShape(this->Shape);
    lobe->SetInputConnection(1, this->IsDifference() ? (*this->Inputs)[1].Lobe->GetInputConnection(0, 0) : nullptr);
    const std::string colour = this->ColourOfLobes();
    lobe->SetColour(this->IsColored(i) && colour != "value" ? colour : "");
    UpdateOrThrow(lobe);
    length = std::max(length, lobe->GetMaximumLength() + lobe->GetReferenceRadius());
  }
  return length;
}

vtkBRDFLobeView::Points vtkBRDFLobeView::FindSamples()
{
  Points points;
  if (!this->ShowSamples || this->IsDifference())
  {
    return points;
  }
  for (std::size_t i = 0; i < this->Inputs->size() && points.Measured == Points::None; ++i)
  {
    if ((*this->Inputs)[i].Data()->GetBrdf()->samples())
    {
      points.Measured = i;
    }
  }
  if (points.Measured == Points::None)
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "no samples to show", "lobe view", this->NameOf(0), "a measurement" });
  }
  points.Samples = vtkSmartPointer<vtkBRDFLobeSamples>::New();
  points.Samples->SetInputConnection(0, (*this->Inputs)[points.Measured].Lobe->GetInputConnection(0, 0));
  if (this->Inputs->size() > 1)
  {
    points.Model = points.Measured == 0 ? 1 : 0;
    points.Samples->SetInputConnection(1, (*this->Inputs)[points.Model].Lobe->GetInputConnection(0, 0));
  }
  points.Samples->SetThetaI(this->ThetaI);
  points.Samples->SetPhiI(this->PhiI);
  points.Samples->SetWithin(this->SampleAngle);
  points.Samples->SetTransform(this->Transform);
  points.Samples->SetFloor(this->Floor);
  points.Samples->SetChannel(this->Channel);
  vtkBRDFColourSettings::Copy(this, points.Samples.Get());
  UpdateOrThrow(points.Samples);
  return points;
}

void vtkBRDFLobeView::AddLobe(const Plan& plan, std::size_t input, std::size_t stage)
{
  const Frame& frame = plan.Room;
  vtkBRDFLobe* lobe = (*this->Inputs)[input].Lobe;
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(lobe->GetOutput());
  const bool colored = this->IsColored(input) || this->IsDifference();
  if (colored && this->IsDifference())
  {
    SetColors(surface, "transformed", plan.Scale);
  }
  else if (colored && this->ColourOfLobes() == "true")
  {
    surface->GetPointData()->SetActiveScalars("rgb");
  }
  else if (colored)
  {
    SetColors(surface, this->ColourOfLobes() == "value" ? "transformed" : "colour", plan.Scale);
  }
  const Stage at = { this->GetRenderer(), frame.Origin(stage), frame.Text, frame.PixelsPerRadius };
  vtkProperty* property = vtkBRDFLobeScene::AddSurface(at, surface, 1 / plan.Length, PaletteColor(input), colored);
  if (colored && this->ColourOfLobes() != "true")
  {
    property->SetSpecular(0); // highlights are no value
    property->SetAmbient(0.5);
    property->SetDiffuse(0.5);
  }
  if (lobe->GetReferenceRadius() > 0)
  {
    vtkBRDFLobeScene::AddHemisphere(at, lobe->GetReferenceRadius() / plan.Length);
  }
  property->SetOpacity(plan.IsSideBySide() || input == plan.Drawn.front() ? 1 : 0.45);
}

void vtkBRDFLobeView::AddPoints(const Plan& plan)
{
  const Points& points = plan.Shown;
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(points.Samples->GetOutput());
  if (data->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (points.HasResiduals())
  {
    SetColors(data, "residual", plan.Scale);
  }
  const auto stageOf = [&](std::size_t input)
  {
    const auto found = std::find(plan.Drawn.begin(), plan.Drawn.end(), input);
    return static_cast<std::size_t>(found - plan.Drawn.begin());
  };
  const std::size_t input = points.HasResiduals() ? points.Model : points.Measured;
  const Frame& frame = plan.Room;
  const Stage at = {
    this->GetRenderer(), frame.Origin(plan.IsSideBySide() ? stageOf(input) : 0), frame.Text, frame.PixelsPerRadius
  };
  vtkBRDFLobeScene::AddPoints(at, data, 1 / plan.Length, Ink, points.HasResiduals());
}

void vtkBRDFLobeView::Build(int width, int height)
{
  using brdf::Error;
  if (this->Inputs->empty())
  {
    throw Error(Error::Kind::Value, { "nothing to draw", "lobe view", "no BRDF", "one or more" });
  }
  if (this->Layout != "overlay" && this->Layout != "side")
  {
    throw Error(Error::Kind::Value, { "unknown layout", "lobe view", this->Layout, "overlay, side" });
  }
  if (this->IsDifference() && this->Inputs->size() != 2)
  {
    throw Error(Error::Kind::Value,
                { "a difference is of two BRDFs", "lobe view", std::to_string(this->Inputs->size()), "2" });
  }
  Plan plan;
  const double length = this->UpdateLobes();
  plan.Shown = this->FindSamples();
  for (std::size_t i = 0; i < (this->IsDifference() ? 1 : this->Inputs->size()); ++i)
  {
    if (!plan.Shown.Replace(i))
    {
      plan.Drawn.push_back(i);
    }
  }
  plan.Length = std::max(length, plan.Shown.Samples ? plan.Shown.Samples->GetMaximumLength() : 0);
  plan.Length = this->Length > 0 ? this->Length : plan.Length > 0 ? plan.Length : 1;
  this->ChooseScale(plan);
  plan.Room = this->MakeFrame(width, height, this->Layout == "side" ? plan.Drawn.size() : 1, plan.HasBar);

  vtkRenderer* renderer = this->GetRenderer();
  renderer->SetUseDepthPeeling(true);
  renderer->SetMaximumNumberOfPeels(8);
  this->PlaceCamera(plan.Room);
  vtkBRDFLobeScene::SetLights(renderer);
  for (std::size_t stage = 0; stage < plan.Room.Columns * plan.Room.Rows && stage < plan.Drawn.size(); ++stage)
  {
    const Stage at = { renderer, plan.Room.Origin(stage), plan.Room.Text, plan.Room.PixelsPerRadius };
    vtkBRDFLobeScene::AddGround(at, this->ThetaI, this->PhiI);
    vtkBRDFLobeScene::AddDirections(at, this->ThetaI, this->PhiI, !this->Widget || stage > 0);
  }
  for (std::size_t k = 0; k < plan.Drawn.size(); ++k)
  {
    this->AddLobe(plan, plan.Drawn[k], plan.IsSideBySide() ? k : 0);
  }
  if (plan.Shown.Samples)
  {
    this->AddPoints(plan);
  }
  if (this->Widget)
  {
    this->Widget->SetTheta(this->ThetaI);
    this->Widget->SetPhi(this->PhiI);
    this->Widget->SetEnabled(1);
    renderer->AddViewProp(this->Widget->GetDirectionRepresentation());
  }
  this->AddCaptions(plan);
  this->AddLegend(plan);
  if (plan.HasBar)
  {
    const double text = plan.Room.Text, left = width - 6 * text;
    AddColorBar(renderer,
                plan.Scale,
                { left, plan.Room.Low + 2 * text },
                { left + text, plan.Room.Top - text },
                plan.Room.Text,
                plan.BarTitle);
  }
}

void vtkBRDFLobeView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ThetaI: " << this->ThetaI << " degrees\n"
     << indent << "PhiI: " << this->PhiI << " degrees\n"
     << indent << "Transform: " << this->Transform << "\n"
     << indent << "Floor: " << this->Floor << "/sr\n"
     << indent << "Channel: " << this->Channel << "\n"
     << indent << "Colour: " << this->Colour << "\n"
     << indent << "Layout: " << this->Layout << "\n"
     << indent << "Shape: " << this->Shape << "\n"
     << indent << "ShowSamples: " << this->ShowSamples << "\n"
     << indent << "SampleAngle: " << this->SampleAngle << " degrees\n"
     << indent << "Illuminant: " << this->Illuminant << "\n"
     << indent << "Observer: " << this->Observer << "\n"
     << indent << "Adaptation: " << this->Adaptation << "\n"
     << indent << "Resolution: " << this->Resolution << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "Length: " << this->Length << "\n"
     << indent << "CameraAzimuth: " << this->CameraAzimuth << " degrees\n"
     << indent << "CameraElevation: " << this->CameraElevation << " degrees\n";
}
