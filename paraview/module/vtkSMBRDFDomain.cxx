#include "vtkSMBRDFDomain.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMInputProperty.h"
#include "vtkSMSourceProxy.h"

vtkStandardNewMacro(vtkSMBRDFDomain);

namespace
{
bool Makes(const std::string& type, vtkSMSourceProxy* source, unsigned int port)
{
  source->CreateOutputPorts();
  vtkPVDataInformation* data = source->GetDataInformation(port);
  return data && data->GetDataSetType() == VTK_DATA_OBJECT &&
         data->GetAttributeInformation(vtkDataObject::FIELD)->GetArrayInformation(type.c_str());
}
} // namespace

int vtkSMBRDFDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  if (const char* type = element->GetAttribute("data_type"))
  {
    this->DataType = type;
  }
  return this->Superclass::ReadXMLAttributes(property, element);
}

int vtkSMBRDFDomain::IsInDomain(vtkSMProperty* property)
{
  auto* input = vtkSMInputProperty::SafeDownCast(property);
  if (!input)
  {
    return 0;
  }
  for (unsigned int i = 0; i < input->GetNumberOfUncheckedProxies(); ++i)
  {
    auto* source = vtkSMSourceProxy::SafeDownCast(input->GetUncheckedProxy(i));
    if (!source || !Makes(this->DataType, source, input->GetUncheckedOutputPortForConnection(i)))
    {
      return 0;
    }
  }
  return 1;
}
