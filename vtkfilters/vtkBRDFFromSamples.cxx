#include "vtkBRDFFromSamples.h"

#include "vtkBRDF.h"
#include "vtkBRDFArrays.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <brdf/base/Error.h>
#include <brdf/material/ScatteredBrdf.h>

vtkStandardNewMacro(vtkBRDFFromSamples);

namespace
{
// The column of this name; where `components` is not 0 with so many.
vtkDataArray* Column(vtkTable* table, const char* name, int components, bool needed)
{
  auto* array = vtkDataArray::SafeDownCast(table->GetColumnByName(name));
  if (!array && !needed)
  {
    return nullptr;
  }
  if (!array || (components != 0 && array->GetNumberOfComponents() != components))
  {
    throw brdf::Error(
      brdf::Error::Kind::Value,
      { "wrong column",
        "table of samples",
        std::string(name) + (array ? ": " + std::to_string(array->GetNumberOfComponents()) + " components" : ": none"),
        components ? std::to_string(components) + " components of numbers" : "numbers" });
  }
  return array;
}

std::vector<double> Planar(vtkDataArray* array)
{
  const auto rows = static_cast<std::size_t>(array->GetNumberOfTuples());
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  std::vector<double> planes(rows * components), tuple(components);
  for (std::size_t i = 0; i < rows; ++i)
  {
    array->GetTuple(static_cast<vtkIdType>(i), tuple.data());
    for (std::size_t c = 0; c < components; ++c)
    {
      planes[c * rows + i] = tuple[c];
    }
  }
  return planes;
}

// Unit vectors; what has no direction stays 0 and is below the horizon.
void Directions(vtkDataArray* array, std::array<std::vector<double>, 3>& directions)
{
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    double d[3];
    array->GetTuple(i, d);
    const double length = std::hypot(d[0], d[1], d[2]);
    for (int k = 0; k < 3; ++k)
    {
      directions[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)] =
        length > 0 && std::isfinite(length) ? d[k] / length : 0;
    }
  }
}
}

vtkBRDFFromSamples::vtkBRDFFromSamples()
{
  this->SetNumberOfInputPorts(1);
}

vtkBRDFFromSamples::~vtkBRDFFromSamples() = default;

int vtkBRDFFromSamples::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

int vtkBRDFFromSamples::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkTable* table = vtkTable::GetData(inputs[0]);
  vtkDataArray* wi = Column(table, "wi", 3, true);
  vtkDataArray* wo = Column(table, "wo", 3, true);
  vtkDataArray* value = Column(table, "value", 0, true);
  vtkDataArray* valid = Column(table, "valid", 1, false);
  vtkDataArray* uncertainty = Column(table, "uncertainty", value->GetNumberOfComponents(), false);

  brdf::ScatteredSamples samples;
  samples.channels =
    vtkBRDFArrays::ChannelsOf(table->GetFieldData(), value->GetNumberOfComponents(), "table of samples");
  samples.isotropic = this->Isotropic;
  samples.pairs.resize(static_cast<std::size_t>(table->GetNumberOfRows()));
  Directions(wi, samples.pairs.wi);
  Directions(wo, samples.pairs.wo);
  samples.values = Planar(value);
  if (uncertainty)
  {
    samples.uncertainty = Planar(uncertainty);
  }
  if (valid)
  {
    samples.valid.resize(samples.pairs.size());
    for (std::size_t i = 0; i < samples.valid.size(); ++i)
    {
      samples.valid[i] = valid->GetTuple1(static_cast<vtkIdType>(i)) != 0;
    }
  }
  vtkBRDF::GetData(outputs)->SetBrdf(std::make_shared<brdf::ScatteredBrdf>(std::move(samples), this->Description));
  return 1;
}

void vtkBRDFFromSamples::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Isotropic: " << this->Isotropic << "\n" << indent << "Description: " << this->Description << "\n";
}
