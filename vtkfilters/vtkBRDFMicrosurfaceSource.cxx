#include "vtkBRDFMicrosurfaceSource.h"

#include "vtkBRDFMicrosurface.h"
#include "vtkBRDFMicrosurfaceData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <brdf/simulate/SurfaceKinds.h>

vtkStandardNewMacro(vtkBRDFMicrosurfaceSource);

vtkBRDFMicrosurfaceSource::vtkBRDFMicrosurfaceSource() = default;
vtkBRDFMicrosurfaceSource::~vtkBRDFMicrosurfaceSource() = default;

vtkBRDFMicrosurface* vtkBRDFMicrosurfaceSource::GetOutput()
{
  return vtkBRDFMicrosurface::SafeDownCast(this->GetOutputDataObject(0));
}

void vtkBRDFMicrosurfaceSource::GetKinds(vtkStringArray* names)
{
  names->Initialize();
  for (const brdf::SurfaceKind& kind : brdf::surfaceKinds())
  {
    names->InsertNextValue(kind.name);
  }
}

int vtkBRDFMicrosurfaceSource::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkBRDFMicrosurfaceSource::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkBRDFMicrosurface");
  return 1;
}

int vtkBRDFMicrosurfaceSource::RequestData(vtkInformation*,
                                           vtkInformationVector** inputs,
                                           vtkInformationVector* outputs)
{
  vtkDataObject* input = inputs[0]->GetNumberOfInformationObjects() > 0 ? vtkDataObject::GetData(inputs[0]) : nullptr;
  auto made = std::make_shared<brdf::MadeSurface>();
  if (!input)
  {
    *made = brdf::makeSurface(this->Surface, vtkBRDFMicrosurfaceData::Readers());
  }
  else
  {
    brdf::SurfaceShape shape;
    if (auto* image = vtkImageData::SafeDownCast(input))
    {
      shape = vtkBRDFMicrosurfaceData::FromImage(image, this->HeightScale);
    }
    else
    {
      brdf::TiledMesh mesh = vtkBRDFMicrosurfaceData::FromPolyData(vtkPolyData::SafeDownCast(input));
      mesh.periodX = this->Period[0];
      mesh.periodY = this->Period[1];
      brdf::setMissingPeriods(mesh, "the mesh of a microsurface");
      shape = std::move(mesh);
    }
    *made = brdf::describedSurface(std::move(shape), input->IsA("vtkImageData") ? "heights of an image" : "mesh");
  }
  vtkBRDFMicrosurface::GetData(outputs)->SetSurface(std::move(made));
  return 1;
}

void vtkBRDFMicrosurfaceSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << this->Surface << "\n"
     << indent << "HeightScale: " << this->HeightScale << "\n"
     << indent << "Period: " << this->Period[0] << " " << this->Period[1] << "\n";
}
