#ifndef vtkBRDFCells_h
#define vtkBRDFCells_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

class vtkImageData;

/**
 * @class vtkBRDFCells
 * @brief The cells that a table or grid has, as an image: nothing is resampled
 *
 * A point is a cell. x runs along the grid's first axis, y along its second, z along all others: for a table phi_d,
 * theta_d and theta_h; for a grid whose outgoing axes come first, a slice of z is one incident direction. Origin and
 * spacing are in degrees (theta_h: sqrt(theta_h / 90 degrees)) where the axis has equal steps, and count indices where
 * it has not; the field data say which.
 *
 * Point data: "value" (f_r in 1/sr, one component a channel, the active scalars; 0 in invalid cells), "state" (unsigned
 * char: 0 invalid, 1 measured, 2 extrapolated) and, where known, "standardError" (as value; NaN where unknown). Field
 * data: the strings "axes" and "units", three each, and "parametrisation".
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFCells : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFCells* New();
  vtkTypeMacro(vtkBRDFCells, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkImageData* GetOutput();

protected:
  vtkBRDFCells();
  ~vtkBRDFCells() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request,
                         vtkInformationVector** inputs,
                         vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFCells(const vtkBRDFCells&) = delete;
  void operator=(const vtkBRDFCells&) = delete;
};
#endif
