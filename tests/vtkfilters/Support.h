#pragma once
#include <brdf/material/LobeSum.h>
#include <brdf/material/TableBrdf.h>

#include <vtkBRDF.h>
#include <vtkBRDFAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

namespace brdf::test {

/// Collects VTK's errors instead of printing them.
class QuietOutput : public vtkOutputWindow {
 public:
  static QuietOutput* New() { VTK_STANDARD_NEW_BODY(QuietOutput); }
  vtkTypeMacro(QuietOutput, vtkOutputWindow);
  void DisplayText(const char* text) override { collected += text; }
  std::string collected;
};

/// A material as a table of 20 x 20 x 20 cells, whose samples they are.
inline vtkSmartPointer<vtkBRDF> tabulated(const char* material) {
  auto data = vtkSmartPointer<vtkBRDF>::New();
  data->SetBrdf(TableBrdf::tabulate(*parseMaterialExpression(material), {20, 20, 20}));
  return data;
}

/// While one lives, errors are expected and collected.
class ExpectErrors {
 public:
  ExpectErrors() : previous_(vtkOutputWindow::GetInstance()), verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkOutputWindow::SetInstance(output_);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~ExpectErrors() {
    vtkOutputWindow::SetInstance(previous_);
    vtkLogger::SetStderrVerbosity(verbosity_);
  }
  const std::string& text() const { return output_->collected; }

 private:
  vtkSmartPointer<vtkOutputWindow> previous_;
  vtkLogger::Verbosity verbosity_;
  vtkNew<QuietOutput> output_;
};

/// How often an algorithm has executed since.
class Executions {
 public:
  explicit Executions(vtkAlgorithm* algorithm) {
    callback_->SetClientData(&count_);
    callback_->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    algorithm->AddObserver(vtkCommand::StartEvent, callback_);
  }
  Executions(const Executions&) = delete;
  int count() const { return count_; }

 private:
  vtkNew<vtkCallbackCommand> callback_;
  int count_ = 0;
};

using Pixel = std::array<int, 3>;
inline Pixel pixelAt(vtkImageData* image, int x, int y) {
  const auto* p = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
  return {p[0], p[1], p[2]};
}

}  // namespace brdf::test
