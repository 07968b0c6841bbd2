#include "vtkBRDFSpectrum.h"

#include "vtkBRDFArrays.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>
#include <brdf/view/ValueErrors.h>

#include <cmath>
#include <limits>

using namespace vtkBRDFArrays;

vtkStandardNewMacro(vtkBRDFSpectrum);
vtkBRDFSpectrum::vtkBRDFSpectrum() = default;
vtkBRDFSpectrum::~vtkBRDFSpectrum() = default;

int vtkBRDFSpectrum::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

vtkTable* vtkBRDFSpectrum::GetOutput()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(0));
}

void vtkBRDFSpectrum::AddDirections(double thetaI, double phiI, double thetaO, double phiO)
{
  this->Pairs.push_back({ thetaI, phiI, thetaO, phiO });
  this->Modified();
}

void vtkBRDFSpectrum::RemoveAllDirections()
{
  this->Pairs.clear();
  this->Modified();
}

int vtkBRDFSpectrum::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const auto brdf = GetInputBrdf(inputs);
  const brdf::Channels& channels = brdf->channels();
  if (channels.kind != brdf::Channels::Kind::Spectral)
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "values over the wavelength", "input port 0", brdf->description(), "spectral data" });
  }
  auto pairs = this->Pairs;
  if (pairs.empty())
  {
    pairs.push_back({ 45, 0, 45, 180 });
  }
  brdf::DirectionPairBuffer<double> directions;
  std::vector<std::string> names;
  for (const auto& [thetaI, phiI, thetaO, phiO] : pairs)
  {
    for (const double theta : { thetaI, thetaO })
    {
      if (!(theta >= 0 && theta < 90))
      {
        throw brdf::Error(brdf::Error::Kind::Value,
                          { "out of range", "polar angle", brdf::formatNumber(theta), "[0, 90) degrees" });
      }
    }
    directions.push(brdf::fromSpherical(brdf::radians(thetaI), brdf::radians(phiI)),
                    brdf::fromSpherical(brdf::radians(thetaO), brdf::radians(phiO)));
    names.push_back("in " + brdf::formatNumber(thetaI) + "\u00b0, " + brdf::formatNumber(phiI) + "\u00b0, out " +
                    brdf::formatNumber(thetaO) + "\u00b0, " + brdf::formatNumber(phiO) + "\u00b0");
  }
  std::vector<double> values(pairs.size() * channels.count()), errors;
  std::vector<std::uint8_t> valid(pairs.size());
  brdf->evaluateParallel(directions.view(), values.data(), valid.data());
  if (const brdf::ValueErrors known(*brdf); known.knownOfValues())
  {
    errors.resize(values.size());
    known.ofValues(directions.view(), errors.data());
  }
  vtkTable* table = vtkTable::GetData(outputs);
  table->AddColumn(Numbers("wavelength", channels.wavelengths));
  for (const bool error : { false, true })
  {
    const std::vector<double>& planes = error ? errors : values;
    for (std::size_t k = 0; k < pairs.size() && !planes.empty(); ++k)
    {
      std::vector<double> column(channels.count(), std::numeric_limits<double>::quiet_NaN());
      for (std::size_t c = 0; c < channels.count() && valid[k]; ++c)
      {
        column[c] = planes[c * pairs.size() + k];
      }
      table->AddColumn(Numbers((error ? "standard error of " : "") + names[k], column));
    }
  }
  return 1;
}

void vtkBRDFSpectrum::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Directions: " << this->Pairs.size() << "\n";
}
