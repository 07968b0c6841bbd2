#include "Pictures.h"

#include <vtkBRDFAuditView.h>
#include <vtkDoubleArray.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

namespace brdf::app {
namespace {

template <class Array>
vtkNew<Array> column(vtkTable* table, const std::string& name) {
  vtkNew<Array> array;
  array->SetName(name.c_str());
  table->AddColumn(array);
  return array;
}

const char* stateOf(const Check& check) {
  if (!check.passed) return "failed";
  return check.note.starts_with("skipped") ? "skipped" : check.declared ? "declared" : "passed";
}

}  // namespace

void drawAudit(const AuditPicture& request) {
  vtkNew<vtkTable> checks;
  const auto model = column<vtkStringArray>(checks, "model"), name = column<vtkStringArray>(checks, "check"),
             state = column<vtkStringArray>(checks, "state"), at = column<vtkStringArray>(checks, "at");
  const auto worst = column<vtkDoubleArray>(checks, "worst"), allowed = column<vtkDoubleArray>(checks, "allowed");
  for (const Audit& audit : request.audits)
    for (const Check& check : audit.checks) {
      model->InsertNextValue(shortName(audit.name));
      name->InsertNextValue(check.name);
      state->InsertNextValue(stateOf(check));
      worst->InsertNextValue(check.worst);
      allowed->InsertNextValue(check.allowed);
      at->InsertNextValue(check.note.empty() || check.note.starts_with("a property") ? check.at : check.note);
    }
  vtkNew<vtkBRDFAuditView> view;
  view->SetChecks(checks);
  if (!request.albedo.degrees.empty()) {
    vtkNew<vtkTable> albedo;
    const auto add = [&](const std::string& title, const std::vector<double>& values) {
      vtkNew<vtkDoubleArray> array;
      array->SetName(title.c_str());
      for (const double value : values) array->InsertNextValue(value);
      albedo->AddColumn(array);
    };
    add("theta", request.albedo.degrees);
    for (std::size_t c = 0; c < request.albedo.channels.size(); ++c)
      add(request.albedo.channels[c], request.albedo.values[c]);
    view->SetAlbedo(albedo);
  }
  writeView(view, request.size, request.out);
}

}  // namespace brdf::app
