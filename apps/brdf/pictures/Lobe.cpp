#include "Pictures.h"

#include <vtkBRDF.h>
#include <vtkBRDFLobe.h>
#include <vtkBRDFLobeView.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

namespace brdf::app {

void drawLobe(const LobePicture& request) {
  vtkNew<vtkBRDFLobeView> view;
  vtkSmartPointer<vtkBRDF> first;
  for (std::size_t k = 0; k < request.materials.size(); ++k) {
    const auto data = pipelineMaterial(request.materials[k], request.assumptions);
    if (!first) first = data;
    view->AddInputData(data, k < request.names.size() ? request.names[k] : shortName(request.materials[k]));
  }
  view->SetTitle(request.title);
  view->SetThetaI(request.thetaI);
  view->SetPhiI(request.phiI);
  view->SetTransform(request.transform);
  view->SetChannel(request.channel);
  setColours(view.Get(), request.colours);
  for (const std::string& path : request.out) {
    if (path.ends_with(".png")) {
      writeView(view, request.size, path);
      continue;
    }
    vtkNew<vtkBRDFLobe> lobe;
    lobe->SetInputDataObject(first);
    lobe->SetThetaI(request.thetaI);
    lobe->SetPhiI(request.phiI);
    lobe->SetTransform(request.transform);
    lobe->SetChannel(request.channel);
    setColours(lobe.Get(), request.colours);
    updateOrThrow(lobe);
    writeVtk<vtkXMLPolyDataWriter>(lobe->GetOutput(), path);
  }
}

}  // namespace brdf::app
