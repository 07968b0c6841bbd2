#ifndef vtkBRDFAuditView_h
#define vtkBRDFAuditView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkBRDFView.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkTable;

/**
 * @class vtkBRDFAuditView
 * @brief A picture of an audit: what passed, what is declared, what failed
 *
 * Several models: a matrix of models by checks, each cell coloured by its outcome, with its worst value, and what is
 * allowed at the head of the column. One model: its checks with their worst cases, and above them the directional
 * albedo over the angle of the light with the white furnace's bound, where it is given.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFAuditView : public vtkBRDFView
{
public:
  static vtkBRDFAuditView* New();
  vtkTypeMacro(vtkBRDFAuditView, vtkBRDFView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** One row a check, with the columns "model", "check" and "state" ("passed", "declared", "failed" or "skipped"),
   * "worst", "allowed" (infinite where nothing is demanded) and "at" (where the worst case is). */
  void SetChecks(vtkTable* checks);
  vtkTable* GetChecks();
  ///@}

  ///@{
  /** The column "theta" (degrees of the light) and beside it one column a channel: the share of the light that is
   * reflected. Drawn for a single model only; may be null. */
  void SetAlbedo(vtkTable* albedo);
  vtkTable* GetAlbedo();
  ///@}

protected:
  vtkBRDFAuditView();
  ~vtkBRDFAuditView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFAuditView(const vtkBRDFAuditView&) = delete;
  void operator=(const vtkBRDFAuditView&) = delete;

  struct Frame;
  void AddMatrix(const Frame& frame);
  void AddList(const Frame& frame);
  void AddLegend(int width, int text);

  vtkSmartPointer<vtkTable> Checks;
  vtkSmartPointer<vtkTable> Albedo;
};
#endif
