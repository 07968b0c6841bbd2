#ifndef vtkBRDFFit_h
#define vtkBRDFFit_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

class vtkTable;

/**
 * @class vtkBRDFFit
 * @brief Fits a sum of lobes to a measured BRDF
 *
 * Input: a vtkBRDF with samples. Output port 0: the fit, a vtkBRDF; its field data has "error", "zeroModelError" (the
 * error of the model that answers 0 everywhere: what a fit has to beat), "samples", "seconds", "converged" and
 * "termination". Output port 1: a vtkTable, one row a fitted number: "lobe", "parameter", "channel" (-1: shared by
 * all), "value", "standardError" (NaN where it is not determined), "minimum", "maximum", "atBound", "fixed".
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFFit : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFFit* New();
  vtkTypeMacro(vtkBRDFFit, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The table of fitted numbers. */
  vtkTable* GetParameters();

  ///@{
  /** Lobes joined by '+', as in a material expression; parameters given there are starting values. Default
   * "Lambertian + GGX". */
  vtkSetMacro(Lobes, std::string);
  vtkGetMacro(Lobes, std::string);
  ///@}

  ///@{
  /** What is minimised, e.g. "rms" (default), "rms_cos", "log", "cuberoot"; an unknown name is an error that lists
   * them. */
  vtkSetMacro(Metric, std::string);
  vtkGetMacro(Metric, std::string);
  ///@}

  ///@{
  /** How the shape parameters are found; default "lm", Levenberg-Marquardt. */
  vtkSetMacro(Optimizer, std::string);
  vtkGetMacro(Optimizer, std::string);
  ///@}

  ///@{
  /** "native" (all of the target's, default), "luminance" or "rgb". */
  vtkSetMacro(Channels, std::string);
  vtkGetMacro(Channels, std::string);
  ///@}

  ///@{
  /** Each channel has a shape of its own; default off: one shape, one scale factor a channel. */
  vtkSetMacro(PerChannel, bool);
  vtkGetMacro(PerChannel, bool);
  vtkBooleanMacro(PerChannel, bool);
  ///@}

  ///@{
  /** Samples with theta_i or theta_o above are left out; degrees, default 90. */
  vtkSetMacro(MaximumTheta, double);
  vtkGetMacro(MaximumTheta, double);
  ///@}

  ///@{
  /** Relative change of the squared error that ends the search; default 1e-8. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Random starts besides the scanned one (default 0), and their seed. */
  vtkSetClampMacro(Starts, int, 0, 100000);
  vtkGetMacro(Starts, int);
  vtkSetClampMacro(Seed, int, 0, VTK_INT_MAX);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkBRDFFit();
  ~vtkBRDFFit() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFFit(const vtkBRDFFit&) = delete;
  void operator=(const vtkBRDFFit&) = delete;

  std::string Lobes = "Lambertian + GGX";
  std::string Metric = "rms";
  std::string Optimizer = "lm";
  std::string Channels = "native";
  bool PerChannel = false;
  double MaximumTheta = 90;
  double Tolerance = 1e-8;
  int Starts = 0;
  int Seed = 1;
};
#endif
