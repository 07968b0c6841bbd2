#include "vtkBRDFReader.h"

#include "vtkBRDF.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/io/Container.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/io/LoadXml.h>

#include <algorithm>
#include <filesystem>

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
  if (!std::filesystem::exists(this->FileName))
  {
    throw brdf::Error(brdf::Error::Kind::File, { "no such file", this->FileName, {}, {} });
  }
  const std::string which = this->Entry.empty() ? "" : "#" + this->Entry;
  brdf::LoadedMaterial result = brdf::loadMaterial(this->FileName + which, brdf::parseReadOptions(items));
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

int vtkBRDFReader::CanReadFile(const std::string& fileName)
{
  try
  {
    const std::string head = brdf::readFileHead(fileName, 8192);
    const auto size = std::filesystem::file_size(fileName);
    return brdf::Container::recognises(head.substr(0, 16)) || brdf::isMaterialXml(head) ||
           std::ranges::any_of(brdf::allFormats(),
                               [&](const brdf::Format& format) { return format.recognise(head, size) > 0; });
  }
  catch (const std::exception&)
  {
    return 0; // no file, or one that cannot be opened
  }
}

void vtkBRDFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Entry: " << this->Entry << "\n";
  os << indent << "Assumptions: " << this->Assumptions << "\n";
}
