#include "vtkBRDFSurfaceMaterial.h"

#include "vtkBRDFSurface.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <brdf/base/Error.h>
#include <brdf/io/Container.h>

#include <algorithm>

vtkStandardNewMacro(vtkBRDFSurfaceMaterial);

vtkBRDFSurfaceMaterial::vtkBRDFSurfaceMaterial()
{
  this->SetNumberOfInputPorts(2);
}

vtkBRDFSurfaceMaterial::~vtkBRDFSurfaceMaterial() = default;

vtkPolyData* vtkBRDFSurfaceMaterial::GetOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkBRDFSurfaceMaterial::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    return 1;
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkBRDFSurfaceMaterial::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkBRDFSurfaceMaterial::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto* surface = vtkPolyData::GetData(inputs[0]);
  const auto brdf = GetInputBrdf(inputs, 1);
  auto* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(vtkBRDFSurface::Complete(surface));
  output->GetFieldData()->PassData(surface->GetFieldData());

  vtkNew<vtkStringArray> description;
  description->SetName("vtkBRDF");
  description->InsertNextValue(brdf->description());
  output->GetFieldData()->AddArray(description);

  brdf::ContainerWriter writer({});
  writer.add("material", *brdf, brdf::makeProvenance({}, "surface material"));
  const std::string bytes = writer.finish();
  vtkNew<vtkUnsignedCharArray> container;
  container->SetName(GetArrayName());
  container->SetNumberOfValues(static_cast<vtkIdType>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), container->GetPointer(0));
  output->GetFieldData()->AddArray(container);
  return 1;
}
