#include "vtkBRDFAlbedo.h"

#include "vtkBRDFArrays.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/sampling/DirectionalAlbedo.h>
#include <brdf/sampling/SampledBrdf.h>
#include <brdf/view/ChannelChoice.h>

#include <algorithm>
#include <cmath>

using namespace vtkBRDFArrays;

vtkStandardNewMacro(vtkBRDFAlbedo);
vtkBRDFAlbedo::vtkBRDFAlbedo() = default;
vtkBRDFAlbedo::~vtkBRDFAlbedo() = default;

int vtkBRDFAlbedo::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

vtkTable* vtkBRDFAlbedo::GetOutput()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkBRDFAlbedo::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!std::isfinite(this->PhiI))
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "out of range", "phi_i", brdf::formatNumber(this->PhiI), "a finite number of degrees" });
  }
  const brdf::ChannelChoice choice = this->ChosenChannels(inputs);
  const std::vector<std::string> names = brdf::channelNames(choice.brdf->channels());
  const brdf::BrdfPointer sampled = brdf::withSampler(choice.brdf);
  const auto points = static_cast<std::size_t>(this->Points);
  constexpr double highest = brdf::kPi / 2 - 1e-4;
  std::vector<double> theta;
  std::vector<brdf::Albedo> albedos;
  for (int k = 0; k <= this->Intervals; ++k)
  {
    const double angle = std::min(brdf::radians(90.0 * k / this->Intervals), highest);
    theta.push_back(brdf::degrees(angle));
    albedos.push_back(brdf::directionalAlbedo(*sampled, angle, points, brdf::radians(this->PhiI)));
  }
  vtkTable* table = vtkTable::GetData(outputs);
  table->AddColumn(Numbers("theta_i", theta));
  for (const bool error : { false, true })
  {
    for (std::size_t c = 0; c < names.size(); ++c)
    {
      std::vector<double> column;
      for (const brdf::Albedo& albedo : albedos)
      {
        column.push_back(error ? albedo.error[c] : albedo.value[c]);
      }
      table->AddColumn(Numbers((error ? "standard error of " : "") + names[c], column));
    }
  }
  const brdf::Albedo whole = brdf::bihemisphericalAlbedo(*sampled, 8 * points);
  table->GetFieldData()->AddArray(Numbers("bihemispherical", whole.value));
  table->GetFieldData()->AddArray(Numbers("standard error of bihemispherical", whole.error));
  return 1;
}

void vtkBRDFAlbedo::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Intervals: " << this->Intervals << "\n"
     << indent << "PhiI: " << this->PhiI << "\n"
     << indent << "Points: " << this->Points << "\n";
}
