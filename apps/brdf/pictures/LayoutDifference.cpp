#include "Pictures.h"

#include <vtkImageData.h>
#include <vtkImageDifference.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>

namespace brdf::app {
namespace {

// Levels of 255 that count as the same: edges of letters and lines vary by that between machines.
constexpr int kSameLevels = 16;

vtkSmartPointer<vtkImageData> readPng(const std::string& path) {
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(path.c_str())) throw Error(Error::Kind::Format, {"not a PNG file", path, "", ""});
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  if (image->GetNumberOfScalarComponents() != 3 || image->GetScalarType() != VTK_UNSIGNED_CHAR)
    throw Error(Error::Kind::Format, {"not a picture of RGB, 8 bits", path,
                                      std::to_string(image->GetNumberOfScalarComponents()) + " components of " +
                                          image->GetScalarTypeAsString(),
                                      "as the views write them"});
  return image;
}

std::string sides(vtkImageData* image) {
  return std::to_string(image->GetDimensions()[0]) + " x " + std::to_string(image->GetDimensions()[1]) + " pixels";
}

}  // namespace

double layoutDifference(const std::string& found, const std::string& baseline, const std::string& differences) {
  const auto first = readPng(found), second = readPng(baseline);
  if (sides(first) != sides(second))
    throw Error(Error::Kind::Value, {"pictures of different size", "", sides(first), sides(second)});
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(first);
  difference->SetImageData(second);
  difference->SetThreshold(kSameLevels);
  difference->AllowShiftOn();  // by a pixel
  difference->AveragingOff();  // it would hide a changed letter
  difference->Update();
  if (!differences.empty()) writeVtk<vtkPNGWriter>(difference->GetOutput(), differences);
  return difference->GetThresholdedError() /
         (first->GetDimensions()[0] * static_cast<double>(first->GetDimensions()[1]));
}

}  // namespace brdf::app
