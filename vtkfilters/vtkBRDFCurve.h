#ifndef vtkBRDFCurve_h
#define vtkBRDFCurve_h
#include "vtkBRDFChannelAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

class vtkTable;

/**
 * @class vtkBRDFCurve
 * @brief The values of a BRDF along an angle, and the measured samples beside that line, as tables
 *
 * Output port 0, a row a point: "angle" (degrees, ascending; in equal steps, and closer by the mirror and retro
 * directions), the values (a column for each channel, named after it: "value", or "red", "green", "blue", or "550 nm";
 * not a number where there is no value or a direction is below the horizon), "standard error of ..." where the data
 * carry it (1 standard deviation, not a number where unknown), and "state" (0 no value, 1 measured or computed, 2
 * filled or extrapolated, 3 below the horizon).
 *
 * Output port 1, a row a sample: "angle", the values and their standard errors likewise, and "distance" (degrees) of
 * the sample's directions from the line.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFCurve : public vtkBRDFChannelAlgorithm
{
public:
  static vtkBRDFCurve* New();
  vtkTypeMacro(vtkBRDFCurve, vtkBRDFChannelAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Port 0 (default): the values; 1: the samples. */
  vtkTable* GetOutput(int port = 0);

  ///@{
  /** "theta_o" (default): the polar angle of the viewer, -90 to 90 degrees, in the plane of the azimuth phi_i + Phi,
   * which is the positive side; "phi": phi_o - phi_i, -180 to 180; "theta_h", "theta_d": 0 to 90; "phi_d": -180 to 180.
   */
  vtkSetMacro(Angle, std::string);
  vtkGetMacro(Angle, std::string);
  ///@}

  ///@{
  /** Fixed angle theta_i, the light's polar angle, where the curve needs it; degrees, default 45. */
  vtkSetMacro(ThetaI, double);
  vtkGetMacro(ThetaI, double);
  ///@}

  ///@{
  /** Fixed angle phi_i, the light's azimuth, where the curve needs it; degrees, default 0. */
  vtkSetMacro(PhiI, double);
  vtkGetMacro(PhiI, double);
  ///@}

  ///@{
  /** Fixed angle theta_o, the viewer's polar angle, where the curve needs it; degrees, default 45. */
  vtkSetMacro(ThetaO, double);
  vtkGetMacro(ThetaO, double);
  ///@}

  ///@{
  /** Fixed angle phi_o - phi_i, the viewer's azimuth from the light's, 180 being the side of the mirror direction,
   * where the curve needs it; degrees, default 180. */
  vtkSetMacro(Phi, double);
  vtkGetMacro(Phi, double);
  ///@}

  ///@{
  /** Fixed angle theta_h, the half vector's polar angle, where the curve needs it; degrees, default 0. */
  vtkSetMacro(ThetaH, double);
  vtkGetMacro(ThetaH, double);
  ///@}

  ///@{
  /** Fixed angle phi_h, the half vector's azimuth, where the curve needs it; degrees, default 0. */
  vtkSetMacro(PhiH, double);
  vtkGetMacro(PhiH, double);
  ///@}

  ///@{
  /** Fixed angle theta_d, the light's polar angle from the half vector, where the curve needs it; degrees, default
   * 0. */
  vtkSetMacro(ThetaD, double);
  vtkGetMacro(ThetaD, double);
  ///@}

  ///@{
  /** Fixed angle phi_d, the light's azimuth about the half vector, where the curve needs it; degrees, default 90. */
  vtkSetMacro(PhiD, double);
  vtkGetMacro(PhiD, double);
  ///@}

  ///@{
  /** Equal intervals between the ends, 1 to 100,000; default 360. */
  vtkSetMacro(Intervals, int);
  vtkGetMacro(Intervals, int);
  ///@}

  ///@{
  /** "f" (default): f_r, 1/sr; "f_cos": f_r cos(theta_o), the radiant intensity that a goniometer draws, per incident
   * flux. */
  vtkSetMacro(Quantity, std::string);
  vtkGetMacro(Quantity, std::string);
  ///@}

  ///@{
  /** Samples count as beside the line up to this distance of either direction, degrees; default 0.5; 0: none. */
  vtkSetMacro(SampleTolerance, double);
  vtkGetMacro(SampleTolerance, double);
  ///@}

  /** The fixed angles of the last execution, for people. */
  std::string GetFixedAngles() const { return this->FixedAngles; }

  ///@{
  /** Of the last execution: rows of port 0 by state (see above), and samples beyond the 20,000 nearest. */
  vtkIdType GetNumberOfPoints(int state) const { return state >= 0 && state < 4 ? this->Counts[state] : 0; }
  vtkIdType GetNumberOfSamplesLeftOut() const { return this->LeftOut; }
  ///@}

protected:
  vtkBRDFCurve();
  ~vtkBRDFCurve() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFCurve(const vtkBRDFCurve&) = delete;
  void operator=(const vtkBRDFCurve&) = delete;

  std::string Angle = "theta_o";
  double ThetaI = 45;
  double PhiI = 0;
  double ThetaO = 45;
  double Phi = 180;
  double ThetaH = 0;
  double PhiH = 0;
  double ThetaD = 0;
  double PhiD = 90;
  int Intervals = 360;
  std::string Quantity = "f";
  double SampleTolerance = 0.5;
  std::string FixedAngles;
  vtkIdType Counts[4] = { 0, 0, 0, 0 };
  vtkIdType LeftOut = 0;
};
#endif
