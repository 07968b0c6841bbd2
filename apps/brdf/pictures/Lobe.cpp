#include "Pictures.h"

#include <vtkBRDF.h>
#include <vtkBRDFLobe.h>
#include <vtkBRDFLobeView.h>
#include <vtkOBJWriter.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkXMLPolyDataWriter.h>

namespace brdf::app {
namespace {

/// For programs that know triangles, normals and one colour a vertex only.
vtkSmartPointer<vtkPolyData> plainMesh(vtkPolyData* lobe) {
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(lobe->GetPoints());
  mesh->SetPolys(lobe->GetPolys());
  mesh->GetPointData()->SetNormals(lobe->GetPointData()->GetNormals());
  if (vtkDataArray* colours = lobe->GetPointData()->GetArray("rgb")) mesh->GetPointData()->SetScalars(colours);
  return mesh;
}

void writeMesh(vtkPolyData* lobe, const std::string& path) {
  if (path.ends_with(".vtp")) {
    writeVtk<vtkXMLPolyDataWriter>(lobe, path);
    return;
  }
  const vtkSmartPointer<vtkPolyData> mesh = plainMesh(lobe);
  if (mesh->GetNumberOfPolys() == 0)
    throw Error(Error::Kind::Value, {"the lobe has no surface to write: no value in any direction", path, "", ""});
  if (path.ends_with(".obj")) {
    writeVtk<vtkOBJWriter>(mesh.Get(), path);
  } else if (path.ends_with(".stl")) {
    writeVtk<vtkSTLWriter>(mesh.Get(), path, [](vtkSTLWriter* writer) { writer->SetFileTypeToBinary(); });
  } else {
    writeVtk<vtkPLYWriter>(mesh.Get(), path, [&](vtkPLYWriter* writer) {
      writer->SetFileTypeToBinary();
      if (!mesh->GetPointData()->GetScalars()) return;
      writer->SetArrayName("rgb");
      writer->SetColorModeToDefault();
    });
  }
}

template <class Filter>
void setLobe(Filter* filter, const LobePicture& request) {
  filter->SetThetaI(request.thetaI);
  filter->SetPhiI(request.phiI);
  filter->SetTransform(request.transform);
  filter->SetFloor(request.floor);
  filter->SetChannel(request.channel);
  filter->SetResolution(static_cast<int>(request.subdivision));
  filter->SetTolerance(request.tolerance);
  filter->SetShape(request.difference == "none" ? "value" : request.difference == "lobe" ? "difference" : "displaced");
  setColours(filter, request.colours);
}

}  // namespace

LobeResult drawLobe(const LobePicture& request) {
  vtkNew<vtkBRDFLobeView> view;
  std::vector<vtkSmartPointer<vtkBRDF>> materials;
  for (std::size_t k = 0; k < request.materials.size(); ++k) {
    materials.push_back(pipelineMaterial(request.materials[k], request.assumptions));
    view->AddInputData(materials.back(), k < request.names.size() ? request.names[k] : shortName(request.materials[k]));
  }
  view->SetTitle(request.title);
  setLobe(view.Get(), request);
  view->SetColour(request.colour);
  view->SetLayout(request.layout);
  view->SetShowSamples(request.samples);
  view->SetSampleAngle(request.within);

  LobeResult result;
  const bool differs = request.difference != "none";
  for (std::size_t k = 0; k < (differs ? 1 : materials.size()); ++k) {
    vtkNew<vtkBRDFLobe> lobe;
    lobe->SetInputDataObject(0, materials[k]);
    if (differs) lobe->SetInputDataObject(1, materials.back());
    setLobe(lobe.Get(), request);
    const bool plain = request.colour == "material" || request.colour == "value";
    lobe->SetColour(request.colour == "auto" ? (request.channel == "rgb" ? "true" : "") : plain ? "" : request.colour);
    updateOrThrow(lobe);
    result.largest.push_back(lobe->GetMaximumLength());
    result.chordError.push_back(lobe->GetChordError());
    result.triangles.push_back(static_cast<std::size_t>(lobe->GetOutput()->GetNumberOfPolys()));
    for (const std::string& path : request.out)
      if (k == 0 && !path.ends_with(".png")) writeMesh(lobe->GetOutput(), path);
  }
  for (const std::string& path : request.out)
    if (path.ends_with(".png")) writeView(view, request.size, path);
  return result;
}

}  // namespace brdf::app
