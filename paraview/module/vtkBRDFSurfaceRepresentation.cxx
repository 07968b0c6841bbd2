#include "vtkBRDFSurfaceRepresentation.h"

#include "vtkBRDF.h"
#include "vtkBRDFEnvironment.h"
#include "vtkBRDFPolyDataMapper.h"
#include "vtkBRDFSurfaceMaterial.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVView.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <brdf/io/Container.h>

#include <exception>

vtkStandardNewMacro(vtkBRDFSurfaceRepresentation);

namespace
{
// The first surface with polygons; null where there is none.
vtkPolyData* FirstSurface(vtkDataObject* piece)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(piece))
  {
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      if (vtkPolyData* surface = FirstSurface(iterator->GetCurrentDataObject()))
      {
        return surface;
      }
    }
    return nullptr;
  }
  auto* surface = vtkPolyData::SafeDownCast(piece);
  return surface && surface->GetNumberOfPolys() > 0 ? surface : nullptr;
}
} // namespace

vtkBRDFSurfaceRepresentation::vtkBRDFSurfaceRepresentation()
{
  this->BRDFMapper->SetBRDFData(this->Material);
  this->BRDFMapper->SetEnvironment(this->Environment);
  this->BRDFMapper->EncodeForDisplayOn();
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
  return this->ErrorText.empty() ? this->BRDFMapper->GetErrorText() : this->ErrorText;
}

// Takes the material of a surface from its field data.
void vtkBRDFSurfaceRepresentation::ReadMaterial(vtkPolyData* surface)
{
  this->ErrorText.clear();
  this->Material->Initialize();
  auto* bytes = vtkUnsignedCharArray::SafeDownCast(
    surface->GetFieldData()->GetAbstractArray(vtkBRDFSurfaceMaterial::GetArrayName()));
  if (!bytes)
  {
    this->ErrorText = "the surface has no material: put the filter \"BRDF Surface Material\" before it";
    vtkWarningMacro(<< this->ErrorText);
    return;
  }
  try
  {
    const std::string_view text(reinterpret_cast<const char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
    this->Material->SetBrdf(brdf::Container::fromBytes(text, "the surface's material").load(0));
  }
  catch (const std::exception& error)
  {
    this->ErrorText = error.what();
    vtkErrorMacro(<< this->ErrorText);
  }
}

// What has arrived to be drawn: the mapper's input, and the actor's choice of mapper.
void vtkBRDFSurfaceRepresentation::TakePiece(vtkDataObject* piece)
{
  if (piece == this->Drawn && (!piece || piece->GetMTime() == this->DrawnTime))
  {
    return;
  }
  this->Drawn = piece;
  this->DrawnTime = piece ? piece->GetMTime() : 0;
  if (vtkPolyData* surface = FirstSurface(piece))
  {
    this->ReadMaterial(surface);
    this->BRDFMapper->SetInputDataObject(0, surface);
  }
  else
  {
    this->Material->Initialize();
  }
  const bool ours = !this->Material->IsEmpty();
  this->Actor->SetMapper(ours ? static_cast<vtkMapper*>(this->BRDFMapper) : this->Mapper);
  this->Actor->SetLODMapper(ours ? static_cast<vtkMapper*>(this->BRDFMapper) : this->LODMapper);
}

int vtkBRDFSurfaceRepresentation::ProcessViewRequest(vtkInformationRequestKey* request,
                                                     vtkInformation* input,
                                                     vtkInformation* output)
{
  const int result = this->Superclass::ProcessViewRequest(request, input, output);
  if (result && request == vtkPVView::REQUEST_RENDER())
  {
    this->TakePiece(vtkPVView::GetDeliveredPiece(input, this));
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
