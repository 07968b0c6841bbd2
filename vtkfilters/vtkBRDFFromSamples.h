#ifndef vtkBRDFFromSamples_h
#define vtkBRDFFromSamples_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

/**
 * @class vtkBRDFFromSamples
 * @brief A BRDF from measurements at directions of any order: a vtkTable of one row each
 *
 * Columns: "wi" and "wo", the directions to the light and to the viewer, three components of any length but 0, normal
 * +z, tangent +x; "value", f_r in 1/sr without the cosine, one component a channel (1 is monochrome, 3 is RGB unless
 * the table's field data hold "wavelengths": see vtkBRDFFromTable); and, where there are any, "valid" (0: no
 * measurement) and "uncertainty" (as "value", one standard deviation, 1/sr). Rows below the horizon or not finite count
 * as invalid. Between the samples the BRDF is interpolated; they themselves are what a fit looks at.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFFromSamples : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFFromSamples* New();
  vtkTypeMacro(vtkBRDFFromSamples, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Whether the surface may be turned about its normal, and mirrored; default on. */
  vtkSetMacro(Isotropic, bool);
  vtkGetMacro(Isotropic, bool);
  vtkBooleanMacro(Isotropic, bool);
  ///@}

  ///@{
  /** What GetDescription() of the BRDF says; default "samples". */
  vtkSetMacro(Description, std::string);
  vtkGetMacro(Description, std::string);
  ///@}

protected:
  vtkBRDFFromSamples();
  ~vtkBRDFFromSamples() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFFromSamples(const vtkBRDFFromSamples&) = delete;
  void operator=(const vtkBRDFFromSamples&) = delete;

  bool Isotropic = true;
  std::string Description = "samples";
};
#endif
