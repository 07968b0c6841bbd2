#include "vtkBRDFFromTable.h"

#include "vtkBRDF.h"
#include "vtkBRDFArrays.h"
#include "vtkBRDFTableImage.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <brdf/base/Error.h>
#include <brdf/material/TableBrdf.h>

#include <cmath>

vtkStandardNewMacro(vtkBRDFFromTable);

namespace
{
[[noreturn]] void Refuse(const std::string& what, const std::string& found, const std::string& allowed)
{
  throw brdf::Error(brdf::Error::Kind::Value, { what, "image of a table", found, allowed });
}

std::string Text(const double numbers[3])
{
  return std::to_string(numbers[0]) + ", " + std::to_string(numbers[1]) + ", " + std::to_string(numbers[2]);
}

// The table whose cells lie where the image's points are.
brdf::TableLayout LayoutOf(vtkImageData* image)
{
  const int* cells = image->GetDimensions();
  const bool reciprocal = image->GetSpacing()[0] * cells[0] < 270;
  const brdf::TableLayout layout = vtkBRDFTableImage::LayoutFor(cells, reciprocal);
  const vtkBRDFTableImage::Grid grid(layout);
  for (int k = 0; k < 3; ++k)
  {
    const double most = 1e-6 * grid.Spacing[k];
    const double first = image->GetOrigin()[k] + image->GetExtent()[2 * k] * image->GetSpacing()[k];
    if (!(std::abs(image->GetSpacing()[k] - grid.Spacing[k]) < most && std::abs(first - grid.Origin[k]) < most))
    {
      Refuse("not in half/difference coordinates",
             "spacing " + Text(image->GetSpacing()),
             "spacing " + Text(grid.Spacing) + " from " + Text(grid.Origin) + ", as of vtkBRDFTabulate");
    }
  }
  return layout;
}
}

vtkBRDFFromTable::vtkBRDFFromTable()
{
  this->SetNumberOfInputPorts(1);
}

vtkBRDFFromTable::~vtkBRDFFromTable() = default;

int vtkBRDFFromTable::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkBRDFFromTable::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars)
  {
    Refuse("no values", "no active point scalars", "f_r in 1/sr");
  }
  brdf::TableData data;
  data.layout = LayoutOf(image);
  const int components = scalars->GetNumberOfComponents();
  data.channels = vtkBRDFArrays::ChannelsOf(image->GetFieldData(), components, "image of a table");
  const std::size_t cells = data.layout.cells();
  data.values.resize(cells * static_cast<std::size_t>(components));
  data.valid.assign(cells, brdf::stateByte(brdf::CellState::Measured));
  vtkDataArray* valid = image->GetPointData()->GetArray("valid");
  std::vector<double> tuple(static_cast<std::size_t>(components));
  for (std::size_t i = 0; i < cells; ++i)
  {
    scalars->GetTuple(static_cast<vtkIdType>(i), tuple.data());
    for (std::size_t c = 0; c < tuple.size(); ++c)
    {
      data.values[c * cells + i] = tuple[c];
    }
    if (valid && valid->GetTuple1(static_cast<vtkIdType>(i)) == 0)
    {
      data.valid[i] = brdf::stateByte(brdf::CellState::Invalid);
    }
  }
  vtkBRDF::GetData(outputs)->SetBrdf(std::make_shared<brdf::TableBrdf>(std::move(data), this->Description));
  return 1;
}

bool vtkBRDFFromTable::GetDirections(int phiD,
                                     int thetaD,
                                     int thetaH,
                                     bool reciprocal,
                                     vtkDoubleArray* wi,
                                     vtkDoubleArray* wo)
{
  const int cells[3] = { phiD, thetaD, thetaH };
  brdf::TableLayout layout;
  try
  {
    layout = vtkBRDFTableImage::LayoutFor(cells, reciprocal);
  }
  catch (const brdf::Error&)
  {
    return false;
  }
  const brdf::TableDirections directions(layout);
  brdf::DirectionPairBuffer<double> pairs;
  for (vtkDoubleArray* array : { wi, wo })
  {
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(layout.cells()));
  }
  constexpr std::size_t kBlock = 4096;
  for (std::size_t first = 0; first < layout.cells(); first += kBlock)
  {
    const std::size_t length = std::min(kBlock, layout.cells() - first);
    directions.directions(first, length, pairs);
    const auto views = pairs.view();
    for (std::size_t i = 0; i < length; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        wi->SetTypedComponent(static_cast<vtkIdType>(first + i), k, views.wi[k][i]);
        wo->SetTypedComponent(static_cast<vtkIdType>(first + i), k, views.wo[k][i]);
      }
    }
  }
  return true;
}

void vtkBRDFFromTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Description: " << this->Description << "\n";
}
