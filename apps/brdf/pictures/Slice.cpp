#include "Pictures.h"
#include "SliceTables.h"

#include <brdf/base/Text.h>

#include <vtkBRDF.h>
#include <vtkBRDFAlbedo.h>
#include <vtkBRDFCurve.h>
#include <vtkBRDFHoleMap.h>
#include <vtkBRDFHoleMapView.h>
#include <vtkBRDFPlotView.h>
#include <vtkBRDFSlice.h>
#include <vtkBRDFSliceView.h>
#include <vtkBRDFSpectrum.h>
#include <vtkBRDFVolumeView.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf::app {
namespace {

constexpr std::array<const char*, 4> kStates{"no_value", "measured_or_computed", "filled_or_extrapolated",
                                             "below_the_horizon"};

/// The columns of a table that hold values, and what lies in them.
void describe(vtkTable* table, SliceResult::Series& series) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (vtkIdType k = 1; k < table->GetNumberOfColumns(); ++k) {
    const std::string name = table->GetColumnName(k);
    if (name == "state" || name == "distance" || name.starts_with("standard error of ")) continue;
    series.channels.push_back(name);
    auto* column = vtkDataArray::SafeDownCast(table->GetColumn(k));
    for (vtkIdType row = 0; row < column->GetNumberOfTuples(); ++row) {
      const double value = column->GetTuple1(row);
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (low <= high) {
    series.smallest = low;
    series.largest = high;
  }
}

SliceResult::Axis axisOf(const std::string& name, const std::string& unit, vtkDataArray* values) {
  SliceResult::Axis axis{name, unit, 0, 0, static_cast<std::size_t>(values->GetNumberOfTuples())};
  if (axis.count > 0) {
    axis.from = values->GetTuple1(0);
    axis.to = values->GetTuple1(values->GetNumberOfTuples() - 1);
  }
  return axis;
}

std::vector<double> numbers(vtkFieldData* fields, const char* name) {
  std::vector<double> result;
  if (vtkDataArray* array = fields->GetArray(name))
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) result.push_back(array->GetTuple1(i));
  return result;
}

std::string nameOf(const SlicePicture& request, std::size_t k) {
  return k < request.names.size() ? request.names[k] : shortName(request.materials[k]);
}

bool isPicture(const std::string& path) {
  return path.ends_with(".png") || path.ends_with(".svg") || path.ends_with(".pdf");
}

template <class Filter>
void setAngles(Filter* filter, const SlicePicture& request) {
  filter->SetThetaI(request.thetaI);
  filter->SetPhiI(request.phiI);
  filter->SetThetaO(request.thetaO);
  filter->SetPhi(request.phi);
  filter->SetThetaH(request.thetaH);
  filter->SetPhiH(request.phiH);
  filter->SetThetaD(request.thetaD);
  filter->SetPhiD(request.phiD);
}

SliceResult drawImage(const SlicePicture& request) {
  vtkNew<vtkBRDFSliceView> view;
  for (std::size_t k = 0; k < request.materials.size(); ++k)
    view->AddInputData(pipelineMaterial(request.materials[k], request.assumptions), nameOf(request, k));
  vtkBRDFSlice* settings = view->GetSettings();
  settings->SetAxes(request.axes.empty() ? "theta_h,theta_d" : request.axes);
  settings->SetChannel(request.channel);
  setColours(settings, request.colours);
  setAngles(settings, request);
  settings->SetWarp(request.warp);
  const int cells = request.resolution > 0 ? static_cast<int>(request.resolution) : 360;
  settings->SetCells(cells, cells);
  view->SetTitle(request.title);
  if (!request.scale.empty()) view->SetScale(request.scale);
  if (request.decades > 0) view->SetDecades(request.decades);
  if (request.range.size() == 2) view->SetRange(request.range[0], request.range[1]);
  view->SetExposure(request.exposure);
  SliceResult result;
  result.quantity = "f_r (1/sr)";
  for (std::size_t k = 0; k < request.materials.size(); ++k) {
    vtkBRDFSlice* slice = view->GetSlice(static_cast<int>(k));
    slice->CopySettings(settings);
    updateOrThrow(slice);
    SliceResult::Series series{request.materials[k], slice->GetChannelLabel()};
    vtkFieldData* fields = slice->GetOutput()->GetFieldData();
    auto* channels = vtkStringArray::SafeDownCast(fields->GetAbstractArray("channels"));
    for (vtkIdType c = 0; c < channels->GetNumberOfValues(); ++c) series.channels.push_back(channels->GetValue(c));
    series.smallest = slice->GetSmallest();
    series.largest = slice->GetLargest();
    for (int state = 0; state < 4; ++state)
      series.counts.emplace_back(kStates[static_cast<std::size_t>(state)],
                                 static_cast<std::size_t>(slice->GetNumberOfCells(state)));
    result.series.push_back(series);
    if (k > 0) continue;
    result.fixed = slice->GetFixedAngles();
    auto* names = vtkStringArray::SafeDownCast(fields->GetAbstractArray("axes"));
    for (const char* axis : {"x", "y"}) {
      const std::string name = names->GetValue(axis[0] == 'x' ? 0 : 1);
      result.axes.push_back(axisOf(name, name == "wavelength" ? "nm" : "deg", fields->GetArray(axis)));
    }
  }
  for (const std::string& path : request.out) {
    vtkImageData* image = view->GetSlice(0)->GetOutput();
    if (isPicture(path))
      writeView(view, request.size, path);
    else if (path.ends_with(".exr"))
      writeSliceExr(image, path);
    else if (path.ends_with(".csv"))
      writeCsv(image, path);
    else
      writeVtk<vtkXMLImageDataWriter>(image, path);
  }
  return result;
}

/// What the plots have in common, and their files.
SliceResult finishPlot(vtkBRDFPlotView* view, const SlicePicture& request, const std::vector<NamedTable>& tables,
                       SliceResult result) {
  if (!request.title.empty()) view->SetTitle(request.title);
  if (!request.scale.empty()) view->SetScale(request.scale);
  if (request.decades > 0) view->SetDecades(request.decades);
  for (const std::string& path : request.out)
    isPicture(path) ? writeView(view, request.size, path) : writeCsv(tables, path);
  return result;
}

/// A filter for each material, set by `set`: its first table among the curves of a view, its second one, where it has
/// two names, as their points.
template <class Filter>
struct Tables {
  std::vector<vtkSmartPointer<Filter>> filters;
  std::vector<NamedTable> named;
  std::vector<SliceResult::Series> series;

  template <class Set>
  Tables(const SlicePicture& request, vtkBRDFPlotView* view, const std::vector<const char*>& names, const Set& set) {
    for (std::size_t k = 0; k < request.materials.size(); ++k) {
      const auto filter = filters.emplace_back(vtkSmartPointer<Filter>::New());
      filter->SetInputData(pipelineMaterial(request.materials[k], request.assumptions));
      set(filter.Get());
      updateOrThrow(filter);
      view->AddInputConnection(filter->GetOutputPort(0), nameOf(request, k));
      if (names.size() > 1) view->AddPointsConnection(filter->GetOutputPort(1));
      for (std::size_t port = 0; port < names.size(); ++port)
        named.push_back({request.materials[k], names[port], table(k, static_cast<int>(port))});
      describe(table(k), series.emplace_back(SliceResult::Series{request.materials[k], {}}));
    }
  }
  vtkTable* table(std::size_t k, int port = 0) const {
    return vtkTable::SafeDownCast(filters[k]->GetOutputDataObject(port));
  }
  /// Of the first column of all tables.
  SliceResult::Axis axis(const std::string& name, const std::string& unit) const {
    return axisOf(name, unit, vtkDataArray::SafeDownCast(table(0)->GetColumn(0)));
  }
};

SliceResult drawCurves(const SlicePicture& request) {
  const bool polar = request.kind == "polar", cosine = request.quantity == "f_cos";
  const std::string& over = request.over;
  vtkNew<vtkBRDFPlotView> view;
  const Tables<vtkBRDFCurve> curves(request, view, {"curve", "sample"}, [&](vtkBRDFCurve* curve) {
    curve->SetAngle(over);
    setAngles(curve, request);
    curve->SetChannel(request.channel);
    setColours(curve, request.colours);
    curve->SetQuantity(request.quantity);
    curve->SetSampleTolerance(request.within);
    if (request.resolution > 0) curve->SetIntervals(static_cast<int>(request.resolution));
  });
  SliceResult result;
  result.quantity = cosine ? "f_r cos(theta_o) (1/sr)" : "f_r (1/sr)";
  result.series = curves.series;
  result.fixed = curves.filters[0]->GetFixedAngles();
  result.axes.push_back(curves.axis(over, "deg"));
  bool samples = false, beyond = false;
  for (std::size_t k = 0; k < curves.filters.size(); ++k) {
    vtkBRDFCurve* curve = curves.filters[k];
    SliceResult::Series& series = result.series[k];
    series.channel = curve->GetChannelLabel();
    for (int state = 0; state < 4; ++state)
      series.counts.emplace_back(kStates[static_cast<std::size_t>(state)],
                                 static_cast<std::size_t>(curve->GetNumberOfPoints(state)));
    series.counts.emplace_back("samples", static_cast<std::size_t>(curves.table(k, 1)->GetNumberOfRows()));
    series.counts.emplace_back("samples_left_out", static_cast<std::size_t>(curve->GetNumberOfSamplesLeftOut()));
    samples = samples || curves.table(k, 1)->GetNumberOfRows() > 0;
    beyond = beyond || curve->GetNumberOfPoints(2) > 0;
  }

  const bool azimuth = over == "phi" || over == "phi_d";
  view->SetXStep(azimuth ? 45 : 15);
  view->SetYTitle(result.quantity);
  view->SetXTitle(over == "phi" ? "phi_o - phi_i (degrees)" : over + " (degrees)");
  view->SetTitle((cosine ? "f_r cos(theta_o) over " : "f_r over ") +
                 (over == "phi" ? std::string("phi_o - phi_i") : over));
  if (polar) view->SetKind(azimuth ? "circle" : "half circle");
  std::string note = result.series[0].channel + "; " + result.fixed;
  if (beyond) note += "; pale: filled or extrapolated";
  if (samples) note += "; dots: samples within " + formatNumber(request.within) + " deg";
  view->SetNote(note);
  if (over == "theta_o" && request.phi == 180) {
    view->AddReference(request.thetaI, "mirror");
    view->AddReference(-request.thetaI, "light");
  }
  return finishPlot(view, request, curves.named, result);
}

SliceResult drawAlbedo(const SlicePicture& request) {
  vtkNew<vtkBRDFPlotView> view;
  const Tables<vtkBRDFAlbedo> albedos(request, view, {"albedo"}, [&](vtkBRDFAlbedo* albedo) {
    albedo->SetChannel(request.channel);
    setColours(albedo, request.colours);
    albedo->SetPhiI(request.phiI);
    albedo->SetPoints(static_cast<int>(request.points));
    if (request.resolution > 0) albedo->SetIntervals(static_cast<int>(request.resolution));
  });
  SliceResult result;
  result.quantity = "directional-hemispherical albedo";
  result.series = albedos.series;
  for (std::size_t k = 0; k < albedos.filters.size(); ++k) {
    vtkTable* table = albedos.table(k);
    SliceResult::Series& series = result.series[k];
    series.channel = albedos.filters[k]->GetChannelLabel();
    series.albedo = numbers(table->GetFieldData(), "bihemispherical");
    series.albedoError = numbers(table->GetFieldData(), "standard error of bihemispherical");
    for (const std::string& channel : series.channels) {
      auto* errors = vtkDataArray::SafeDownCast(table->GetColumnByName(("standard error of " + channel).c_str()));
      for (vtkIdType row = 0; row < errors->GetNumberOfTuples(); ++row)
        series.largestError = std::max(series.largestError, errors->GetTuple1(row));
    }
  }
  result.axes.push_back(albedos.axis("theta_i", "deg"));
  result.fixed = "phi_i = " + formatNumber(request.phiI) + " deg";
  view->SetXStep(15);
  view->SetXTitle("angle of the light from the normal, theta_i (degrees)");
  view->SetYTitle("directional-hemispherical albedo");
  view->SetTitle("Share of the light that is reflected");
  view->SetNote(result.series[0].channel + "; " + result.fixed +
                "; \u00b1 and bands: 1 standard error of the quadrature");
  view->AddLevel(1, "all light");
  return finishPlot(view, request, albedos.named, result);
}

SliceResult drawSpectrum(const SlicePicture& request) {
  vtkNew<vtkBRDFPlotView> view;
  const Tables<vtkBRDFSpectrum> spectra(request, view, {"spectrum"}, [&](vtkBRDFSpectrum* spectrum) {
    for (const auto& [thetaI, phiI, thetaO, phiO] : request.directions)
      spectrum->AddDirections(thetaI, phiI, thetaO, phiO);
  });
  SliceResult result;
  result.quantity = "f_r (1/sr)";
  result.series = spectra.series;
  for (SliceResult::Series& series : result.series) series.channel = "all wavelengths";
  result.axes.push_back(spectra.axis("wavelength", "nm"));
  result.fixed = joined(result.series[0].channels, "; ");
  view->SetXTitle("wavelength (nm)");
  view->SetYTitle("f_r (1/sr)");
  view->SetTitle("f_r over the wavelength");
  view->SetNote(result.series[0].channels.size() == 1 ? result.fixed : "directions: theta, phi");
  return finishPlot(view, request, spectra.named, result);
}

SliceResult drawHoles(const SlicePicture& request) {
  vtkNew<vtkBRDFHoleMapView> view;
  view->SetInputData(pipelineMaterial(request.materials[0], request.assumptions));
  view->SetName(nameOf(request, 0));
  view->SetTitle(request.title);
  view->SetWarp(request.warp);
  vtkBRDFHoleMap* map = view->GetHoleMap();
  if (!request.axes.empty()) {
    const std::size_t comma = request.axes.find(',');
    map->SetXAxis(request.axes.substr(0, comma));
    map->SetYAxis(comma == std::string::npos ? "" : request.axes.substr(comma + 1));
  }
  updateOrThrow(map);
  vtkImageData* image = map->GetOutput();
  vtkFieldData* fields = image->GetFieldData();
  SliceResult result;
  result.quantity = "cells by what they hold";
  auto* names = vtkStringArray::SafeDownCast(fields->GetAbstractArray("axes"));
  result.axes = {axisOf(names->GetValue(0), "deg", fields->GetArray("x")),
                 axisOf(names->GetValue(1), "deg", fields->GetArray("y"))};
  result.fixed = "summed over all other axes of " +
                 std::string(vtkStringArray::SafeDownCast(fields->GetAbstractArray("layout"))->GetValue(0));
  SliceResult::Series series{request.materials[0], ""};
  for (const auto& [name, kind] : {std::pair{"measured", 0}, {"filled", 1}, {"invalid", 2}, {"below_the_horizon", 3}})
    series.counts.emplace_back(name, static_cast<std::size_t>(map->GetNumberOfCells(kind)));
  result.series.push_back(series);
  for (const std::string& path : request.out) {
    if (isPicture(path))
      writeView(view, request.size, path);
    else if (path.ends_with(".csv"))
      writeCsv(image, path);
    else
      writeVtk<vtkXMLImageDataWriter>(image, path);
  }
  return result;
}

SliceResult drawVolume(const SlicePicture& request) {
  vtkNew<vtkBRDFVolumeView> view;
  view->SetInputData(pipelineMaterial(request.materials[0], request.assumptions));
  view->SetName(nameOf(request, 0));
  view->SetTitle(request.title);
  view->SetChannel(request.channel);
  setColours(view.Get(), request.colours);
  if (request.decades > 0) view->SetDecades(request.decades);
  const int cells = request.resolution > 0 ? static_cast<int>(request.resolution) : 90;
  view->SetCells(cells, cells, cells);
  for (const std::string& path : request.out) {
    if (path.ends_with(".png")) {
      writeView(view, request.size, path);
      continue;
    }
    if (!view->Tabulate()) throw Error(Error::Kind::Value, {view->GetErrorText(), "", "", ""});
    writeVtk<vtkXMLImageDataWriter>(view->GetTable(), path);
  }
  SliceResult result;
  result.quantity = "f_r (1/sr)";
  result.fixed = "phi_h = 0 deg";
  const auto count = static_cast<std::size_t>(cells);
  result.axes = {{"theta_h", "deg, in steps of its square root", 0, 90, count},
                 {"theta_d", "deg", 0, 90, count},
                 {"phi_d", "deg", 0, 180, count}};
  SliceResult::Series series{request.materials[0], view->GetChannelLabel(), {"value"}};
  vtkDataArray* values = view->GetTable()->GetPointData()->GetArray("value");
  vtkDataArray* valid = view->GetTable()->GetPointData()->GetArray("valid");
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::size_t known = 0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i) {
    if (valid->GetTuple1(i) == 0) continue;
    ++known;
    low = std::min(low, values->GetTuple1(i));
    high = std::max(high, values->GetTuple1(i));
  }
  if (known > 0) {
    series.smallest = low;
    series.largest = high;
  }
  series.counts = {
      {"with_value", known},
      {"without_value_or_below_the_horizon", static_cast<std::size_t>(values->GetNumberOfTuples()) - known}};
  result.series.push_back(series);
  return result;
}

}  // namespace

SliceResult drawSlice(const SlicePicture& request) {
  if (request.kind == "image") return drawImage(request);
  if (request.kind == "albedo") return drawAlbedo(request);
  if (request.kind == "wavelength") return drawSpectrum(request);
  if (request.kind == "holes") return drawHoles(request);
  if (request.kind == "volume") return drawVolume(request);
  return drawCurves(request);
}

}  // namespace brdf::app
