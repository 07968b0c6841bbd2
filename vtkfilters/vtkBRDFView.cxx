#include "vtkBRDFView.h"

#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFDrawing.h"
#include "vtkBRDFHeadlessRenderWindow.h"
#include "vtkBRDFVectorDevice.h"
#include "vtkContextActor.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

using namespace vtkBRDFDrawing;

namespace
{
// Each pixel of `half` is the mean of four of `image`, in display values: what the eye sees of thin lines on white.
void Halve(vtkImageData* image, vtkImageData* half)
{
  const int width = image->GetDimensions()[0] / 2;
  const int height = image->GetDimensions()[1] / 2;
  half->SetDimensions(width, height, 1);
  half->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < height; ++y)
  {
    const auto* low = static_cast<const unsigned char*>(image->GetScalarPointer(0, 2 * y, 0));
    const unsigned char* high = low + 3 * 2 * width;
    auto* out = static_cast<unsigned char*>(half->GetScalarPointer(0, y, 0));
    for (int x = 0; x < 3 * width; ++x)
    {
      const int i = 6 * (x / 3) + x % 3;
      out[x] = static_cast<unsigned char>((low[i] + low[i + 3] + high[i] + high[i + 3] + 2) / 4);
    }
  }
}
}

vtkBRDFView::vtkBRDFView()
  : Renderer(vtkSmartPointer<vtkRenderer>::New())
{
  this->Renderer->SetBackground(1, 1, 1);
}

vtkBRDFView::~vtkBRDFView()
{
  if (this->Window)
  {
    this->Window->RemoveRenderer(this->Renderer);
  }
}

vtkRenderer* vtkBRDFView::GetRenderer()
{
  return this->Renderer;
}

void vtkBRDFView::SetRenderWindow(vtkRenderWindow* window)
{
  if (window == this->Window)
  {
    return;
  }
  if (this->Window)
  {
    this->Window->RemoveRenderer(this->Renderer);
  }
  this->Window = window;
  if (window)
  {
    window->AddRenderer(this->Renderer);
  }
  this->Modified();
}

vtkRenderWindow* vtkBRDFView::GetRenderWindow()
{
  if (!this->Window)
  {
    vtkNew<vtkBRDFHeadlessRenderWindow> window;
    window->SetSize(900, 700);
    window->SetMultiSamples(0); // depth peeling draws nothing with them
    this->SetRenderWindow(window);
  }
  return this->Window;
}

void vtkBRDFView::SetSize(int width, int height)
{
  this->GetRenderWindow()->SetSize(std::clamp(width, 64, 8192), std::clamp(height, 64, 8192));
}

bool vtkBRDFView::Guarded(const std::function<void()>& action)
{
  this->ErrorText.clear();
  try
  {
    action();
    return true;
  }
  catch (const std::exception& error)
  {
    this->ErrorText = error.what();
    vtkErrorMacro(<< this->ErrorText);
    return false;
  }
}

void vtkBRDFView::DrawOrThrow()
{
  vtkRenderWindow* window = this->GetRenderWindow();
  if (auto* headless = vtkBRDFHeadlessRenderWindow::SafeDownCast(window); headless && !headless->IsAvailable())
  {
    throw brdf::Error(brdf::Error::Kind::Device, { headless->GetErrorText(), "render window", "", "" });
  }
  this->Renderer->RemoveAllViewProps();
  const int* size = window->GetSize();
  this->Build(size[0], size[1]);
  window->Render();
}

void vtkBRDFView::CaptureOrThrow(vtkImageData* image)
{
  // Headless pictures are drawn twice as large and averaged: smooth lines and edges.
  auto* headless = vtkBRDFHeadlessRenderWindow::SafeDownCast(this->GetRenderWindow());
  const std::array<int, 2> size = { this->Window->GetSize()[0], this->Window->GetSize()[1] };
  if (headless)
  {
    headless->SetSize(2 * size[0], 2 * size[1]);
  }
  const auto restore = [&](vtkRenderWindow* window) { window->SetSize(size[0], size[1]); };
  const std::unique_ptr<vtkRenderWindow, decltype(restore)> restorer(headless, restore);
  this->DrawOrThrow();
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(this->Window);
  capture->ReadFrontBufferOff();
  capture->ShouldRerenderOff();
  capture->Update();
  if (headless)
  {
    Halve(capture->GetOutput(), image);
  }
  else
  {
    image->ShallowCopy(capture->GetOutput());
  }
}

bool vtkBRDFView::Render()
{
  return this->Guarded([this] { this->DrawOrThrow(); });
}

bool vtkBRDFView::Capture(vtkImageData* image)
{
  return this->Guarded([this, image] { this->CaptureOrThrow(image); });
}

bool vtkBRDFView::WritePNG(const std::string& fileName)
{
  return this->Guarded(
    [this, &fileName]
    {
      brdf::AtomicFile file(fileName);
      vtkNew<vtkImageData> image;
      this->CaptureOrThrow(image);
      vtkNew<vtkPNGWriter> writer;
      writer->SetInputData(image);
      writer->SetFileName(file.temporaryPath().c_str());
      writer->Write();
      if (writer->GetErrorCode() != vtkErrorCode::NoError)
      {
        throw brdf::Error(
          brdf::Error::Kind::File,
          { "cannot write the picture", fileName, vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()), "" });
      }
      file.commit();
    });
}

void vtkBRDFView::WriteVectorsOrThrow(const std::string& fileName)
{
  const bool svg = fileName.ends_with(".svg");
  if (!svg && !fileName.ends_with(".pdf"))
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "unknown kind of picture", fileName, "", ".svg, .pdf" });
  }
  const std::array<int, 2> size = { this->GetRenderWindow()->GetSize()[0], this->Window->GetSize()[1] };
  this->Renderer->RemoveAllViewProps();
  this->Build(size[0], size[1]);
  vtkPropCollection* props = this->Renderer->GetViewProps();
  vtkCollectionSimpleIterator position;
  props->InitTraversal(position);
  while (vtkProp* prop = props->GetNextProp(position))
  {
    if (!vtkContextActor::SafeDownCast(prop))
    {
      throw brdf::Error(
        brdf::Error::Kind::Value,
        { "a picture of three-dimensional objects has no lines to write", fileName, prop->GetClassName(), ".png" });
    }
  }
  brdf::VectorPicture picture = PaintedVectors(GetScene(this->Renderer), size[0], size[1]);
  picture.title = this->Title;
  brdf::writeFile(fileName, svg ? svgText(picture) : pdfText(picture));
}

bool vtkBRDFView::WriteVectors(const std::string& fileName)
{
  return this->Guarded([this, &fileName] { this->WriteVectorsOrThrow(fileName); });
}

void vtkBRDFView::UpdateOrThrow(vtkBRDFAlgorithm* algorithm)
{
  if (!algorithm->UpdateAndCheck())
  {
    const std::string reason = algorithm->GetPipelineErrorText();
    throw std::runtime_error(reason.empty() ? "the pipeline of the view failed" : reason);
  }
}

int vtkBRDFView::TextSize(int width, int height)
{
  return std::max(9, static_cast<int>(std::min(width / 900.0, height / 700.0) * 15 + 0.5));
}

int vtkBRDFView::SmallTextSize(int width, int height)
{
  return TextSize(std::min(width, 900), std::min(height, 700)) * (width > 1300 ? 2 : 1) * 3 / (width > 1300 ? 5 : 3);
}

void vtkBRDFView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Title: " << this->Title << "\n" << indent << "ErrorText: " << this->ErrorText << "\n";
}
