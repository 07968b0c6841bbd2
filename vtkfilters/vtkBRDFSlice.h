#ifndef vtkBRDFSlice_h
#define vtkBRDFSlice_h
#include "vtkBRDFChannelAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

class vtkImageData;

/**
 * @class vtkBRDFSlice
 * @brief The values of a BRDF over a plane of directions, or over an angle and the wavelength, as an image
 *
 * A point of the image is the middle of a cell. Point data: "value" (f_r in 1/sr, one component a channel, the active
 * scalars; 0 where there is none) and "state" (unsigned char: 0 no value, 1 measured or computed, 2 filled or
 * extrapolated, 3 below the horizon). Field data: the strings "axes" and "units", two each, "channels" (a name for each
 * component), and "x" and "y" (double: the coordinates of columns and rows, degrees or nanometres).
 *
 * Origin and spacing are in degrees but where the x axis is warped (they count 90 degrees times
 * (angle / 90 degrees)^(1 / Warp)) or wavelengths are unevenly spaced (they count indices).
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFSlice : public vtkBRDFChannelAlgorithm
{
public:
  static vtkBRDFSlice* New();
  vtkTypeMacro(vtkBRDFSlice, vtkBRDFChannelAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkImageData* GetOutput();

  ///@{
  /** "theta_h,theta_d" (default; Burley 2012's image slices), "theta_i,theta_o", or an angle of vtkBRDFCurve and the
   * wavelength, "theta_o,wavelength": then all channels of spectral data, whatever the channel asked for. */
  vtkSetMacro(Axes, std::string);
  vtkGetMacro(Axes, std::string);
  ///@}

  ///@{
  /** Columns and rows, 1 to 8192 each; default 360 x 360. The rows of a wavelength slice are its wavelengths. */
  vtkSetVector2Macro(Cells, int);
  vtkGetVector2Macro(Cells, int);
  ///@}

  ///@{
  /** x is in equal steps of (angle / 90 degrees)^(1 / Warp): 1 (default) linear, 2 MERL's own spacing of theta_h. */
  vtkSetMacro(Warp, double);
  vtkGetMacro(Warp, double);
  ///@}

  ///@{
  /** Fixed angle phi_d, the light's azimuth about the half vector, where the axes need it; degrees, default 90. */
  vtkSetMacro(PhiD, double);
  vtkGetMacro(PhiD, double);
  ///@}

  ///@{
  /** Fixed angle phi_h, the half vector's azimuth, where the axes need it; degrees, default 0. */
  vtkSetMacro(PhiH, double);
  vtkGetMacro(PhiH, double);
  ///@}

  ///@{
  /** Fixed angle phi_i, the light's azimuth, where the axes need it; degrees, default 0. */
  vtkSetMacro(PhiI, double);
  vtkGetMacro(PhiI, double);
  ///@}

  ///@{
  /** Fixed angle phi_o - phi_i, the viewer's azimuth from the light's, 180 being the side of the mirror direction,
   * where the axes need it; degrees, default 180. */
  vtkSetMacro(Phi, double);
  vtkGetMacro(Phi, double);
  ///@}

  ///@{
  /** Fixed angle theta_i, the light's polar angle, where the axes need it; degrees, default 45. */
  vtkSetMacro(ThetaI, double);
  vtkGetMacro(ThetaI, double);
  ///@}

  ///@{
  /** Fixed angle theta_o, the viewer's polar angle, where the axes need it; degrees, default 45. */
  vtkSetMacro(ThetaO, double);
  vtkGetMacro(ThetaO, double);
  ///@}

  ///@{
  /** Fixed angle theta_h, the half vector's polar angle, where the axes need it; degrees, default 0. */
  vtkSetMacro(ThetaH, double);
  vtkGetMacro(ThetaH, double);
  ///@}

  ///@{
  /** Fixed angle theta_d, the light's polar angle from the half vector, where the axes need it; degrees, default 0. */
  vtkSetMacro(ThetaD, double);
  vtkGetMacro(ThetaD, double);
  ///@}

  /** Takes all settings of another. */
  void CopySettings(vtkBRDFSlice* other);

  /** The fixed angles of the last execution, for people. */
  std::string GetFixedAngles() const { return this->FixedAngles; }

  ///@{
  /** Of the last execution: cells by state (see above), and the smallest and largest value above the horizon. */
  vtkIdType GetNumberOfCells(int state) const { return state >= 0 && state < 4 ? this->Counts[state] : 0; }
  double GetSmallest() const { return this->Smallest; }
  double GetLargest() const { return this->Largest; }
  ///@}

protected:
  vtkBRDFSlice();
  ~vtkBRDFSlice() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request,
                         vtkInformationVector** inputs,
                         vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFSlice(const vtkBRDFSlice&) = delete;
  void operator=(const vtkBRDFSlice&) = delete;

  struct Result;
  Result Compute(vtkInformationVector** inputs);

  std::string Axes = "theta_h,theta_d";
  int Cells[2] = { 360, 360 };
  double Warp = 1;
  double PhiD = 90;
  double PhiH = 0;
  double PhiI = 0;
  double Phi = 180;
  double ThetaI = 45;
  double ThetaO = 45;
  double ThetaH = 0;
  double ThetaD = 0;
  std::string FixedAngles;
  vtkIdType Counts[4] = { 0, 0, 0, 0 };
  double Smallest = 0;
  double Largest = 0;
};
#endif
