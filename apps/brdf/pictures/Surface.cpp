#include "Pictures.h"

#include <vtkBRDFMicrosurface.h>
#include <vtkBRDFMicrosurfaceData.h>
#include <vtkBRDFMicrosurfaceGeometry.h>
#include <vtkBRDFMicrosurfaceView.h>
#include <vtkBRDFPlotView.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkOBJWriter.h>
#include <vtkPLYWriter.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkTable.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

namespace brdf::app {
namespace {

void writeGeometry(vtkBRDFMicrosurfaceGeometry* geometry, const std::string& path) {
  if (path.ends_with(".vti")) {
    if (geometry->GetHeights()->GetNumberOfPoints() == 0)
      throw Error(Error::Kind::Value, {"no heights at nodes", path, "a mesh or spheres", "a height field"});
    writeVtk<vtkXMLImageDataWriter>(geometry->GetHeights(), path);
  } else if (path.ends_with(".vtp")) {
    writeVtk<vtkXMLPolyDataWriter>(geometry->GetOutput(), path);
  } else if (path.ends_with(".obj")) {
    writeVtk<vtkOBJWriter>(geometry->GetOutput(), path);
  } else if (path.ends_with(".stl")) {
    writeVtk<vtkSTLWriter>(geometry->GetOutput(), path, [](vtkSTLWriter* writer) { writer->SetFileTypeToBinary(); });
  } else {
    writeVtk<vtkPLYWriter>(geometry->GetOutput(), path, [](vtkPLYWriter* writer) { writer->SetFileTypeToBinary(); });
  }
}

vtkSmartPointer<vtkDoubleArray> column(const std::string& name, const std::vector<double>& values) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  for (const double value : values) array->InsertNextValue(value);
  return array;
}

}  // namespace

void drawSurface(const SurfacePicture& request) {
  const int tiles = static_cast<int>(request.tiles);
  vtkNew<vtkBRDFMicrosurface> surface;
  surface->SetSurface(request.surface);
  vtkNew<vtkBRDFMicrosurfaceGeometry> geometry;
  geometry->SetInputData(surface);
  geometry->SetTiles(tiles, tiles);
  for (const std::string& path : request.out) {
    if (path.ends_with(".png")) continue;
    updateOrThrow(geometry);
    writeGeometry(geometry, path);
  }
  vtkNew<vtkBRDFMicrosurfaceView> view;
  view->SetInputData(surface);
  view->SetTitle(request.title);
  view->SetTiles(tiles, tiles);
  view->SetAzimuth(request.azimuth);
  view->SetElevation(request.elevation);
  view->SetExaggeration(request.exaggeration);
  for (const std::string& path : request.out)
    if (path.ends_with(".png")) writeView(view, request.size, path);
}

void drawCurves(const CurvesPicture& request) {
  vtkNew<vtkBRDFPlotView> view;
  view->SetTitle(request.title);
  view->SetNote(request.note);
  view->SetXTitle(request.xTitle);
  view->SetYTitle(request.yTitle);
  view->SetScale(request.scale);
  view->SetDecades(request.decades);
  for (const CurvesPicture::Curve& curve : request.curves) {
    vtkNew<vtkTable> table;
    table->AddColumn(column("x", curve.x));
    table->AddColumn(column(curve.name, curve.y));
    view->AddInputData(table);
  }
  writeView(view, request.size, request.out);
}

SurfaceReaders surfaceReaders() { return vtkBRDFMicrosurfaceData::Readers(); }

}  // namespace brdf::app
