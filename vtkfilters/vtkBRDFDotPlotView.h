#ifndef vtkBRDFDotPlotView_h
#define vtkBRDFDotPlotView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkBRDFView.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkTable;

/**
 * @class vtkBRDFDotPlotView
 * @brief A picture that compares numbers of several series in several groups, such as the errors of many fits
 *
 * A dot plot (Cleveland and McGill 1984, "Graphical Perception", doi:10.1080/01621459.1984.10478080): one row a series,
 * group by group, and beside each other one panel a quantity, on a logarithmic axis. Numbers are written beside their
 * dots, those that look like the smallest of their
 * group in bold.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFDotPlotView : public vtkBRDFView
{
public:
  static vtkBRDFDotPlotView* New();
  vtkTypeMacro(vtkBRDFDotPlotView, vtkBRDFView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** One row a dot: text columns "group" and "series", and beside them one column of numbers a panel, named as the
   * panel is. A number that is not positive and finite has no dot: 0 is written as it is, anything else as a dash. */
  void SetTable(vtkTable* table);
  vtkTable* GetTable();
  ///@}

  ///@{
  /** A line below the title; empty by default. */
  vtkSetMacro(Note, std::string);
  vtkGetMacro(Note, std::string);
  ///@}

protected:
  vtkBRDFDotPlotView();
  ~vtkBRDFDotPlotView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFDotPlotView(const vtkBRDFDotPlotView&) = delete;
  void operator=(const vtkBRDFDotPlotView&) = delete;

  struct Rows;
  void AddPanel(const Rows& rows, vtkIdType column, double left, double right);

  vtkSmartPointer<vtkTable> Table;
  std::string Note;
};
#endif
