#include "Pictures.h"

#include <brdf/io/ImageFile.h>

#include <vtkBRDF.h>
#include <vtkBRDFErrorMap.h>
#include <vtkBRDFErrorMapView.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>

#include <limits>

namespace brdf::app {
namespace {

/// The map as a grey picture, the second angle upwards; NaN where there was nothing to compare.
Image errorImage(vtkImageData* map) {
  int size[3];
  map->GetDimensions(size);
  const auto width = static_cast<std::size_t>(size[0]), height = static_cast<std::size_t>(size[1]);
  vtkDataArray* error = map->GetPointData()->GetArray("error");
  vtkDataArray* count = map->GetPointData()->GetArray("count");
  Image image(width, height, 1);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const auto point = static_cast<vtkIdType>((height - 1 - y) * width + x);
      const bool counted = count->GetTuple1(point) > 0;
      *image.pixel(x, y) =
          counted ? static_cast<float>(error->GetTuple1(point)) : std::numeric_limits<float>::quiet_NaN();
    }
  return image;
}

}  // namespace

ErrorResult drawError(const ErrorPicture& request) {
  vtkNew<vtkBRDFErrorMapView> view;
  view->SetInputData(0, pipelineMaterial(request.a, request.assumptions));
  view->SetInputData(1, pipelineMaterial(request.b, request.assumptions));
  view->SetNameA(request.nameA.empty() ? shortName(request.a) : request.nameA);
  view->SetNameB(request.nameB.empty() ? shortName(request.b) : request.nameB);
  vtkBRDFErrorMap* map = view->GetErrorMap();
  map->SetMeasure(request.measure);
  map->SetAxes(request.axes);
  map->SetChannel(request.channel);
  setColours(map, request.colours);
  map->SetIntervals(request.resolution > 0 ? static_cast<int>(request.resolution) : map->SuggestIntervals());
  view->SetIntervals(map->GetIntervals());
  updateOrThrow(map);
  vtkImageData* image = map->GetOutput();
  for (const std::string& path : request.out) {
    if (path.ends_with(".png"))
      writeView(view, request.size, path);
    else if (path.ends_with(".exr"))
      writeExr(errorImage(image), path);
    else
      writeVtk<vtkXMLImageDataWriter>(image, path);
  }
  ErrorResult result;
  result.mean = map->GetOverallMean();
  result.largest = map->GetLargest();
  result.label = map->GetQuantity();
  result.sampling = map->GetSampling();
  vtkDataArray* count = image->GetPointData()->GetArray("count");
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
    result.count += static_cast<std::size_t>(count->GetTuple1(point));
  return result;
}

}  // namespace brdf::app
