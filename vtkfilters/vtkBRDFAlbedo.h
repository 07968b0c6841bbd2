#ifndef vtkBRDFAlbedo_h
#define vtkBRDFAlbedo_h
#include "vtkBRDFChannelAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

class vtkTable;

/**
 * @class vtkBRDFAlbedo
 * @brief The directional-hemispherical albedo of a BRDF over the polar angle of the light, as a table
 *
 * A row an angle: "theta_i" (degrees, 0 to 90 in equal steps; the last one 0.0057 degrees above the horizon), the
 * albedo (a column for each channel, named after it) and "standard error of ..." of each. Field data, one number a
 * channel: "bihemispherical" (the albedo under uniform light from the whole hemisphere) and "standard error of
 * bihemispherical". By quasi-Monte Carlo, see brdf::directionalAlbedo; the errors are those of the quadrature, not of
 * the data.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFAlbedo : public vtkBRDFChannelAlgorithm
{
public:
  static vtkBRDFAlbedo* New();
  vtkTypeMacro(vtkBRDFAlbedo, vtkBRDFChannelAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTable* GetOutput();

  ///@{
  /** Intervals from 0 to 90 degrees, 1 to 1000; default 36. */
  vtkSetClampMacro(Intervals, int, 1, 1000);
  vtkGetMacro(Intervals, int);
  ///@}

  ///@{
  /** Azimuth of the light for the directional albedo, degrees; default 0. */
  vtkSetMacro(PhiI, double);
  vtkGetMacro(PhiI, double);
  ///@}

  ///@{
  /** Points of the quadrature in each of its eight copies; 16 to 10,000,000, default 2048. The error falls about as
   * 1 / Points where the BRDF is smooth. */
  vtkSetClampMacro(Points, int, 16, 10000000);
  vtkGetMacro(Points, int);
  ///@}

protected:
  vtkBRDFAlbedo();
  ~vtkBRDFAlbedo() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFAlbedo(const vtkBRDFAlbedo&) = delete;
  void operator=(const vtkBRDFAlbedo&) = delete;

  int Intervals = 36;
  double PhiI = 0;
  int Points = 2048;
};
#endif
