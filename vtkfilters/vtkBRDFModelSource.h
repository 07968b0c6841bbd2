#ifndef vtkBRDFModelSource_h
#define vtkBRDFModelSource_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <map>    // For std::map
#include <string> // For std::string

/**
 * @class vtkBRDFModelSource
 * @brief Makes a BRDF of one analytic lobe, parameter by parameter
 *
 * The same as the material expression "(r,g,b)*Model(name=value, ...)" of vtkBRDFSource, for programs whose parameters
 * are numbers on sliders. Models are those of vtkBRDFRegistry::GetNames("lobes"); docs/models.md lists their
 * parameters with units and bounds. A model or parameter that does not exist, or a value out of bounds, is an error of
 * the update.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFModelSource : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFModelSource* New();
  vtkTypeMacro(vtkBRDFModelSource, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Name of the lobe; default "GGX". */
  vtkSetMacro(Model, std::string);
  vtkGetMacro(Model, std::string);
  ///@}

  ///@{
  /** A parameter of the model; one that is not set has the model's default. GetParameter gives what is set or that
   * default; not a number where the model, or the parameter, does not exist. */
  void SetParameter(const std::string& name, double value);
  double GetParameter(const std::string& name);
  void RemoveAllParameters();
  ///@}

  ///@{
  /** Factor for red, green and blue (linear sRGB), not negative; default 1, 1, 1. The BRDF is RGB whatever they are. */
  vtkSetVector3Macro(Scale, double);
  vtkGetVector3Macro(Scale, double);
  ///@}

  ///@{
  /** Whether parameters that follow another in a material expression (the roughness across the tangent that along it)
   * take its value, whatever is set for them, which makes the lobe isotropic; default off. */
  vtkSetMacro(Tied, bool);
  vtkGetMacro(Tied, bool);
  vtkBooleanMacro(Tied, bool);
  ///@}

protected:
  vtkBRDFModelSource();
  ~vtkBRDFModelSource() override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFModelSource(const vtkBRDFModelSource&) = delete;
  void operator=(const vtkBRDFModelSource&) = delete;

  std::string Model = "GGX";
  std::map<std::string, double> Parameters;
  double Scale[3] = { 1, 1, 1 };
  bool Tied = false;
};
#endif
