#include "vtkBRDFCells.h"

#include "vtkBRDF.h"
#include "vtkBRDFArrays.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <brdf/base/Error.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/GridImage.h>
#include <brdf/material/TableBrdf.h>

using namespace vtkBRDFArrays;

vtkStandardNewMacro(vtkBRDFCells);
vtkBRDFCells::vtkBRDFCells() = default;
vtkBRDFCells::~vtkBRDFCells() = default;

namespace
{
// What tables and grids have in common.
struct Cells
{
  brdf::GridLayout Layout;
  brdf::GridImage Image;
  const std::vector<double>* Values;
  const std::vector<std::uint8_t>* States;
  const std::vector<double>* Errors;
  int Extent[6]; // vtkImageData::SetExtent wants it writable
};

Cells CellsOf(const brdf::Brdf& material)
{
  static const std::vector<double> none;
  Cells cells{};
  const auto* table = dynamic_cast<const brdf::TableBrdf*>(&material);
  if (table)
  {
    const brdf::TableData& data = table->data();
    cells = { brdf::GridLayout::fromTable(data.layout), {}, &data.values, &data.valid, &none, {} };
  }
  else if (const auto* grid = dynamic_cast<const brdf::GridBrdf*>(&material))
  {
    const brdf::GridData& data = grid->data();
    cells = { data.layout, {}, &data.values, &data.states, &data.standardError, {} };
  }
  else
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "a BRDF without cells", "input port 0", material.description(), "a table or grid" });
  }
  cells.Image = brdf::imageOf(cells.Layout);
  const bool atLowerEnds = table && table->position() == brdf::TableBrdf::Position::Node;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (atLowerEnds)
    {
      cells.Image.origin[axis] = 0;
    }
    cells.Extent[2 * axis + 1] = static_cast<int>(cells.Image.size[axis]) - 1;
  }
  return cells;
}
}

vtkImageData* vtkBRDFCells::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkBRDFCells::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

// An image announces its extent, and only the data know it: upstream is updated here, which costs nothing, as it is
// asked for the same whole BRDF afterwards.
int vtkBRDFCells::RequestInformation(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  if (vtkAlgorithm* upstream = this->GetInputAlgorithm(0, 0))
  {
    upstream->Update();
  }
  const vtkBRDF* input = vtkBRDF::GetData(inputs[0]);
  if (!input || !input->GetBrdf())
  {
    const int empty[6] = { 0, -1, 0, -1, 0, -1 };
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), empty, 6);
    return 1;
  }
  const Cells cells = CellsOf(*input->GetBrdf());
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), cells.Extent, 6);
  info->Set(vtkDataObject::ORIGIN(), cells.Image.origin.data(), 3);
  info->Set(vtkDataObject::SPACING(), cells.Image.spacing.data(), 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, -1);
  return 1;
}

int vtkBRDFCells::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const auto material = GetInputBrdf(inputs);
  Cells cells = CellsOf(*material);
  const std::size_t channels = material->channels().count();
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->SetExtent(cells.Extent);
  output->SetOrigin(cells.Image.origin.data());
  output->SetSpacing(cells.Image.spacing.data());
  output->GetPointData()->SetScalars(Interleaved("value", *cells.Values, channels));
  output->GetPointData()->AddArray(Bytes("state", *cells.States));
  if (!cells.Errors->empty())
  {
    output->GetPointData()->AddArray(Interleaved("standardError", *cells.Errors, channels));
  }
  vtkFieldData* fields = output->GetFieldData();
  AddTexts(fields, "axes", { cells.Image.name.begin(), cells.Image.name.end() });
  AddTexts(fields, "units", { cells.Image.unit.begin(), cells.Image.unit.end() });
  AddTexts(fields, "parametrisation", { std::string(brdf::parametrisationName(cells.Layout.parametrisation)) });
  return 1;
}

void vtkBRDFCells::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
