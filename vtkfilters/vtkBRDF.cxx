#include "vtkBRDF.h"

#include "vtkBRDFArrays.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"

#include <brdf/material/LobeSum.h>
#include <brdf/material/SampleSet.h>

#include <exception>

vtkStandardNewMacro(vtkBRDF);
vtkBRDF::vtkBRDF() = default;
vtkBRDF::~vtkBRDF() = default;

namespace
{
void AddFieldArray(vtkFieldData* fields, const std::string& name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  for (double value : values)
  {
    array->InsertNextValue(value);
  }
  fields->AddArray(array);
}

void DescribeInFieldData(const brdf::Brdf& brdf, vtkFieldData* fields)
{
  vtkNew<vtkStringArray> description;
  description->SetName("vtkBRDF");
  description->InsertNextValue(brdf.description());
  fields->AddArray(description);
  if (const auto* sum = dynamic_cast<const brdf::LobeSum*>(&brdf))
  {
    for (std::size_t i = 0; i < sum->lobes().size(); ++i)
    {
      const brdf::Lobe& lobe = sum->lobes()[i];
      const std::string prefix = std::to_string(i) + "." + lobe.model->name() + ".";
      AddFieldArray(fields, prefix + "scale", lobe.scale);
      for (std::size_t p = 0; p < lobe.parameters.size(); ++p)
      {
        AddFieldArray(fields, prefix + lobe.model->parameters()[p].name, lobe.parameters[p]);
      }
    }
  }
}
}

void vtkBRDF::SetBrdf(std::shared_ptr<const brdf::Brdf> value)
{
  if (value == this->Brdf)
  {
    return;
  }
  this->Brdf = std::move(value);
  this->FieldData->Initialize();
  if (this->Brdf)
  {
    DescribeInFieldData(*this->Brdf, this->FieldData);
  }
  this->Modified();
}

std::string vtkBRDF::GetDescription() const
{
  return this->Brdf ? this->Brdf->description() : std::string();
}

int vtkBRDF::GetNumberOfChannels() const
{
  return this->Brdf ? static_cast<int>(this->Brdf->channels().count()) : 0;
}

std::string vtkBRDF::GetChannelKind() const
{
  if (!this->Brdf)
  {
    return {};
  }
  switch (this->Brdf->channels().kind)
  {
    case brdf::Channels::Kind::Rgb:
      return "rgb";
    case brdf::Channels::Kind::Spectral:
      return "spectral";
    default:
      return "monochrome";
  }
}

double vtkBRDF::GetWavelength(int channel) const
{
  const auto* wavelengths = this->Brdf ? &this->Brdf->channels().wavelengths : nullptr;
  return wavelengths && channel >= 0 && static_cast<std::size_t>(channel) < wavelengths->size()
           ? (*wavelengths)[channel]
           : 0;
}

vtkIdType vtkBRDF::GetNumberOfSamples() const
{
  const brdf::SampleSet* samples = this->Brdf ? this->Brdf->samples() : nullptr;
  return samples ? static_cast<vtkIdType>(samples->count()) : 0;
}

double vtkBRDF::Evaluate(const double wi[3], const double wo[3], int channel)
{
  if (channel < 0 || channel >= this->GetNumberOfChannels())
  {
    vtkErrorMacro("channel " << channel << " does not exist; the BRDF has " << this->GetNumberOfChannels());
    return 0;
  }
  try
  {
    return this->Brdf->evaluate({ wi[0], wi[1], wi[2] }, { wo[0], wo[1], wo[2] })[channel];
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

bool vtkBRDF::Evaluate(vtkDataArray* wi, vtkDataArray* wo, vtkDataArray* values, vtkDataArray* valid)
{
  if (!this->Brdf || !wi || !wo || !values)
  {
    vtkErrorMacro("Evaluate needs a BRDF and the arrays wi, wo and values");
    return false;
  }
  try
  {
    const int channels = this->GetNumberOfChannels();
    const auto pairs = vtkBRDFArrays::DirectionPairs(wi, wo);
    const auto count = static_cast<vtkIdType>(pairs.size());
    std::vector<double> planar(static_cast<std::size_t>(count) * channels);
    std::vector<std::uint8_t> flags(count);
    this->Brdf->evaluateParallel(pairs.view(), planar.data(), flags.data());
    values->SetNumberOfComponents(channels);
    values->SetNumberOfTuples(count);
    for (int channel = 0; channel < channels; ++channel)
    {
      for (vtkIdType i = 0; i < count; ++i)
      {
        values->SetComponent(i, channel, planar[channel * count + i]);
      }
    }
    if (valid)
    {
      valid->SetNumberOfComponents(1);
      valid->SetNumberOfTuples(count);
      for (vtkIdType i = 0; i < count; ++i)
      {
        valid->SetComponent(i, 0, flags[i]);
      }
    }
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
}

void vtkBRDF::Initialize()
{
  this->Superclass::Initialize();
  this->Brdf.reset();
}

void vtkBRDF::ShallowCopy(vtkDataObject* source)
{
  this->Superclass::ShallowCopy(source);
  if (auto* other = vtkBRDF::SafeDownCast(source))
  {
    this->Brdf = other->Brdf;
  }
  this->Modified();
}

void vtkBRDF::DeepCopy(vtkDataObject* source)
{
  this->Superclass::DeepCopy(source);
  if (auto* other = vtkBRDF::SafeDownCast(source))
  {
    this->Brdf = other->Brdf; // immutable, so shared
  }
  this->Modified();
}

vtkBRDF* vtkBRDF::GetData(vtkInformation* info)
{
  return info ? vtkBRDF::SafeDownCast(info->Get(DATA_OBJECT())) : nullptr;
}

vtkBRDF* vtkBRDF::GetData(vtkInformationVector* vector, int index)
{
  return vtkBRDF::GetData(vector->GetInformationObject(index));
}

void vtkBRDF::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Description: " << (this->Brdf ? this->Brdf->description() : "(none)") << "\n";
}
