#ifndef vtkBRDFTabulate_h
#define vtkBRDFTabulate_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

class vtkImageData;

/**
 * @class vtkBRDFTabulate
 * @brief A BRDF as an image in half/difference coordinates, in MERL's order
 *
 * For stock VTK filters and volume rendering. Points are the centres of the table's cells: x = phi_d (degrees), y =
 * theta_d (degrees), z = sqrt(theta_h / 90 degrees), fine near the mirror direction. An anisotropic BRDF is cut at
 * phi_h = 0.
 *
 * Point data: "value" (f_r in 1/sr, one component a channel, double, the active scalars) and "valid" (0 below the
 * horizon and where the BRDF has no value; the values are then 0). Field data: of spectral BRDFs "wavelengths" (nm).
 * vtkBRDFFromTable is the way back.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFTabulate : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFTabulate* New();
  vtkTypeMacro(vtkBRDFTabulate, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkImageData* GetOutput();

  ///@{
  /** Cells along phi_d, theta_d and theta_h, 2 to 1024 each; default 180 x 90 x 90: 8 bytes a value,
   * so 35 MB in RGB by default. */
  vtkSetVector3Macro(Cells, int);
  vtkGetVector3Macro(Cells, int);
  ///@}

  ///@{
  /** Whether phi_d spans 180 degrees only; default on. That assumes reciprocity, f(phi_d) = f(phi_d + 180), as MERL's
   * tables do. */
  vtkSetMacro(Reciprocal, bool);
  vtkGetMacro(Reciprocal, bool);
  vtkBooleanMacro(Reciprocal, bool);
  ///@}

protected:
  vtkBRDFTabulate();
  ~vtkBRDFTabulate() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request,
                         vtkInformationVector** inputs,
                         vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFTabulate(const vtkBRDFTabulate&) = delete;
  void operator=(const vtkBRDFTabulate&) = delete;

  int Cells[3] = { 180, 90, 90 };
  bool Reciprocal = true;
};
#endif
