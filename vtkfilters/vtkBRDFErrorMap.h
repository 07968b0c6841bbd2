#ifndef vtkBRDFErrorMap_h
#define vtkBRDFErrorMap_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

class vtkImageData;

/**
 * @class vtkBRDFErrorMap
 * @brief Where two BRDFs differ: a map over two angles
 *
 * Input port 0 is A (a fit, say), port 1 is B (the reference). The output is an image whose points lie at
 * round angles, in degrees, 0 to 90 along both axes. Point data: "error", the mean over the angles within half an
 * interval of the point (the active scalar), and "count", the pairs of directions times channels there; where it is 0
 * there is no value.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFErrorMap : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFErrorMap* New();
  vtkTypeMacro(vtkBRDFErrorMap, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkImageData* GetOutput();

  ///@{
  /** "difference" (A - B, 1/sr), "absolute" (1/sr, default), "relative" (to B), "log" (of ln(1 + f cos theta_i)) or
   * "cuberoot" (of the cube root of f cos theta_i). */
  vtkSetMacro(Measure, std::string);
  vtkGetMacro(Measure, std::string);
  ///@}

  ///@{
  /** "theta_i,theta_o" (default) or "theta_h,theta_d". */
  vtkSetMacro(Axes, std::string);
  vtkGetMacro(Axes, std::string);
  ///@}

  ///@{
  /** "luminance" (default), "rgb", a channel number from 0, or a wavelength such as "550nm". */
  vtkSetMacro(Channel, std::string);
  vtkGetMacro(Channel, std::string);
  ///@}

  ///@{
  /** How spectral data become colours: the illuminant (a CIE name such as "A" or "F11", or the path of a spectrum;
   * empty, the default: D65, and equal energy for luminance), the observer ("2", the default, or "10" degrees) and the
   * adaptation to D65 ("bradford", the default, or "none"). See brdf::ColourNames. */
  vtkSetMacro(Illuminant, std::string);
  vtkGetMacro(Illuminant, std::string);
  vtkSetMacro(Observer, std::string);
  vtkGetMacro(Observer, std::string);
  vtkSetMacro(Adaptation, std::string);
  vtkGetMacro(Adaptation, std::string);
  ///@}

  ///@{
  /** Intervals from 0 to 90 degrees along each axis, 1 to 1000; default 90. SuggestIntervals gives 45 on a table's
   * samples and 9 on few scattered ones, so that enough of them meet in a point. */
  vtkSetClampMacro(Intervals, int, 1, 1000);
  vtkGetMacro(Intervals, int);
  int SuggestIntervals();
  ///@}

  ///@{
  /** Pairs of directions at each point where the filter chooses them; default 36. */
  vtkSetMacro(Azimuths, int);
  vtkGetMacro(Azimuths, int);
  ///@}

  ///@{
  /** Compare on B's own samples where it has any, else on A's (default); off: always at chosen directions. */
  vtkSetMacro(OnSamples, bool);
  vtkGetMacro(OnSamples, bool);
  vtkBooleanMacro(OnSamples, bool);
  ///@}

  ///@{
  /** Of the last execution: the mean over everything counted, the largest absolute value of a point, the quantity with
   * its unit, and where the directions came from. */
  double GetOverallMean() const { return this->OverallMean; }
  double GetLargest() const { return this->Largest; }
  std::string GetQuantity() const { return this->Quantity; }
  std::string GetSampling() const { return this->Sampling; }
  ///@}

protected:
  vtkBRDFErrorMap();
  ~vtkBRDFErrorMap() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request,
                         vtkInformationVector** inputs,
                         vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFErrorMap(const vtkBRDFErrorMap&) = delete;
  void operator=(const vtkBRDFErrorMap&) = delete;

  std::string Measure = "absolute";
  std::string Axes = "theta_i,theta_o";
  std::string Channel = "luminance";
  std::string Illuminant;
  std::string Observer = "2";
  std::string Adaptation = "bradford";
  int Intervals = 90;
  int Azimuths = 36;
  bool OnSamples = true;
  double OverallMean = 0;
  double Largest = 0;
  std::string Quantity;
  std::string Sampling;
};
#endif
