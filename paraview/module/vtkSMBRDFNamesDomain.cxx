#include "vtkSMBRDFNamesDomain.h"

#include "vtkBRDFRegistry.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkStringArray.h"

#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSMBRDFNamesDomain);

int vtkSMBRDFNamesDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  std::vector<std::string> all;
  if (const char* first = element->GetAttribute("first"))
  {
    std::istringstream words(first);
    for (std::string word; words >> word;)
    {
      all.push_back(word);
    }
  }
  const char* kind = element->GetAttribute("kind");
  vtkNew<vtkStringArray> names;
  if (!kind || !vtkBRDFRegistry::GetNames(kind, names))
  {
    vtkErrorMacro(<< "no registry is called \"" << (kind ? kind : "") << "\"");
    return 0;
  }
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    all.push_back(names->GetValue(i));
  }
  this->SetStrings(all);
  return this->vtkSMDomain::ReadXMLAttributes(property, element);
}
