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
    const auto theta = column<vtkDoubleArray>(albedo, "theta");
    for (const double degrees : request.albedo.degrees) theta->InsertNextValue(degrees);
    for (std::size_t c = 0; c < request.albedo.channels.size(); ++c) {
      const auto values = column<vtkDoubleArray>(albedo, request.albedo.channels[c]);
      for (const double value : request.albedo.values[c]) values->InsertNextValue(value);
    }
    view->SetAlbedo(albedo);
  }
  writeView(view, request.size, request.out);
}

}  // namespace brdf::app
