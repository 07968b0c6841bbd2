#include "vtkBRDFMicrosurface.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"

#include <brdf/simulate/SurfaceKinds.h>

#include <limits>

vtkStandardNewMacro(vtkBRDFMicrosurface);
vtkBRDFMicrosurface::vtkBRDFMicrosurface() = default;
vtkBRDFMicrosurface::~vtkBRDFMicrosurface() = default;

void vtkBRDFMicrosurface::SetSurface(std::shared_ptr<const brdf::MadeSurface> value)
{
  if (value == this->Surface)
  {
    return;
  }
  this->Surface = std::move(value);
  this->FieldData->Initialize();
  if (this->Surface)
  {
    vtkNew<vtkStringArray> description;
    description->SetName("vtkBRDFMicrosurface");
    description->InsertNextValue(this->GetDescription());
    this->FieldData->AddArray(description);
    for (const brdf::SurfaceFact& fact : this->Surface->facts)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName((fact.unit == "1" ? fact.name : fact.name + " (" + fact.unit + ")").c_str());
      array->InsertNextValue(fact.value);
      this->FieldData->AddArray(array);
    }
  }
  this->Modified();
}

std::string vtkBRDFMicrosurface::GetDescription() const
{
  return this->Surface ? this->Surface->surface.description : std::string();
}

std::string vtkBRDFMicrosurface::GetShape() const
{
  static const char* const names[] = { "height field", "mesh", "spheres" };
  return this->Surface ? names[this->Surface->surface.shape.index()] : std::string();
}

int vtkBRDFMicrosurface::GetNumberOfFacts() const
{
  return this->Surface ? static_cast<int>(this->Surface->facts.size()) : 0;
}

std::string vtkBRDFMicrosurface::GetFactName(int fact) const
{
  return fact >= 0 && fact < this->GetNumberOfFacts() ? this->Surface->facts[fact].name : std::string();
}

double vtkBRDFMicrosurface::GetFactValue(int fact) const
{
  return fact >= 0 && fact < this->GetNumberOfFacts() ? this->Surface->facts[fact].value
                                                      : std::numeric_limits<double>::quiet_NaN();
}

std::string vtkBRDFMicrosurface::GetFactUnit(int fact) const
{
  return fact >= 0 && fact < this->GetNumberOfFacts() ? this->Surface->facts[fact].unit : std::string();
}

double vtkBRDFMicrosurface::GetFact(const std::string& name) const
{
  for (int fact = 0; fact < this->GetNumberOfFacts(); ++fact)
  {
    if (this->Surface->facts[fact].name == name)
    {
      return this->Surface->facts[fact].value;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void vtkBRDFMicrosurface::Initialize()
{
  this->Superclass::Initialize();
  this->Surface.reset();
}

void vtkBRDFMicrosurface::ShallowCopy(vtkDataObject* source)
{
  this->Superclass::ShallowCopy(source);
  if (auto* other = vtkBRDFMicrosurface::SafeDownCast(source))
  {
    this->Surface = other->Surface;
  }
  this->Modified();
}

void vtkBRDFMicrosurface::DeepCopy(vtkDataObject* source)
{
  this->Superclass::DeepCopy(source);
  if (auto* other = vtkBRDFMicrosurface::SafeDownCast(source))
  {
    this->Surface = other->Surface; // immutable, so shared
  }
  this->Modified();
}

vtkBRDFMicrosurface* vtkBRDFMicrosurface::GetData(vtkInformation* info)
{
  return info ? vtkBRDFMicrosurface::SafeDownCast(info->Get(DATA_OBJECT())) : nullptr;
}

vtkBRDFMicrosurface* vtkBRDFMicrosurface::GetData(vtkInformationVector* vector, int index)
{
  return vtkBRDFMicrosurface::GetData(vector->GetInformationObject(index));
}

void vtkBRDFMicrosurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Description: " << (this->Surface ? this->GetDescription() : "(none)") << "\n";
}
