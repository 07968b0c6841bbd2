#ifndef vtkSMBRDFNamesDomain_h
#define vtkSMBRDFNamesDomain_h
#include "vtkBRDFParaViewModule.h" // For export macro
#include "vtkSMStringListDomain.h"

/**
 * @class vtkSMBRDFNamesDomain
 * @brief Offers the names of a registry, those that plugins of BRDFLab add included
 *
 * In XML: <BRDFNamesDomain name="names" kind="metrics"/>, a kind of vtkBRDFRegistry; `first` (optional): names that
 * come before, separated by blanks.
 */
class VTKBRDFPARAVIEW_EXPORT vtkSMBRDFNamesDomain : public vtkSMStringListDomain
{
public:
  static vtkSMBRDFNamesDomain* New();
  vtkTypeMacro(vtkSMBRDFNamesDomain, vtkSMStringListDomain);

protected:
  vtkSMBRDFNamesDomain() = default;
  ~vtkSMBRDFNamesDomain() override = default;
  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

private:
  vtkSMBRDFNamesDomain(const vtkSMBRDFNamesDomain&) = delete;
  void operator=(const vtkSMBRDFNamesDomain&) = delete;
};
#endif
