#ifndef vtkBRDFFillHoles_h
#define vtkBRDFFillHoles_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

/**
 * @class vtkBRDFFillHoles
 * @brief Fills the invalid cells of a table or grid by a named method and marks them extrapolated
 *
 * Input port 0: a vtkBRDF with cells. Input port 1: for the method "model", the BRDF that the values come from, with as
 * many channels. The output has the same cells; measured ones and those below the horizon are untouched, and nothing is
 * filled from what was filled. vtkBRDFCells shows measured, extrapolated and invalid cells apart. The field data of the
 * input are passed on, with the counts "filledCells" and "remainingCells" and the string "fillMethod".
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFFillHoles : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFFillHoles* New();
  vtkTypeMacro(vtkBRDFFillHoles, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where the value of an invalid cell comes from:
   * - "none": nowhere, holes stay
   * - "reciprocity": the pair with light and viewer exchanged, interpolated
   * - "symmetry": the mirror image of the pair (y of both directions negated), interpolated
   * - "nearest" (default): the measured cell that is the fewest steps along the axes away
   * - "model": the BRDF on input port 1
   *
   * An unknown name is an error that lists them.
   */
  vtkSetMacro(Method, std::string);
  vtkGetMacro(Method, std::string);
  ///@}

  ///@{
  /** After an update: cells that were invalid and are now extrapolated; cells above the horizon that are invalid
   * still. */
  vtkGetMacro(NumberOfFilledCells, vtkIdType);
  vtkGetMacro(NumberOfRemainingCells, vtkIdType);
  ///@}

protected:
  vtkBRDFFillHoles();
  ~vtkBRDFFillHoles() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFFillHoles(const vtkBRDFFillHoles&) = delete;
  void operator=(const vtkBRDFFillHoles&) = delete;

  std::string Method = "nearest";
  vtkIdType NumberOfFilledCells = 0;
  vtkIdType NumberOfRemainingCells = 0;
};
#endif
