#include "vtkBRDFVolumeView.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkBRDF.h"
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFAngleAxes.h"
#include "vtkBRDFPlotData.h"
#include "vtkBRDFTabulate.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <brdf/base/Error.h>
#include <brdf/geometry/Directions.h>
#include <brdf/view/ChannelChoice.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace vtkBRDFDrawing;

vtkStandardNewMacro(vtkBRDFVolumeView);
vtkBRDFVolumeView::vtkBRDFVolumeView() = default;
vtkBRDFVolumeView::~vtkBRDFVolumeView() = default;

namespace
{
constexpr int Levels = 4095; // of the scale in the volume; 0: nothing there

void AddLabel(vtkRenderer* renderer, const std::string& text, const std::array<double, 3>& at, int size)
{
  vtkNew<vtkBillboardTextActor3D> actor;
  actor->SetInput(text.c_str());
  actor->SetPosition(at[0], at[1], at[2]);
  actor->GetTextProperty()->SetFontFamilyToArial();
  actor->GetTextProperty()->SetFontSize(size);
  actor->GetTextProperty()->SetColor(Ink[0], Ink[1], Ink[2]);
  actor->GetTextProperty()->SetJustificationToCentered();
  actor->GetTextProperty()->SetVerticalJustificationToCentered();
  renderer->AddActor(actor);
}
}

void vtkBRDFVolumeView::SetInputConnection(vtkAlgorithmOutput* brdf)
{
  this->Connection = brdf;
  this->Data = nullptr;
  this->Modified();
}

void vtkBRDFVolumeView::SetInputData(vtkDataObject* brdf)
{
  this->Data = brdf;
  this->Connection = nullptr;
  this->Modified();
}

vtkImageData* vtkBRDFVolumeView::GetTable()
{
  return this->Table;
}

void vtkBRDFVolumeView::TabulateOrThrow()
{
  if (this->Connection)
  {
    if (auto* producer = vtkBRDFAlgorithm::SafeDownCast(this->Connection->GetProducer()))
    {
      UpdateOrThrow(producer);
    }
  }
  vtkDataObject* data = this->Connection
                          ? this->Connection->GetProducer()->GetOutputDataObject(this->Connection->GetIndex())
                          : this->Data.Get();
  auto* input = vtkBRDF::SafeDownCast(data);
  if (!input || !input->GetBrdf())
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "no BRDF", "volume view", "nothing", "a vtkBRDF" });
  }
  for (const int cells : this->Cells)
  {
    if (cells < 2 || cells > 512)
    {
      throw brdf::Error(brdf::Error::Kind::Value,
                        { "out of range", "cells of a volume", std::to_string(cells), "2 to 512" });
    }
  }
  const brdf::ChannelChoice choice = brdf::chooseChannels(
    input->GetBrdf(), this->Channel, brdf::colourSettings({ this->Illuminant, this->Observer, this->Adaptation }));
  if (choice.brdf->channels().count() != 1)
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "a volume shows one value", "channel", this->Channel, "luminance, a number, a wavelength" });
  }
  this->Label = choice.label;
  vtkNew<vtkBRDF> single;
  single->SetBrdf(choice.brdf);
  vtkNew<vtkBRDFTabulate> tabulate;
  tabulate->SetInputData(single);
  tabulate->SetCells(this->Cells[2], this->Cells[1], this->Cells[0]);
  UpdateOrThrow(tabulate);
  this->Table = tabulate->GetOutput();
}

bool vtkBRDFVolumeView::Tabulate()
{
  return this->Guarded([this] { this->TabulateOrThrow(); });
}

void vtkBRDFVolumeView::AddAxes(int text)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const auto line = [&](const std::array<double, 3>& a, const std::array<double, 3>& b)
  {
    const vtkIdType from = points->InsertNextPoint(a.data()), to = points->InsertNextPoint(b.data());
    cells->InsertNextCell({ from, to });
  };
  for (int corner = 0; corner < 4; ++corner)
  {
    const double a = corner % 2, b = corner / 2;
    line({ 0, a, b }, { 1, a, b });
    line({ a, 0, b }, { a, 1, b });
    line({ a, b, 0 }, { a, b, 1 });
  }
  // Ticks and names stand on edges in front: of theta_h and phi_d below, of theta_d at the left.
  const double out = 0.025, label = 0.075;
  for (const double degrees : { 0.0, 5.0, 15.0, 30.0, 60.0, 90.0 })
  {
    const double x = std::sqrt(degrees / 90);
    line({ x, 0, 1 }, { x, -out, 1 });
    AddLabel(this->GetRenderer(), NumberText(degrees) + "\u00b0", { x, -label, 1 + label / 2 }, text);
  }
  for (const double degrees : { 0.0, 30.0, 60.0, 90.0 })
  {
    line({ 0, degrees / 90, 1 }, { -out, degrees / 90, 1 });
    AddLabel(this->GetRenderer(), NumberText(degrees) + "\u00b0", { -label, degrees / 90, 1 + label / 2 }, text);
  }
  for (const double degrees : { 45.0, 90.0, 135.0, 180.0 })
  {
    line({ 1, 0, 1 - degrees / 180 }, { 1 + out, 0, 1 - degrees / 180 });
    AddLabel(
      this->GetRenderer(), NumberText(degrees) + "\u00b0", { 1 + 1.2 * label, -label / 2, 1 - degrees / 180 }, text);
  }
  AddLabel(this->GetRenderer(), "half angle theta_h", { 0.5, -2.1 * label, 1 + label }, text);
  AddLabel(this->GetRenderer(), "theta_d", { -2.7 * label, 0.5, 1 + label / 2 }, text);
  AddLabel(this->GetRenderer(), "phi_d", { 1 + 2.9 * label, -1.1 * label, 0.5 }, text);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(Faint[0], Faint[1], Faint[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(LineWidth(text)));
  actor->GetProperty()->LightingOff();
  this->GetRenderer()->AddActor(actor);
}

void vtkBRDFVolumeView::Build(int width, int height)
{
  this->TabulateOrThrow();
  const int* cells = this->Cells;
  vtkDataArray* value = this->Table->GetPointData()->GetArray("value");
  vtkDataArray* valid = this->Table->GetPointData()->GetArray("valid");
  PlotCurve known;
  for (vtkIdType i = 0; i < value->GetNumberOfTuples(); ++i)
  {
    if (valid->GetTuple1(i) != 0)
    {
      known.Y.push_back(value->GetTuple1(i));
    }
  }
  const PlotScale scale = PlotScale::OfMap(PlotScale::Kind::Log, { &known }, this->Decades);

  vtkNew<vtkImageData> volume;
  volume->SetDimensions(cells[0], cells[1], cells[2]);
  volume->SetSpacing(1.0 / cells[0], 1.0 / cells[1], 1.0 / cells[2]);
  volume->SetOrigin(0.5 / cells[0], 0.5 / cells[1], 0.5 / cells[2]);
  volume->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  auto* voxel = static_cast<unsigned short*>(volume->GetScalarPointer());
  for (int z = 0; z < cells[2]; ++z)
  {
    // phi_d grows away from the eye.
    const int phi = cells[2] - 1 - z;
    for (int y = 0; y < cells[1]; ++y)
    {
      for (int x = 0; x < cells[0]; ++x, ++voxel)
      {
        const vtkIdType i = phi + static_cast<vtkIdType>(cells[2]) * (y + static_cast<vtkIdType>(cells[1]) * x);
        const double at = valid->GetTuple1(i) == 0 ? 0 : std::clamp(scale.Position(value->GetTuple1(i)), 0.0, 1.0);
        *voxel = static_cast<unsigned short>(std::lround(at * Levels));
      }
    }
  }
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (int k = 0; k <= 64; ++k)
  {
    const double t = k / 64.0;
    const Color shade = Sequential(t);
    color->AddRGBPoint(t * Levels, shade[0], shade[1], shade[2]);
    opacity->AddPoint(t * Levels, this->Opacity * t * t * t);
  }
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->SetInputData(volume);
  mapper->SetAutoAdjustSampleDistances(false);
  mapper->SetImageSampleDistance(1);
  mapper->SetSampleDistance(static_cast<float>(0.5 / std::max({ cells[0], cells[1], cells[2] })));
  vtkNew<vtkVolume> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color);
  actor->GetProperty()->SetScalarOpacity(opacity);
  actor->GetProperty()->SetScalarOpacityUnitDistance(0.1);
  actor->GetProperty()->SetInterpolationTypeToLinear();
  vtkRenderer* renderer = this->GetRenderer();
  const int text = TextSize(width, height);
  this->AddAxes(text);
  renderer->AddVolume(actor);

  vtkCamera* camera = renderer->GetActiveCamera();
  const double azimuth = brdf::radians(this->Azimuth), elevation = brdf::radians(this->Elevation);
  // Room for the colour bar at the right and the heading above.
  const double aspect = static_cast<double>(width) / height, distance = 3.9 * std::max(1.0, 1.25 / aspect);
  const double center[3] = { 0.5, 0.47, 0.5 };
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] - distance * std::cos(elevation) * std::sin(azimuth),
                      center[1] + distance * std::sin(elevation),
                      center[2] + distance * std::cos(elevation) * std::cos(azimuth));
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(30);
  camera->SetWindowCenter(0.14, 0);
  renderer->ResetCameraClippingRange(-0.4, 1.5, -0.4, 1.3, -0.3, 1.4);

  AddValueBar(renderer,
              scale,
              "f_r (1/sr)",
              { width - 7.5 * text, 0.18 * height },
              { width - 6.1 * text, height - 8.0 * text },
              text);
  const std::string name =
    this->Name.empty()
      ? Rounded(vtkBRDF::SafeDownCast(
                  this->Connection ? this->Connection->GetProducer()->GetOutputDataObject(this->Connection->GetIndex())
                                   : this->Data.Get())
                  ->GetDescription())
      : this->Name;
  const auto letters = static_cast<std::size_t>(1.6 * (width - 2 * text) / text);
  AddHeading(renderer,
             this->GetTitle().empty() ? Shortened(name, letters) : this->GetTitle(),
             this->Label + "; half and difference angles, phi_h = 0\u00b0; logarithmic, opacity with the value",
             height - 0.7 * text,
             text);
}

void vtkBRDFVolumeView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->Name << "\n"
     << indent << "Channel: " << this->Channel << "\n"
     << indent << "Illuminant: " << this->Illuminant << "\n"
     << indent << "Observer: " << this->Observer << "\n"
     << indent << "Adaptation: " << this->Adaptation << "\n"
     << indent << "Cells: " << this->Cells[0] << " " << this->Cells[1] << " " << this->Cells[2] << "\n"
     << indent << "Decades: " << this->Decades << "\n"
     << indent << "Opacity: " << this->Opacity << "\n"
     << indent << "Azimuth: " << this->Azimuth << "\n"
     << indent << "Elevation: " << this->Elevation << "\n";
}
