#pragma once
#include "../Pictures.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkBRDF;
class vtkBRDFAlgorithm;
class vtkBRDFView;
class vtkImageData;

/// The picture module: a library of its own, loaded by ../Pictures.cpp. One file a command.
namespace brdf::app {

LobeResult drawLobe(const LobePicture& request);
ErrorResult drawError(const ErrorPicture& request);
SliceResult drawSlice(const SlicePicture& request);
FrameDrawer frameDrawer();
TriangleMesh makeObject(const std::string& object);
Image readPicture(const std::string& path);
void writeRadiancePng(const Image& radiance, const RenderPicture& request, const std::string& path);
void drawAudit(const AuditPicture& request);
void drawDotPlot(const DotPlotPicture& request);
void drawMontage(const MontagePicture& request);
void drawSurface(const SurfacePicture& request);
void drawCurves(const CurvesPicture& request);
SurfaceReaders surfaceReaders();
double layoutDifference(const std::string& found, const std::string& baseline, const std::string& differences);
GlslRunner shaderProbe();

/// A material as a data object of the pipeline. Throws what loadMaterial throws.
vtkSmartPointer<vtkBRDF> pipelineMaterial(const std::string& material, const ReadOptions& assumptions);

/// Linear radiance as VTK's picture of floats, and back.
vtkSmartPointer<vtkImageData> toVtk(const Image& radiance);
Image toImage(vtkImageData* picture);
/// Radiance as the 8-bit sRGB picture that `request` asks for.
vtkSmartPointer<vtkImageData> toneMapped(vtkImageData* radiance, const RenderPicture& request);

/// How a picture names a material: a file without its folder, anything else as it is.
std::string shortName(const std::string& material);

/// Updates a filter; throws brdf::Error with its reason when it fails.
void updateOrThrow(vtkBRDFAlgorithm* algorithm);

/// Writes the view's picture, by the path's ending .png, .svg or .pdf; throws brdf::Error with the view's reason when
/// it cannot be made.
void writeView(vtkBRDFView* view, const PictureSize& size, const std::string& path);

/// What every filter that shows colours has.
template <class Filter>
void setColours(Filter* filter, const ColourNames& colours) {
  filter->SetIlluminant(colours.illuminant);
  filter->SetObserver(colours.observer);
  filter->SetAdaptation(colours.adaptation);
}

/// Writes `data` with a writer of VTK's, replacing `path` when it is complete. `set` (Writer*) sets its options.
template <class Writer, class Data, class Settings>
void writeVtk(Data* data, const std::string& path, const Settings& set) {
  AtomicFile file(path);
  vtkNew<Writer> writer;
  set(writer.Get());
  writer->SetInputData(data);
  writer->SetFileName(file.temporaryPath().c_str());
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
    throw Error(Error::Kind::File,
                {"cannot be written", path, vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()), ""});
  file.commit();
}
template <class Writer, class Data>
void writeVtk(Data* data, const std::string& path) {
  writeVtk<Writer>(data, path, [](Writer*) {});
}

}  // namespace brdf::app
