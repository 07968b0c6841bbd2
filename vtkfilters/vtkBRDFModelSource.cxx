#include "vtkBRDFModelSource.h"

#include "vtkBRDF.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <brdf/base/Error.h>
#include <brdf/material/LobeSum.h>

vtkStandardNewMacro(vtkBRDFModelSource);

namespace
{
// One number for each parameter of the model.
std::vector<double> Values(const brdf::Model& model, const std::map<std::string, double>& given, bool tied)
{
  std::vector<double> values = model.defaults();
  for (const auto& [name, value] : given)
  {
    const std::size_t index = model.parameterIndex(name);
    model.checkBounds(index, value);
    values[index] = value;
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const brdf::Parameter& parameter = model.parameters()[i];
    if (!parameter.follows.empty() && (tied || !given.contains(parameter.name)))
    {
      values[i] = values[model.parameterIndex(parameter.follows)];
    }
  }
  return values;
}
}

vtkBRDFModelSource::vtkBRDFModelSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkBRDFModelSource::~vtkBRDFModelSource() = default;

void vtkBRDFModelSource::SetParameter(const std::string& name, double value)
{
  const auto [place, isNew] = this->Parameters.try_emplace(name, value);
  if (isNew || place->second != value)
  {
    place->second = value;
    this->Modified();
  }
}

double vtkBRDFModelSource::GetParameter(const std::string& name)
{
  try
  {
    const brdf::ModelPointer model = brdf::findModel(this->Model);
    const std::size_t index = model->parameterIndex(name);
    const auto place = this->Parameters.find(name);
    return place == this->Parameters.end() ? model->parameters()[index].defaultValue : place->second;
  }
  catch (const brdf::Error&)
  {
    return vtkMath::Nan();
  }
}

void vtkBRDFModelSource::RemoveAllParameters()
{
  this->Parameters.clear();
  this->Modified();
}

int vtkBRDFModelSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  brdf::Lobe lobe;
  lobe.model = brdf::findModel(this->Model);
  for (const double value : Values(*lobe.model, this->Parameters, this->Tied))
  {
    lobe.parameters.push_back({ value });
  }
  lobe.scale.assign(this->Scale, this->Scale + 3);
  vtkBRDF::GetData(outputs)->SetBrdf(
    std::make_shared<brdf::LobeSum>(std::vector<brdf::Lobe>{ std::move(lobe) }, brdf::Channels::rgb()));
  return 1;
}

void vtkBRDFModelSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << this->Model << "\n";
  for (const auto& [name, value] : this->Parameters)
  {
    os << indent << name << ": " << value << "\n";
  }
  os << indent << "Scale: " << this->Scale[0] << ", " << this->Scale[1] << ", " << this->Scale[2] << "\n";
  os << indent << "Tied: " << this->Tied << "\n";
}
