#ifndef vtkBRDFLobeSamples_h
#define vtkBRDFLobeSamples_h
#include "vtkBRDFChannelAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

class vtkPolyData;

/**
 * @class vtkBRDFLobeSamples
 * @brief Measured samples as points on the lobe that they belong to
 *
 * Input port 0 is a measured BRDF, port 1 (optional) a model of it. Samples whose incident direction lies within an
 * angle of the one asked for become points, each as far from the origin as its transformed value. Samples of BRDFs that
 * do not depend on turns about the normal are turned to the incident azimuth; those of reciprocal ones count with light
 * and viewer exchanged, too.
 *
 * Point data: "value" (f_r of the channel, 1/sr), "transformed" (the length), and with a model "residual", the
 * transformed value of the model at the sample's own directions less that of the sample (the active scalar).
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFLobeSamples : public vtkBRDFChannelAlgorithm
{
public:
  static vtkBRDFLobeSamples* New();
  vtkTypeMacro(vtkBRDFLobeSamples, vtkBRDFChannelAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkPolyData* GetOutput();

  ///@{
  /** Polar angle of the incident direction from the normal, [0, 90) degrees; default 45. */
  vtkSetMacro(ThetaI, double);
  vtkGetMacro(ThetaI, double);
  ///@}

  ///@{
  /** Azimuth of the incident direction, degrees; default 0. */
  vtkSetMacro(PhiI, double);
  vtkGetMacro(PhiI, double);
  ///@}

  ///@{
  /** How far a sample's incident direction may lie from it: degrees, 0 to 180, default 2. */
  vtkSetMacro(Within, double);
  vtkGetMacro(Within, double);
  ///@}

  ///@{
  /** Of more points every second, fourth... is kept; default 20000. */
  vtkSetClampMacro(MaximumPoints, int, 1, 100000000);
  vtkGetMacro(MaximumPoints, int);
  ///@}

  ///@{
  /** Of the lengths: "none" (default), "cuberoot", "log" or "logfloor", as vtkBRDFLobe has them. */
  vtkSetMacro(Transform, std::string);
  vtkGetMacro(Transform, std::string);
  ///@}

  ///@{
  /** Where "logfloor" begins, 1/sr, above 0; default 1e-3. */
  vtkSetMacro(Floor, double);
  vtkGetMacro(Floor, double);
  ///@}

  ///@{
  /** Of the last execution: samples within the angle, kept or not; the smallest angle of a sample's incident direction
   * from the one asked for, degrees; the largest length, and the largest |residual|. */
  vtkIdType GetNumberFound() const { return this->NumberFound; }
  double GetNearest() const { return this->Nearest; }
  double GetMaximumLength() const { return this->MaximumLength; }
  double GetMaximumResidual() const { return this->MaximumResidual; }
  ///@}

protected:
  vtkBRDFLobeSamples();
  ~vtkBRDFLobeSamples() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFLobeSamples(const vtkBRDFLobeSamples&) = delete;
  void operator=(const vtkBRDFLobeSamples&) = delete;

  double ThetaI = 45;
  double PhiI = 0;
  double Within = 2;
  int MaximumPoints = 20000;
  std::string Transform = "none";
  double Floor = 1e-3;
  vtkIdType NumberFound = 0;
  double Nearest = 180;
  double MaximumLength = 0;
  double MaximumResidual = 0;
};
#endif
