#include "vtkBRDFMicrosurfaceGeometry.h"

#include "vtkBRDFMicrosurface.h"
#include "vtkBRDFMicrosurfaceData.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <brdf/base/Error.h>
#include <brdf/simulate/SurfaceKinds.h>

vtkStandardNewMacro(vtkBRDFMicrosurfaceGeometry);

vtkBRDFMicrosurfaceGeometry::vtkBRDFMicrosurfaceGeometry()
{
  this->SetNumberOfOutputPorts(2);
}

vtkBRDFMicrosurfaceGeometry::~vtkBRDFMicrosurfaceGeometry() = default;

vtkPolyData* vtkBRDFMicrosurfaceGeometry::GetOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

vtkImageData* vtkBRDFMicrosurfaceGeometry::GetHeights()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkBRDFMicrosurfaceGeometry::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkBRDFMicrosurface");
  return 1;
}

int vtkBRDFMicrosurfaceGeometry::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkBRDFMicrosurfaceGeometry::RequestInformation(vtkInformation*,
                                                    vtkInformationVector** inputs,
                                                    vtkInformationVector* outputs)
{
  vtkBRDFMicrosurface* input = vtkBRDFMicrosurface::GetData(inputs[0]);
  const auto* field =
    input && input->GetSurface() ? std::get_if<brdf::HeightField>(&input->GetSurface()->surface.shape) : nullptr;
  const int extent[6] = { 0, field ? static_cast<int>(field->columns) - 1 : -1,
                          0, field ? static_cast<int>(field->rows) - 1 : -1,
                          0, field ? 0 : -1 };
  outputs->GetInformationObject(1)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

int vtkBRDFMicrosurfaceGeometry::RequestData(vtkInformation*,
                                             vtkInformationVector** inputs,
                                             vtkInformationVector* outputs)
{
  vtkBRDFMicrosurface* input = vtkBRDFMicrosurface::GetData(inputs[0]);
  if (!input || !input->GetSurface())
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "no surface", "input port 0", input ? "an empty one" : "nothing", "a vtkBRDFMicrosurface" });
  }
  const brdf::SurfaceShape& shape = input->GetSurface()->surface.shape;
  vtkPolyData* polygons = vtkPolyData::GetData(outputs, 0);
  polygons->ShallowCopy(vtkBRDFMicrosurfaceData::ToPolyData(shape, this->Tiles[0], this->Tiles[1], this->Stride));
  polygons->GetFieldData()->ShallowCopy(input->GetFieldData());
  vtkImageData* heights = vtkImageData::GetData(outputs, 1);
  heights->Initialize();
  if (const auto* field = std::get_if<brdf::HeightField>(&shape))
  {
    heights->ShallowCopy(vtkBRDFMicrosurfaceData::ToImage(*field));
  }
  return 1;
}

void vtkBRDFMicrosurfaceGeometry::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tiles: " << this->Tiles[0] << " " << this->Tiles[1] << "\n"
     << indent << "Stride: " << this->Stride << "\n";
}
