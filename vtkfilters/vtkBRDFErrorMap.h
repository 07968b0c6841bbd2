#ifndef vtkBRDFErrorMap_h
#define vtkBRDFErrorMap_h
#include "vtkBRDFChannelAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkImageData;
class vtkTable;
namespace brdf
{
class Distribution;
struct ErrorMap;
}

/**
 * @class vtkBRDFErrorMap
 * @brief Where two BRDFs differ: a map over two angles, how often, and the worst directions
 *
 * Input port 0 is A (a fit, say), port 1 is B (the reference).
 *
 * Output port 0 is an image whose points lie at round angles in degrees, or over the hemisphere's disk from -1 to 1
 * along both axes. Point data: "error", the average over the pairs of directions within half an interval of the point
 * (the active scalar), "count", the pairs there times channels (where it is 0 there is no value), and for several
 * channels "channel_error", one component each.
 *
 * Output port 1 is a table of the errors of single pairs, one row a bin: "low", "high", "count" and "share" (of all
 * pairs by the solid angles that they stand for; 1 in all). The first bin holds what is smaller, too.
 *
 * Output port 2 is a table of the worst pairs, the worst first, an eighteenth of the map apart (5 of 90 degrees):
 * "error", "theta_i", "phi_i", "theta_o", "phi_o" (degrees), "a_0".. and "b_0".. (1/sr, one a channel), "x" and "y" (on
 * the map).
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFErrorMap : public vtkBRDFChannelAlgorithm
{
public:
  static vtkBRDFErrorMap* New();
  vtkTypeMacro(vtkBRDFErrorMap, vtkBRDFChannelAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkImageData* GetOutput();
  vtkTable* GetHistogram();
  vtkTable* GetWorst();

  ///@{
  /** A metric of brdf::findMetric, as `brdf compare` knows them ("rms", "log", "cuberoot", "relative:0.01"...), or
   * "difference" or "absolute" (default), short for the signed and the absolute mean of "rms". */
  vtkSetMacro(Measure, std::string);
  vtkGetMacro(Measure, std::string);
  ///@}

  ///@{
  /** How the residuals of the metric become one number: "rms", "absolute" (mean magnitude), "signed" (mean), or
   * "automatic" (default): "rms" where the measure is a metric. */
  vtkSetMacro(Average, std::string);
  vtkGetMacro(Average, std::string);
  ///@}

  ///@{
  /** "theta_i,theta_o" (default), "theta_h,theta_d", "theta_d,phi_d", or "hemisphere": the view directions of one
   * incident direction. */
  vtkSetMacro(Axes, std::string);
  vtkGetMacro(Axes, std::string);
  ///@}

  ///@{
  /** Of the hemisphere: polar angle of the incident direction, [0, 90) degrees; default 45. */
  vtkSetMacro(ThetaI, double);
  vtkGetMacro(ThetaI, double);
  ///@}

  ///@{
  /** Of the hemisphere: azimuth of the incident direction, degrees; default 0. */
  vtkSetMacro(PhiI, double);
  vtkGetMacro(PhiI, double);
  ///@}

  ///@{
  /** Of the hemisphere: the disk, "equal-area" (default), r = sqrt(2) sin(theta / 2), or "orthographic", r =
   * sin(theta). */
  vtkSetMacro(Projection, std::string);
  vtkGetMacro(Projection, std::string);
  ///@}

  ///@{
  /** Of the hemisphere: how far a sample's incident direction may lie from the one asked for, degrees; default 2.5. */
  vtkSetMacro(SampleAngle, double);
  vtkGetMacro(SampleAngle, double);
  ///@}

  ///@{
  /** Intervals along each axis, 1 to 1000; default 90. SuggestIntervals gives 45 on a table's samples and 9 on few
   * scattered ones, so that enough of them meet in a point, and twice as many for the hemisphere. */
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
  /** Where the two are compared: "samples" (B's own where it has any, else A's), "chosen" (at directions that the
   * filter chooses), or "automatic" (default): samples where there are any, but chosen ones on the hemisphere. */
  vtkSetMacro(Directions, std::string);
  vtkGetMacro(Directions, std::string);
  ///@}

  ///@{
  /** How many of the worst pairs port 2 has at most; default 10. */
  vtkSetClampMacro(NumberOfWorst, int, 0, 10000);
  vtkGetMacro(NumberOfWorst, int);
  ///@}

  ///@{
  /** How many bins the histogram of port 1 has; default 60. */
  vtkSetClampMacro(NumberOfBins, int, 1, 10000);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /** Of the last execution: the average over everything counted, the same for channel `index` alone, the largest
   * absolute value of a point, the quantity with its unit, that of a single pair, where the directions came from, the
   * pairs compared, and those left out because A or B has no value there. */
  double GetOverallMean() const { return this->OverallMean; }
  int GetNumberOfChannels() const;
  double GetChannelMean(int index) const;
  double GetLargest() const { return this->Largest; }
  std::string GetQuantity() const { return this->Quantity; }
  std::string GetPairQuantity() const { return this->PairQuantity; }
  std::string GetSampling() const { return this->Sampling; }
  vtkIdType GetNumberOfPairs() const { return this->NumberOfPairs; }
  vtkIdType GetNumberLeftOut() const { return this->NumberLeftOut; }
  bool IsSigned() const { return this->Signed; }
  ///@}

  /** The error that `share` (0 to 1) of the pairs, by weight, do not exceed. 0 when there are none. */
  double GetQuantile(double share) const;

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

  void FillImage(vtkInformationVector* outputs, const brdf::ErrorMap& map);
  void FillHistogram(vtkInformationVector* outputs, const brdf::ErrorMap& map);
  void FillWorst(vtkInformationVector* outputs, const brdf::ErrorMap& map);

  std::string Measure = "absolute";
  std::string Average = "automatic";
  std::string Axes = "theta_i,theta_o";
  double ThetaI = 45;
  double PhiI = 0;
  std::string Projection = "equal-area";
  double SampleAngle = 2.5;
  int Intervals = 90;
  int Azimuths = 36;
  std::string Directions = "automatic";
  int NumberOfWorst = 10;
  int NumberOfBins = 60;
  double OverallMean = 0;
  double Largest = 0;
  bool Signed = false;
  vtkIdType NumberOfPairs = 0;
  vtkIdType NumberLeftOut = 0;
  std::string Quantity;
  std::string PairQuantity;
  std::string Sampling;
  std::vector<double> ChannelMeans;
  std::unique_ptr<brdf::Distribution> Errors;
};
#endif
