#include "Pictures.h"

#include <vtkBRDFRender.h>
#include <vtkBRDFToneMap.h>
#include <vtkCallbackCommand.h>
#include <vtkImageData.h>
#include <vtkPNGWriter.h>

#include <algorithm>

namespace brdf::app {
namespace {

void writePng(vtkImageData* radiance, const RenderPicture& request, const std::string& path) {
  writeVtk<vtkPNGWriter>(toneMapped(radiance, request).Get(), path);
}

/// Takes an observer off when it goes.
struct ObserverRemover {
  vtkObject* object;
  unsigned long tag;
  ~ObserverRemover() { object->RemoveObserver(tag); }
};

RenderedFrame converged(vtkBRDFRender* render, const ConvergeOptions& options) {
  render->SetMode(vtkBRDFRender::MODE_CONVERGING);
  render->SetTolerance(options.tolerance);
  render->SetMaximumSamples(static_cast<int>(options.samples));
  struct Watch {
    vtkBRDFRender* render;
    const ConvergeOptions* options;
    bool stopped;
  } watch{render, &options, false};
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback([](vtkObject*, unsigned long, void* data, void*) {
    auto& here = *static_cast<Watch*>(data);
    const auto done = static_cast<std::size_t>(here.render->GetSamplesDrawn());
    if (!here.options->progress || done == 0 || here.stopped) return;
    here.stopped = !here.options->progress(done, here.options->samples, here.render->GetRelativeError());
    if (here.stopped) here.render->SetAbortExecute(1);
  });
  const unsigned long observer = render->AddObserver(vtkCommand::ProgressEvent, command);
  render->Modified();
  const ObserverRemover remover{render, observer};
  updateOrThrow(render);
  RenderedFrame frame;
  frame.radiance = toImage(render->GetOutput());
  frame.device = render->GetDeviceDescription();
  frame.standardError = toImage(render->GetStandardError());
  frame.samples = static_cast<std::size_t>(render->GetSamplesDrawn());
  frame.relativeError = render->GetRelativeError();
  frame.converged = render->GetConverged();
  frame.stopped = watch.stopped;
  return frame;
}

}  // namespace

vtkSmartPointer<vtkImageData> toVtk(const Image& radiance) {
  auto picture = vtkSmartPointer<vtkImageData>::New();
  const auto width = static_cast<int>(radiance.width), height = static_cast<int>(radiance.height);
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_FLOAT, static_cast<int>(radiance.channels));
  for (int y = 0; y < height; ++y)  // VTK's rows go up
    std::copy_n(radiance.pixel(0, static_cast<std::size_t>(height - 1 - y)), radiance.channels * radiance.width,
                static_cast<float*>(picture->GetScalarPointer(0, y, 0)));
  return picture;
}

Image toImage(vtkImageData* picture) {
  const int* size = picture->GetDimensions();
  Image image(static_cast<std::size_t>(size[0]), static_cast<std::size_t>(size[1]),
              static_cast<std::size_t>(picture->GetNumberOfScalarComponents()));
  for (int y = 0; y < size[1]; ++y)
    std::copy_n(static_cast<const float*>(picture->GetScalarPointer(0, size[1] - 1 - y, 0)),
                image.channels * image.width, image.pixel(0, static_cast<std::size_t>(y)));
  return image;
}

void writeRadiancePng(const Image& radiance, const RenderPicture& request, const std::string& path) {
  Image picture = radiance;
  if (picture.channels == 4)  // a PNG's colours are not multiplied by alpha
    for (std::size_t k = 0; k < picture.values.size(); k += 4)
      for (std::size_t c = 0; c < 3 && picture.values[k + 3] > 0; ++c) picture.values[k + c] /= picture.values[k + 3];
  writePng(toVtk(picture), request, path);
}

vtkSmartPointer<vtkImageData> toneMapped(vtkImageData* radiance, const RenderPicture& request) {
  vtkNew<vtkBRDFToneMap> tone;
  tone->SetInputDataObject(radiance);
  tone->SetExposure(request.exposure);
  tone->SetCurve(request.toneCurve == "aces"       ? vtkBRDFToneMap::ACES
                 : request.toneCurve == "reinhard" ? vtkBRDFToneMap::REINHARD
                                                   : vtkBRDFToneMap::CLAMP);
  tone->Update();
  return tone->GetOutput();
}

FrameDrawer frameDrawer() {
  const auto render = vtkSmartPointer<vtkBRDFRender>::New();
  return [render](const Scene& scene, const RenderPicture& request) {
    render->SetScene(scene);
    render->SetNumberOfSamples(static_cast<int>(request.samples));
    render->SetShadows(request.shadows == "none"     ? vtkBRDFRender::SHADOWS_NONE
                       : request.shadows == "lights" ? vtkBRDFRender::SHADOWS_LIGHTS
                                                     : vtkBRDFRender::SHADOWS_ALL);
    render->SetShadowCells(std::stoi(request.shadowCells));
    setColours(render.Get(), request.colours);
    RenderedFrame frame;
    if (request.converge) {
      frame = converged(render, *request.converge);
    } else {
      updateOrThrow(render);
      frame.radiance = toImage(render->GetOutput());
      frame.device = render->GetDeviceDescription();
    }
    frame.tables = render->GetTableLayouts();
    frame.resamplingError = render->GetResamplingError();
    return frame;
  };
}

}  // namespace brdf::app
