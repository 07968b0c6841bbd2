#ifndef vtkSMBRDFDomain_h
#define vtkSMBRDFDomain_h
#include "vtkBRDFParaViewModule.h"  // For export macro
#include "vtkSMDomain.h"

/**
 * @class vtkSMBRDFDomain
 * @brief Enables a filter where its input is a BRDF, and nowhere else
 *
 * In XML: <BRDFDomain name="input_type"/> within an InputProperty. ParaView's own DataTypeDomain knows types by number,
 * and that of a vtkBRDF is vtkDataObject's; so it is told by that type together with the field array "vtkBRDF", which
 * every vtkBRDF has (surfaces and tables made of one pass the array on, but are of other types).
 */
class VTKBRDFPARAVIEW_EXPORT vtkSMBRDFDomain : public vtkSMDomain {
 public:
  static vtkSMBRDFDomain* New();
  vtkTypeMacro(vtkSMBRDFDomain, vtkSMDomain);

  /** 1 when every source connected to the input property makes a BRDF. */
  int IsInDomain(vtkSMProperty* property) override;

 protected:
  vtkSMBRDFDomain() = default;
  ~vtkSMBRDFDomain() override = default;

 private:
  vtkSMBRDFDomain(const vtkSMBRDFDomain&) = delete;
  void operator=(const vtkSMBRDFDomain&) = delete;
};
#endif
