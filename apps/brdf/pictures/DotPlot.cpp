#include "Pictures.h"

#include <vtkBRDFDotPlotView.h>
#include <vtkDoubleArray.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

namespace brdf::app {

void drawDotPlot(const DotPlotPicture& request) {
  vtkNew<vtkTable> table;
  const auto addNames = [&](const char* name, const std::vector<std::string>& values) {
    vtkNew<vtkStringArray> column;
    column->SetName(name);
    for (const std::string& value : values) column->InsertNextValue(value);
    table->AddColumn(column);
  };
  addNames("group", request.groups);
  addNames("series", request.series);
  for (const auto& [name, values] : request.panels) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name.c_str());
    for (const double value : values) column->InsertNextValue(value);
    table->AddColumn(column);
  }
  vtkNew<vtkBRDFDotPlotView> view;
  view->SetTable(table);
  view->SetTitle(request.title);
  view->SetNote(request.note);
  writeView(view, request.size, request.out);
}

}  // namespace brdf::app
