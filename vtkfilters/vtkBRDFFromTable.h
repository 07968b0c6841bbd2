#ifndef vtkBRDFFromTable_h
#define vtkBRDFFromTable_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

class vtkDoubleArray;

/**
 * @class vtkBRDFFromTable
 * @brief A BRDF from an image in half/difference coordinates: the way back from vtkBRDFTabulate
 *
 * The input is a vtkImageData whose points are the cells that vtkBRDFTabulate describes: origin and spacing have to be
 * its (x = phi_d over 180 or 360 degrees, y = theta_d, z = sqrt(theta_h / 90 degrees)), which keeps an image of
 * something else from being taken for a BRDF. The active point scalars, any type of number, are f_r in 1/sr; one
 * component a channel: 1 is monochrome, 3 is RGB (linear sRGB) unless the field data hold an array "wavelengths" (nm,
 * ascending, one a component), which other numbers of components need. Cells where the point array "valid" is 0, or a
 * value is not finite, have no value. The table is looked up by interpolation.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFFromTable : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFFromTable* New();
  vtkTypeMacro(vtkBRDFFromTable, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** What GetDescription() of the BRDF says; default "table". */
  vtkSetMacro(Description, std::string);
  vtkGetMacro(Description, std::string);
  ///@}

  /**
   * Unit directions of the cells' centres in the order of the image's points, three components each, for filling a
   * table of one's own. Where one is below the horizon the cell needs no value. False for numbers of cells out of 2 to
   * 1024.
   */
  static bool GetDirections(int phiD, int thetaD, int thetaH, bool reciprocal, vtkDoubleArray* wi, vtkDoubleArray* wo);

protected:
  vtkBRDFFromTable();
  ~vtkBRDFFromTable() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFFromTable(const vtkBRDFFromTable&) = delete;
  void operator=(const vtkBRDFFromTable&) = delete;

  std::string Description = "table";
};
#endif
