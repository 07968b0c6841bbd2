#include "Pictures.h"

#include <brdf/base/Text.h>
#include <brdf/io/ImageFile.h>

#include <vtkBRDF.h>
#include <vtkBRDFErrorMap.h>
#include <vtkBRDFErrorMapView.h>
#include <vtkBRDFHistogramView.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkTable.h>
#include <vtkVariant.h>
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

/// The map as rows: x, y, error, one a channel where there are several, count; without the points that have no value.
std::string mapCsv(vtkImageData* map, const ErrorPicture& request) {
  vtkDataArray* error = map->GetPointData()->GetArray("error");
  vtkDataArray* channels = map->GetPointData()->GetArray("channel_error");
  vtkDataArray* count = map->GetPointData()->GetArray("count");
  std::string text = request.axes == "hemisphere" ? "x,y" : request.axes;
  text += ",error";
  for (int c = 0; channels && c < channels->GetNumberOfComponents(); ++c) text += ",error_" + std::to_string(c);
  text += ",count\n";
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i) {
    if (!(count->GetTuple1(i) > 0)) continue;
    text += formatNumber(map->GetPoint(i)[0]) + "," + formatNumber(map->GetPoint(i)[1]) + "," +
            formatNumber(error->GetTuple1(i));
    for (int c = 0; channels && c < channels->GetNumberOfComponents(); ++c)
      text += "," + formatNumber(channels->GetComponent(i, c));
    text += "," + formatNumber(count->GetTuple1(i)) + "\n";
  }
  return text;
}

std::string tableCsv(vtkTable* table) {
  std::string text;
  for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
    text += (column > 0 ? "," : "") + std::string(table->GetColumnName(column));
  text += "\n";
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row) {
    for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
      text += (column > 0 ? "," : "") + formatNumber(table->GetValue(row, column).ToDouble());
    text += "\n";
  }
  return text;
}

ErrorResult resultOf(vtkBRDFErrorMap* map) {
  ErrorResult result;
  result.mean = map->GetOverallMean();
  result.largest = map->GetLargest();
  result.label = map->GetQuantity();
  result.pairLabel = map->GetPairQuantity();
  result.sampling = map->GetSampling();
  result.pairs = static_cast<std::size_t>(map->GetNumberOfPairs());
  result.leftOut = static_cast<std::size_t>(map->GetNumberLeftOut());
  vtkDataArray* count = map->GetOutput()->GetPointData()->GetArray("count");
  for (vtkIdType point = 0; point < map->GetOutput()->GetNumberOfPoints(); ++point)
    result.count += static_cast<std::size_t>(count->GetTuple1(point));
  for (int c = 0; c < map->GetNumberOfChannels(); ++c) result.channels.push_back(map->GetChannelMean(c));
  for (double share : {0.0, 0.05, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99, 0.999, 1.0})
    if (result.pairs > 0) result.quantiles.emplace_back(share, map->GetQuantile(share));
  vtkTable* worst = map->GetWorst();
  for (vtkIdType row = 0; row < worst->GetNumberOfRows(); ++row) {
    const auto value = [&](const std::string& column) { return worst->GetValueByName(row, column.c_str()).ToDouble(); };
    ErrorResult::Worst one{value("error"), value("theta_i"), value("phi_i"), value("theta_o"), value("phi_o"), {}, {}};
    for (int c = 0; c < map->GetNumberOfChannels(); ++c) {
      one.a.push_back(value("a_" + std::to_string(c)));
      one.b.push_back(value("b_" + std::to_string(c)));
    }
    result.worst.push_back(std::move(one));
  }
  return result;
}

}  // namespace

ErrorResult drawError(const ErrorPicture& request) {
  vtkNew<vtkBRDFErrorMapView> view;
  const std::string nameA = request.nameA.empty() ? shortName(request.a) : request.nameA;
  const std::string nameB = request.nameB.empty() ? shortName(request.b) : request.nameB;
  view->SetInputData(0, pipelineMaterial(request.a, request.assumptions));
  view->SetInputData(1, pipelineMaterial(request.b, request.assumptions));
  view->SetNameA(nameA);
  view->SetNameB(nameB);
  vtkBRDFErrorMap* map = view->GetErrorMap();
  map->SetMeasure(request.measure);
  map->SetAverage(request.average);
  map->SetAxes(request.axes);
  map->SetThetaI(request.thetaI);
  map->SetPhiI(request.phiI);
  map->SetProjection(request.projection);
  map->SetDirections(request.directions);
  map->SetSampleAngle(request.within);
  map->SetChannel(request.channel);
  map->SetNumberOfWorst(static_cast<int>(request.worst));
  map->SetNumberOfBins(static_cast<int>(request.bins));
  setColours(map, request.colours);
  map->SetIntervals(request.resolution > 0 ? static_cast<int>(request.resolution) : map->SuggestIntervals());
  view->SetIntervals(map->GetIntervals());
  updateOrThrow(map);
  vtkNew<vtkBRDFHistogramView> histogram;
  histogram->SetErrorMap(map);
  histogram->SetNameA(nameA);
  histogram->SetNameB(nameB);
  for (const std::string& path : request.out) {
    if (path.ends_with(".exr"))
      writeExr(errorImage(map->GetOutput()), path);
    else if (path.ends_with(".csv"))
      writeFile(path, mapCsv(map->GetOutput(), request));
    else if (path.ends_with(".vti"))
      writeVtk<vtkXMLImageDataWriter>(map->GetOutput(), path);
    else
      writeView(view, request.size, path);
  }
  for (const std::string& path : request.histogram) {
    if (path.ends_with(".csv"))
      writeFile(path, tableCsv(map->GetHistogram()));
    else
      writeView(histogram, request.size, path);
  }
  if (!request.worstOut.empty()) writeFile(request.worstOut, tableCsv(map->GetWorst()));
  return resultOf(map);
}

}  // namespace brdf::app
