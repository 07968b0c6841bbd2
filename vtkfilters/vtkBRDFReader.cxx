#include "vtkBRDFReader.h"

#include "vtkBRDF.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <brdf/base/Text.h>
#include <brdf/measured/Format.h>

vtkStandardNewMacro(vtkBRDFReader);

namespace
{
void AddTexts(vtkFieldData* fields, const char* name, const std::vector<std::string>& texts)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : texts)
  {
    array->InsertNextValue(text);
  }
  fields->AddArray(array);
}

void AddCount(vtkFieldData* fields, const char* name, std::uint64_t count)
{
  vtkNew<vtkTypeInt64Array> array;
  array->SetName(name);
  array->InsertNextValue(static_cast<vtkTypeInt64>(count));
  fields->AddArray(array);
}
}

vtkBRDFReader::vtkBRDFReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkBRDFReader::~vtkBRDFReader() = default;

int vtkBRDFReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  std::vector<std::string> items;
  for (const std::string_view item : brdf::split(this->Assumptions, ' '))
  {
    if (!item.empty())
    {
      items.emplace_back(item);
    }
  }
  brdf::ReadResult result = brdf::readMeasured(this->FileName, brdf::parseReadOptions(items));
  vtkBRDF* output = vtkBRDF::GetData(outputs);
  output->SetBrdf(std::move(result.brdf));
  vtkFieldData* fields = output->GetFieldData();
  AddTexts(fields, "format", { result.report.format });
  AddTexts(fields, "assumptions", result.report.assumptions);
  AddTexts(fields, "warnings", result.report.warnings);
  AddCount(fields, "samples", result.report.samples);
  AddCount(fields, "invalid", result.report.invalid);
  AddCount(fields, "negative", result.report.negative);
  AddCount(fields, "notFinite", result.report.notFinite);
  AddCount(fields, "belowHorizon", result.report.belowHorizon);
  return 1;
}

void vtkBRDFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Assumptions: " << this->Assumptions << "\n";
}
