#ifndef vtkBRDFSource_h
#define vtkBRDFSource_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

/**
 * @class vtkBRDFSource
 * @brief Makes a BRDF from its one-line name
 *
 * The material is written as everywhere in BRDFLab: an expression such as "(0.3,0.1,0.05)*Lambertian +
 * 0.04*GGX(alpha=0.2, ior=1.5)", a file of any supported format ("file#3" or "file#name" picks one of several), or
 * "preset:NAME".
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFSource : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFSource* New();
  vtkTypeMacro(vtkBRDFSource, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The material; default "Lambertian". */
  vtkSetMacro(Material, std::string);
  vtkGetMacro(Material, std::string);
  ///@}

protected:
  vtkBRDFSource();
  ~vtkBRDFSource() override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFSource(const vtkBRDFSource&) = delete;
  void operator=(const vtkBRDFSource&) = delete;

  std::string Material = "Lambertian";
};
#endif
