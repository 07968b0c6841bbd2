#ifndef vtkBRDFHoleMap_h
#define vtkBRDFHoleMap_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

class vtkImageData;

/**
 * @class vtkBRDFHoleMap
 * @brief How many cells of a table or grid are measured, filled, invalid or below the horizon, over two of its axes
 *
 * A point of the image is a place on the two axes, numbered from 0 (origin 0, spacing 1); it counts the cells along all
 * other axes. Point data (64-bit integers): "measured" (the active scalars), "filled", "invalid" and "below the
 * horizon"; every cell is counted once. Field data: the strings "axes" (two names) and "layout", and "x", "y", "x
 * edges" and "y edges" (double: nodes of the places and bounds of their cells, degrees).
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFHoleMap : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFHoleMap* New();
  vtkTypeMacro(vtkBRDFHoleMap, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkImageData* GetOutput();

  ///@{
  /** Name of the axis along x, of the data's own layout. Empty (default): theta_h, theta_o or specular_theta, else
   * the first. */
  vtkSetMacro(XAxis, std::string);
  vtkGetMacro(XAxis, std::string);
  ///@}

  ///@{
  /** Name of the axis along y. Empty (default): theta_d beside theta_h, theta_i beside the others, else the second. */
  vtkSetMacro(YAxis, std::string);
  vtkGetMacro(YAxis, std::string);
  ///@}

  /** Of the last execution: all cells that are measured (0), filled (1), invalid (2), below the horizon (3). */
  vtkIdType GetNumberOfCells(int kind) const { return kind >= 0 && kind < 4 ? this->Counts[kind] : 0; }

protected:
  vtkBRDFHoleMap();
  ~vtkBRDFHoleMap() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request,
                         vtkInformationVector** inputs,
                         vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFHoleMap(const vtkBRDFHoleMap&) = delete;
  void operator=(const vtkBRDFHoleMap&) = delete;

  std::string XAxis;
  std::string YAxis;
  vtkIdType Counts[4] = { 0, 0, 0, 0 };
};
#endif
