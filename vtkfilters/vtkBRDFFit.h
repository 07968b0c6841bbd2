#ifndef vtkBRDFFit_h
#define vtkBRDFFit_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

class vtkTable;

/**
 * @class vtkBRDFFit
 * @brief Fits a sum of lobes to a BRDF
 *
 * Input: a vtkBRDF of any kind. Output port 0: the fit, a vtkBRDF; its field data has "error", "zeroModelError" and
 * "constantModelError" (the errors of the model that answers 0 everywhere and of the best constant: what a fit has to
 * beat), "metricFormula", "sampling", "samples", "seconds", "converged", "termination", "notes" (one value each),
 * "degrees", "AIC", "BIC", and "crossValidationError" where it was asked for. Output port 1: a vtkTable, one row a
 * fitted number: "lobe", "parameter", "channel" (-1: shared by all), "value", "standardError" (NaN where it is not
 * determined), "minimum", "maximum", "atBound", "fixed". Output port 2: a vtkTable, one row a region of directions:
 * "region", "samples", "error", "share" (of the squared error), "meanDifference" (1/sr), "relativeMean". What they mean
 * is in docs/fitting.md.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFFit : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFFit* New();
  vtkTypeMacro(vtkBRDFFit, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The table of fitted numbers. */
  vtkTable* GetParameters();
  /** The table of residuals by region. */
  vtkTable* GetRegions();

  ///@{
  /** Lobes joined by '+', as in a material expression; parameters given there are starting values. Default
   * "Lambertian + GGX". */
  vtkSetMacro(Lobes, std::string);
  vtkGetMacro(Lobes, std::string);
  ///@}

  ///@{
  /** What is minimised, e.g. "rms" (default), "rms_cos", "ngan", "relative", "log", "cuberoot", "huber", or one with an
   * argument, as "formula:cbrt(f*cos_i)"; an unknown name is an error that lists them. */
  vtkSetMacro(Metric, std::string);
  vtkGetMacro(Metric, std::string);
  ///@}

  ///@{
  /** How the shape parameters are found; default "lm", Levenberg-Marquardt. */
  vtkSetMacro(Optimizer, std::string);
  vtkGetMacro(Optimizer, std::string);
  ///@}

  ///@{
  /** Where the target is looked at: "automatic" (default: its own samples where it has any, else "hemisphere"), "all",
   * "hemisphere" or "importance". */
  vtkSetMacro(Sampling, std::string);
  vtkGetMacro(Sampling, std::string);
  ///@}

  ///@{
  /** How many pairs of directions for "hemisphere" and "importance"; 0 (default): 221184 and 100000. */
  vtkSetClampMacro(NumberOfSamples, int, 0, 10000000);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /** Samples count by the solid angle of their cells; default off: all alike. */
  vtkSetMacro(SolidAngleWeights, bool);
  vtkGetMacro(SolidAngleWeights, bool);
  vtkBooleanMacro(SolidAngleWeights, bool);
  ///@}

  ///@{
  /** Samples count by 1 / variance: those of tables that carry standard errors, without the others
   * (docs/fitting.md); excludes SolidAngleWeights; default off. */
  vtkSetMacro(NoiseWeights, bool);
  vtkGetMacro(NoiseWeights, bool);
  vtkBooleanMacro(NoiseWeights, bool);
  ///@}

  ///@{
  /** Scale factors by linear least squares inside the search ("separable"), searched with the rest ("joint"), or the
   * first where the metric allows it ("automatic" (default)). */
  vtkSetMacro(Strategy, std::string);
  vtkGetMacro(Strategy, std::string);
  ///@}

  ///@{
  /** Parameters to hold and to tie, separated by ';': "ior=1.5; Ward.ay=ax". Empty by default. */
  vtkSetMacro(Constraints, std::string);
  vtkGetMacro(Constraints, std::string);
  ///@}

  ///@{
  /** Fits one lobe more at a time; default off. */
  vtkSetMacro(Progressive, bool);
  vtkGetMacro(Progressive, bool);
  vtkBooleanMacro(Progressive, bool);
  ///@}

  ///@{
  /** Parts of a cross-validation over blocks of directions, 2 to 100; default 0: none. */
  vtkSetClampMacro(CrossValidation, int, 0, 100);
  vtkGetMacro(CrossValidation, int);
  ///@}

  ///@{
  /** "native" (default), all channels of the target's, "luminance" or "rgb". */
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
  /** Random starts besides the scanned one; default 0. */
  vtkSetClampMacro(Starts, int, 0, 100000);
  vtkGetMacro(Starts, int);
  ///@}

  ///@{
  /** Of the random starts; the same seed gives the same fit; default 1. */
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
  std::string Sampling = "automatic";
  int NumberOfSamples = 0;
  bool SolidAngleWeights = false;
  bool NoiseWeights = false;
  std::string Strategy = "automatic";
  std::string Constraints;
  bool Progressive = false;
  int CrossValidation = 0;
  std::string Channels = "native";
  bool PerChannel = false;
  double MaximumTheta = 90;
  double Tolerance = 1e-8;
  int Starts = 0;
  int Seed = 1;
};
#endif
