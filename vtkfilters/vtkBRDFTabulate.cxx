#include "vtkBRDFTabulate.h"

#include "vtkBRDF.h"
#include "vtkBRDFArrays.h"
#include "vtkBRDFTableImage.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <brdf/material/TableBrdf.h>

vtkStandardNewMacro(vtkBRDFTabulate);
vtkBRDFTabulate::vtkBRDFTabulate() = default;
vtkBRDFTabulate::~vtkBRDFTabulate() = default;

vtkImageData* vtkBRDFTabulate::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkBRDFTabulate::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

int vtkBRDFTabulate::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const vtkBRDFTableImage::Grid grid(vtkBRDFTableImage::LayoutFor(this->Cells, this->Reciprocal));
  vtkInformation* info = outputs->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), grid.Extent, 6);
  info->Set(vtkDataObject::SPACING(), grid.Spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), grid.Origin, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, -1);
  return 1;
}

int vtkBRDFTabulate::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const brdf::TableLayout layout = vtkBRDFTableImage::LayoutFor(this->Cells, this->Reciprocal);
  const auto table = brdf::TableBrdf::tabulate(*GetInputBrdf(inputs), layout);
  const brdf::TableData& data = table->data();
  vtkBRDFTableImage::Grid grid(layout);
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->SetExtent(grid.Extent);
  output->SetSpacing(grid.Spacing);
  output->SetOrigin(grid.Origin);
  output->GetPointData()->SetScalars(vtkBRDFArrays::Interleaved("value", data.values, data.channels.count()));
  output->GetPointData()->AddArray(vtkBRDFArrays::Bytes("valid", data.valid));
  if (data.channels.kind == brdf::Channels::Kind::Spectral)
  {
    output->GetFieldData()->AddArray(vtkBRDFArrays::Numbers("wavelengths", data.channels.wavelengths));
  }
  return 1;
}

void vtkBRDFTabulate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Cells: " << this->Cells[0] << " " << this->Cells[1] << " " << this->Cells[2] << "\n"
     << indent << "Reciprocal: " << this->Reciprocal << "\n";
}
