#include "vtkBRDFTabulate.h"

#include "vtkBRDF.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <brdf/base/Error.h>
#include <brdf/material/TableBrdf.h>

#include <algorithm>

vtkStandardNewMacro(vtkBRDFTabulate);
vtkBRDFTabulate::vtkBRDFTabulate() = default;
vtkBRDFTabulate::~vtkBRDFTabulate() = default;

namespace
{
// Extent, spacing and origin of a table's cell centres.
struct Grid
{
  explicit Grid(const brdf::TableLayout& layout)
    : Extent{ 0, static_cast<int>(layout.phiD) - 1,  0, static_cast<int>(layout.thetaD) - 1,
              0, static_cast<int>(layout.thetaH) - 1 }
    , Spacing{ (layout.reciprocal ? 180.0 : 360.0) / layout.phiD, 90.0 / layout.thetaD, 1.0 / layout.thetaH }
    , Origin{ this->Spacing[0] / 2, this->Spacing[1] / 2, this->Spacing[2] / 2 }
  {
  }
  int Extent[6]; // vtkImageData::SetExtent wants it writable
  double Spacing[3];
  double Origin[3];
};

brdf::TableLayout LayoutFor(const int cells[3], bool reciprocal)
{
  if (std::min({ cells[0], cells[1], cells[2] }) < 2 || std::max({ cells[0], cells[1], cells[2] }) > 1024)
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "out of range",
                        "table cells",
                        std::to_string(cells[0]) + " x " + std::to_string(cells[1]) + " x " + std::to_string(cells[2]),
                        "2 to 1024 each" });
  }
  brdf::TableLayout layout;
  layout.phiD = static_cast<std::size_t>(cells[0]);
  layout.thetaD = static_cast<std::size_t>(cells[1]);
  layout.thetaH = static_cast<std::size_t>(cells[2]);
  layout.reciprocal = reciprocal;
  return layout;
}
}

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
  const Grid grid(LayoutFor(this->Cells, this->Reciprocal));
  vtkInformation* info = outputs->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), grid.Extent, 6);
  info->Set(vtkDataObject::SPACING(), grid.Spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), grid.Origin, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, -1);
  return 1;
}

int vtkBRDFTabulate::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const brdf::TableLayout layout = LayoutFor(this->Cells, this->Reciprocal);
  const auto table = brdf::TableBrdf::tabulate(*GetInputBrdf(inputs), layout);
  const brdf::TableData& data = table->data();
  const auto cells = static_cast<vtkIdType>(layout.cells());
  const auto channels = static_cast<int>(data.channels.count());
  vtkNew<vtkDoubleArray> value;
  value->SetName("value");
  value->SetNumberOfComponents(channels);
  value->SetNumberOfTuples(cells);
  for (int c = 0; c < channels; ++c)
  {
    for (vtkIdType i = 0; i < cells; ++i)
    {
      value->SetTypedComponent(i, c, data.values[c * cells + i]);
    }
  }
  vtkNew<vtkUnsignedCharArray> valid;
  valid->SetName("valid");
  valid->SetNumberOfTuples(cells);
  std::copy(data.valid.begin(), data.valid.end(), valid->GetPointer(0));

  Grid grid(layout);
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->SetExtent(grid.Extent);
  output->SetSpacing(grid.Spacing);
  output->SetOrigin(grid.Origin);
  output->GetPointData()->SetScalars(value);
  output->GetPointData()->AddArray(valid);
  return 1;
}

void vtkBRDFTabulate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Cells: " << this->Cells[0] << " " << this->Cells[1] << " " << this->Cells[2] << "\n"
     << indent << "Reciprocal: " << this->Reciprocal << "\n";
}
