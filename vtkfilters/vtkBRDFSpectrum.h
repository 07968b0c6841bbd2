#ifndef vtkBRDFSpectrum_h
#define vtkBRDFSpectrum_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <array>  // For std::array
#include <vector> // For std::vector

class vtkTable;

/**
 * @class vtkBRDFSpectrum
 * @brief The values of spectral data over the wavelength at given pairs of directions, as a table
 *
 * A row a wavelength: "wavelength" (nm), a column of f_r (1/sr) for each pair, named by its angles, not a number where
 * the data have no value there, and "standard error of ..." where the data carry it.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFSpectrum : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFSpectrum* New();
  vtkTypeMacro(vtkBRDFSpectrum, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTable* GetOutput();

  ///@{
  /** The pairs of directions, polar angles below 90 and azimuths in degrees; none: theta_i = theta_o = 45, phi_o = 180,
   * the mirror direction. */
  void AddDirections(double thetaI, double phiI, double thetaO, double phiO);
  void RemoveAllDirections();
  ///@}

protected:
  vtkBRDFSpectrum();
  ~vtkBRDFSpectrum() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFSpectrum(const vtkBRDFSpectrum&) = delete;
  void operator=(const vtkBRDFSpectrum&) = delete;

  std::vector<std::array<double, 4>> Pairs;
};
#endif
