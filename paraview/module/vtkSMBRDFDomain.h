#ifndef vtkSMBRDFDomain_h
#define vtkSMBRDFDomain_h
#include "vtkBRDFParaViewModule.h" // For export macro
#include "vtkSMDomain.h"

#include <string> // For std::string

/**
 * @class vtkSMBRDFDomain
 * @brief Enables a filter where its input is a BRDF, or another data object of ours, and nowhere else
 *
 * In XML: <BRDFDomain name="input_type"/> within an InputProperty, or with the attribute data_type, the name of another
 * class of data. ParaView's own DataTypeDomain knows types by number, and that of a vtkBRDF is vtkDataObject's; so it
 * is told by that type together with a field array called as its class, which every such object has (surfaces and
 * tables made of one pass the array on, but are of other types).
 */
class VTKBRDFPARAVIEW_EXPORT vtkSMBRDFDomain : public vtkSMDomain
{
public:
  static vtkSMBRDFDomain* New();
  vtkTypeMacro(vtkSMBRDFDomain, vtkSMDomain);

  /** 1 when every source connected to the input property makes a BRDF. */
  int IsInDomain(vtkSMProperty* property) override;

protected:
  vtkSMBRDFDomain() = default;
  ~vtkSMBRDFDomain() override = default;
  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

private:
  vtkSMBRDFDomain(const vtkSMBRDFDomain&) = delete;
  void operator=(const vtkSMBRDFDomain&) = delete;

  std::string DataType = "vtkBRDF";
};
#endif
