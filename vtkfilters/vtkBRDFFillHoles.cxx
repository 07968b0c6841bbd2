#include "vtkBRDFFillHoles.h"

#include "vtkBRDF.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <brdf/material/FillHoles.h>

vtkStandardNewMacro(vtkBRDFFillHoles);

namespace
{
void AddCount(vtkFieldData* fields, const char* name, vtkIdType count)
{
  vtkNew<vtkTypeInt64Array> array;
  array->SetName(name);
  array->InsertNextValue(count);
  fields->AddArray(array);
}
}

vtkBRDFFillHoles::vtkBRDFFillHoles()
{
  this->SetNumberOfInputPorts(2);
}

vtkBRDFFillHoles::~vtkBRDFFillHoles() = default;

int vtkBRDFFillHoles::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkBRDFFillHoles::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const brdf::FillMethod method = brdf::fillMethod(this->Method);
  const auto input = GetInputBrdf(inputs);
  std::shared_ptr<const brdf::Brdf> model;
  if (method == brdf::FillMethod::Model)
  {
    model = GetInputBrdf(inputs, 1);
  }
  const brdf::FilledBrdf filled = brdf::fillHoles(input, method, model.get());
  this->NumberOfFilledCells = static_cast<vtkIdType>(filled.filled);
  this->NumberOfRemainingCells = static_cast<vtkIdType>(filled.remaining);

  vtkBRDF* output = vtkBRDF::GetData(outputs);
  output->ShallowCopy(vtkBRDF::GetData(inputs[0]));
  output->SetBrdf(filled.brdf);
  vtkFieldData* fields = output->GetFieldData();
  AddCount(fields, "filledCells", this->NumberOfFilledCells);
  AddCount(fields, "remainingCells", this->NumberOfRemainingCells);
  vtkNew<vtkStringArray> name;
  name->SetName("fillMethod");
  name->InsertNextValue(this->Method);
  fields->AddArray(name);
  return 1;
}

void vtkBRDFFillHoles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n"
     << indent << "NumberOfFilledCells: " << this->NumberOfFilledCells << "\n"
     << indent << "NumberOfRemainingCells: " << this->NumberOfRemainingCells << "\n";
}
