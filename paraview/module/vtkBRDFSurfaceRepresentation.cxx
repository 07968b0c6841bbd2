#include "vtkBRDFSurfaceRepresentation.h"

#include "vtkActor.h"
#include "vtkBRDF.h"
#include "vtkBRDFEnvironment.h"
#include "vtkBRDFPolyDataMapper.h"
#include "vtkBRDFSurfaceMaterial.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkSkybox.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <brdf/base/Text.h>
#include <brdf/io/Container.h>
#include <brdf/io/ToneMap.h>

#include <algorithm>
#include <cmath>
#include <exception>

vtkStandardNewMacro(vtkBRDFSurfaceRepresentation);

struct vtkBRDFSurfaceRepresentation::Part
{
  vtkNew<vtkBRDFPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
};

namespace
{
// Every surface with polygons.
void AddSurfaces(vtkDataObject* piece, std::vector<vtkPolyData*>& surfaces)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(piece))
  {
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      AddSurfaces(iterator->GetCurrentDataObject(), surfaces);
    }
    return;
  }
  auto* surface = vtkPolyData::SafeDownCast(piece);
  if (surface && surface->GetNumberOfPolys() > 0)
  {
    surfaces.push_back(surface);
  }
}

// The material in a surface's field data; null where there is none. Throws brdf::Error where it is damaged.
vtkSmartPointer<vtkBRDF> MaterialOf(vtkPolyData* surface)
{
  auto* bytes = vtkUnsignedCharArray::SafeDownCast(
    surface->GetFieldData()->GetAbstractArray(vtkBRDFSurfaceMaterial::GetArrayName()));
  if (!bytes)
  {
    return nullptr;
  }
  const std::string_view text(reinterpret_cast<const char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
  auto material = vtkSmartPointer<vtkBRDF>::New();
  material->SetBrdf(brdf::Container::fromBytes(text, "the surface's material").load(0));
  return material;
}
} // namespace

vtkBRDFSurfaceRepresentation::vtkBRDFSurfaceRepresentation()
{
  this->BRDFMapper->SetEnvironment(this->Environment);
  this->BRDFMapper->EncodeForDisplayOn();
  this->Sky->SetProjectionToSphere();
  this->Sky->VisibilityOff();
  this->Sky->PickableOff();
}

vtkBRDFSurfaceRepresentation::~vtkBRDFSurfaceRepresentation() = default;

void vtkBRDFSurfaceRepresentation::SetEnvironmentFile(const char* path)
{
  const std::string wanted = path ? path : "";
  if (wanted == this->EnvironmentFile)
  {
    return;
  }
  this->EnvironmentFile = wanted;
  if (wanted.empty())
  {
    this->Environment->SetConstant(1, 1, 1);
  }
  else if (!this->Environment->ReadFile(wanted))
  {
    vtkErrorMacro(<< this->Environment->GetErrorText());
  }
  this->Modified();
}

void vtkBRDFSurfaceRepresentation::SetEnvironmentRotation(double degrees)
{
  this->Environment->SetRotation(degrees);
}

double vtkBRDFSurfaceRepresentation::GetEnvironmentRotation()
{
  return this->Environment->GetRotation();
}

void vtkBRDFSurfaceRepresentation::SetUseEnvironment(bool use)
{
  this->BRDFMapper->SetEnvironment(use ? this->Environment.Get() : nullptr);
}

bool vtkBRDFSurfaceRepresentation::GetUseEnvironment()
{
  return this->BRDFMapper->GetEnvironment() != nullptr;
}

void vtkBRDFSurfaceRepresentation::SetShowEnvironment(bool show)
{
  this->ShowEnvironment = show;
  this->UpdateSky();
}

void vtkBRDFSurfaceRepresentation::SetNumberOfSamples(int samples)
{
  this->BRDFMapper->SetNumberOfSamples(samples);
}

int vtkBRDFSurfaceRepresentation::GetNumberOfSamples()
{
  return this->BRDFMapper->GetNumberOfSamples();
}

void vtkBRDFSurfaceRepresentation::SetExposure(double stops)
{
  this->BRDFMapper->SetExposure(stops);
}

double vtkBRDFSurfaceRepresentation::GetExposure()
{
  return this->BRDFMapper->GetExposure();
}

void vtkBRDFSurfaceRepresentation::SetResamplingTolerance(double tolerance)
{
  this->BRDFMapper->SetResamplingTolerance(tolerance);
}

double vtkBRDFSurfaceRepresentation::GetResamplingTolerance()
{
  return this->BRDFMapper->GetResamplingTolerance();
}

std::string vtkBRDFSurfaceRepresentation::GetErrorText()
{
  std::string text = this->ErrorText.empty() ? this->BRDFMapper->GetErrorText() : this->ErrorText;
  for (std::size_t i = 0; i < this->Parts.size() && text.empty(); ++i)
  {
    text = this->Parts[i]->Mapper->GetErrorText();
  }
  return text;
}

// What has arrived to be drawn: the mappers' inputs, and the actor's choice of mapper.
void vtkBRDFSurfaceRepresentation::TakePiece(vtkDataObject* piece)
{
  if (piece == this->Drawn && (!piece || piece->GetMTime() == this->DrawnTime))
  {
    return;
  }
  this->Drawn = piece;
  this->DrawnTime = piece ? piece->GetMTime() : 0;
  this->ErrorText.clear();
  std::vector<vtkPolyData*> surfaces;
  AddSurfaces(piece, surfaces);
  this->TakeSurfaces(surfaces);
}

void vtkBRDFSurfaceRepresentation::TakeSurfaces(const std::vector<vtkPolyData*>& surfaces)
{
  std::vector<std::unique_ptr<Part>> parts;
  bool ours = false;
  for (vtkPolyData* surface : surfaces)
  {
    vtkSmartPointer<vtkBRDF> material;
    try
    {
      material = MaterialOf(surface);
    }
    catch (const std::exception& error)
    {
      this->ErrorText = error.what();
      vtkErrorMacro(<< this->ErrorText);
      continue;
    }
    if (!material)
    {
      this->ErrorText = "a surface has no material: put the filter \"BRDF Surface Material\" before it";
      vtkWarningMacro(<< this->ErrorText);
      continue;
    }
    vtkBRDFPolyDataMapper* mapper = this->BRDFMapper;
    if (ours)
    {
      // Mappers are kept from one time to the next: their shaders with them.
      const std::size_t next = parts.size();
      parts.push_back(next < this->Parts.size() ? std::move(this->Parts[next]) : std::make_unique<Part>());
      mapper = parts.back()->Mapper;
      parts.back()->Actor->SetMapper(mapper);
    }
    ours = true;
    mapper->SetBRDFData(material);
    mapper->SetInputDataObject(0, surface);
  }
  for (const std::unique_ptr<Part>& part : this->Parts)
  {
    if (part && this->Renderer)
    {
      this->Renderer->RemoveActor(part->Actor);
    }
  }
  this->Parts = std::move(parts);
  for (const std::unique_ptr<Part>& part : this->Parts)
  {
    if (this->Renderer)
    {
      this->Renderer->AddActor(part->Actor); // where it is not already
    }
  }
  this->Actor->SetMapper(ours ? static_cast<vtkMapper*>(this->BRDFMapper) : this->Mapper);
  this->Actor->SetLODMapper(ours ? static_cast<vtkMapper*>(this->BRDFMapper) : this->LODMapper);
}

// Gives the other surfaces what the first one has: place, visibility, light.
void vtkBRDFSurfaceRepresentation::MatchParts()
{
  for (const std::unique_ptr<Part>& part : this->Parts)
  {
    part->Actor->SetUserMatrix(this->Actor->GetMatrix());
    part->Actor->SetVisibility(this->Actor->GetVisibility());
    part->Mapper->SetEnvironment(this->BRDFMapper->GetEnvironment());
    part->Mapper->SetNumberOfSamples(this->BRDFMapper->GetNumberOfSamples());
    part->Mapper->SetExposure(this->BRDFMapper->GetExposure());
    part->Mapper->SetResamplingTolerance(this->BRDFMapper->GetResamplingTolerance());
    part->Mapper->EncodeForDisplayOn();
  }
}

// The sky as vtkSkybox takes it: a picture of all directions, encoded as the objects are.
void vtkBRDFSurfaceRepresentation::DrawSky()
{
  const int height = std::clamp(this->Environment->GetMapHeight(), 16, 2048), width = 2 * height;
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixels = static_cast<unsigned char*>(picture->GetScalarPointer());
  const double gain = std::exp2(this->GetExposure());
  const auto rows = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType row = first; row < last; ++row)
    {
      const double elevation = vtkMath::Pi() * ((static_cast<double>(row) + 0.5) / height - 0.5);
      for (int column = 0; column < width; ++column)
      {
        // The middle column is -z, columns run to +x.
        const double azimuth = 2 * vtkMath::Pi() * ((column + 0.5) / width - 0.5);
        const double direction[3] = { std::cos(elevation) * std::sin(azimuth),
                                      std::sin(elevation),
                                      -std::cos(elevation) * std::cos(azimuth) };
        double rgb[3];
        this->Environment->GetRadiance(direction, rgb);
        for (int channel = 0; channel < 3; ++channel)
        {
          const double encoded = brdf::srgbEncoded(std::clamp(rgb[channel] * gain, 0.0, 1.0));
          pixels[3 * (row * width + column) + channel] = static_cast<unsigned char>(std::lround(255 * encoded));
        }
      }
    }
  };
  vtkSMPTools::For(0, height, rows);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(picture);
  texture->InterpolateOn();
  texture->SetColorModeToDirectScalars();
  this->Sky->SetTexture(texture);
}

void vtkBRDFSurfaceRepresentation::UpdateSky()
{
  const bool shown = this->ShowEnvironment && this->GetUseEnvironment() && this->GetVisibility();
  this->Sky->SetVisibility(shown);
  const std::string key = this->EnvironmentFile + "|" + brdf::formatNumber(this->GetEnvironmentRotation()) + "|" +
                          brdf::formatNumber(this->GetExposure());
  if (shown && key != this->SkyKey)
  {
    this->SkyKey = key;
    this->DrawSky();
  }
}

void vtkBRDFSurfaceRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->MatchParts();
  this->UpdateSky();
}

bool vtkBRDFSurfaceRepresentation::AddToView(vtkView* view)
{
  if (auto* ours = vtkPVRenderView::SafeDownCast(view))
  {
    this->Renderer = ours->GetRenderer();
    this->Renderer->AddActor(this->Sky);
    for (const std::unique_ptr<Part>& part : this->Parts)
    {
      this->Renderer->AddActor(part->Actor);
    }
  }
  return this->Superclass::AddToView(view);
}

bool vtkBRDFSurfaceRepresentation::RemoveFromView(vtkView* view)
{
  if (this->Renderer)
  {
    for (const std::unique_ptr<Part>& part : this->Parts)
    {
      this->Renderer->RemoveActor(part->Actor);
    }
    this->Renderer->RemoveActor(this->Sky);
    this->Renderer = nullptr;
  }
  return this->Superclass::RemoveFromView(view);
}

int vtkBRDFSurfaceRepresentation::ProcessViewRequest(vtkInformationRequestKey* request,
                                                     vtkInformation* input,
                                                     vtkInformation* output)
{
  const int result = this->Superclass::ProcessViewRequest(request, input, output);
  if (result && request == vtkPVView::REQUEST_RENDER())
  {
    this->TakePiece(vtkPVView::GetDeliveredPiece(input, this));
    this->MatchParts();
    this->UpdateSky();
  }
  return result;
}

void vtkBRDFSurfaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "EnvironmentFile: " << this->EnvironmentFile << "\n";
  os << indent << "ErrorText: " << this->ErrorText << "\n";
  this->BRDFMapper->PrintSelf(os << indent << "BRDFMapper:\n", indent.GetNextIndent());
}
