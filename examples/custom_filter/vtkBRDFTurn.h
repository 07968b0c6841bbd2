#ifndef vtkBRDFTurn_h
#define vtkBRDFTurn_h
#include <vtkBRDFAlgorithm.h>

/**
 * @class vtkBRDFTurn
 * @brief Turns a BRDF about its normal
 *
 * Input and output: vtkBRDF. A filter of one's own: it derives from vtkBRDFAlgorithm, which does ports, pieces and
 * errors, and makes the output in RequestData.
 */
class vtkBRDFTurn : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFTurn* New();
  vtkTypeMacro(vtkBRDFTurn, vtkBRDFAlgorithm);

  ///@{
  /** Degrees, counter-clockwise seen from above; default 0. */
  vtkSetMacro(Angle, double);
  vtkGetMacro(Angle, double);
  ///@}

protected:
  vtkBRDFTurn();
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Angle = 0;
};
#endif
