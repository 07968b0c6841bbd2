#ifndef vtkBRDFWaveSource_h
#define vtkBRDFWaveSource_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <memory> // For std::shared_ptr
#include <string> // For std::string

class vtkDataArray;
class vtkStringArray;
namespace brdf
{
class WaveBrdf;
}

/**
 * @class vtkBRDFWaveSource
 * @brief Makes a BRDF of wave optics, with its Mueller matrices
 *
 * The model is written as behind "wave:" in materials, such as
 * "RayleighRice(wavelength=0.633, eta=1.5, spectrum=abc(a=0.01, b=5, c=2))"; docs/wave-optics.md lists the models and
 * the conventions of polarisation. The output is exact: nothing is tabulated.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFWaveSource : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFWaveSource* New();
  vtkTypeMacro(vtkBRDFWaveSource, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The model; default "RayleighRice". Lengths are micrometres, angles degrees. */
  vtkSetMacro(Model, std::string);
  vtkGetMacro(Model, std::string);
  ///@}

  /**
   * Mueller matrices (1/sr) of one channel for arrays of directions: `wi` to the light and `wo` to the viewer have
   * three components and as many tuples; `matrices` is resized to as many tuples of 16 components, row by row. Stokes
   * vectors are (Is + Ip, Is - Ip, I(s+p) - I(s-p), Ilcp - Ircp). Zero below the horizon. False after an error.
   */
  bool EvaluateMueller(vtkDataArray* wi, vtkDataArray* wo, vtkDataArray* matrices, int channel = 0);

  /** Names of the models there are. */
  static vtkStringArray* GetModelNames();

protected:
  vtkBRDFWaveSource();
  ~vtkBRDFWaveSource() override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFWaveSource(const vtkBRDFWaveSource&) = delete;
  void operator=(const vtkBRDFWaveSource&) = delete;

  std::string Model = "RayleighRice";
};
#endif
