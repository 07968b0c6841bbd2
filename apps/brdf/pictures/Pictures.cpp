#include "Pictures.h"

#include <brdf/base/Error.h>
#include <brdf/io/LoadMaterial.h>

#include <vtkBRDF.h>
#include <vtkBRDFAlgorithm.h>
#include <vtkBRDFView.h>

#include <cstdlib>
#include <filesystem>

namespace brdf::app {
namespace {

/// Standard error is for the program's own line: VTK and EGL keep silent, their reasons arrive as errors.
const bool silenced = [] {
  vtkObject::GlobalWarningDisplayOff();
  ::setenv("EGL_LOG_LEVEL", "fatal", 0);
  return true;
}();

}  // namespace

vtkSmartPointer<vtkBRDF> pipelineMaterial(const std::string& material, const ReadOptions& assumptions) {
  auto data = vtkSmartPointer<vtkBRDF>::New();
  data->SetBrdf(loadMaterial(material, assumptions).brdf);
  return data;
}

std::string shortName(const std::string& material) {
  const std::filesystem::path path(material.substr(0, material.rfind('#')));
  return std::filesystem::is_regular_file(path) ? std::filesystem::path(material).filename().string() : material;
}

void updateOrThrow(vtkBRDFAlgorithm* algorithm) {
  algorithm->Update();
  if (const std::string reason = algorithm->GetErrorText(); !reason.empty())
    throw Error(Error::Kind::Value, {reason, "", "", ""});
}

void writeView(vtkBRDFView* view, const PictureSize& size, const std::string& path) {
  view->SetSize(static_cast<int>(size.width), static_cast<int>(size.height));
  const bool vectors = path.ends_with(".svg") || path.ends_with(".pdf");
  if (!(vectors ? view->WriteVectors(path) : view->WritePNG(path)))
    throw Error(Error::Kind::Device, {view->GetErrorText(), "", "", ""});
}

}  // namespace brdf::app

extern "C" __attribute__((visibility("default"))) const brdf::app::PictureFunctions brdfPictures = {
    brdf::app::drawLobe,         brdf::app::drawError,        brdf::app::drawSlice,   brdf::app::frameDrawer,
    brdf::app::drawAudit,        brdf::app::drawDotPlot,      brdf::app::drawMontage, brdf::app::drawSurface,
    brdf::app::drawCurves,       brdf::app::surfaceReaders,   brdf::app::makeObject,  brdf::app::readPicture,
    brdf::app::writeRadiancePng, brdf::app::layoutDifference, brdf::app::shaderProbe};
