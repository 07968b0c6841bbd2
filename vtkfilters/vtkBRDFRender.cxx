#include "vtkBRDFRender.h"

#include "vtkBRDFConvergence.h"
#include "vtkBRDFEnvironment.h"
#include "vtkBRDFImageConversion.h"
#include "vtkBRDFRenderStage.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <brdf/base/Error.h>
#include <brdf/render/Scene.h>

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkBRDFRender);
vtkCxxSetObjectMacro(vtkBRDFRender, Environment, vtkBRDFEnvironment);
vtkCxxSetObjectMacro(vtkBRDFRender, Camera, vtkCamera);
vtkCxxSetObjectMacro(vtkBRDFRender, BackgroundImage, vtkImageData);

vtkBRDFRender::vtkBRDFRender()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(1);
}

vtkBRDFRender::~vtkBRDFRender()
{
  this->Graphics.reset();
  this->SetEnvironment(nullptr);
  this->SetCamera(nullptr);
  this->SetBackgroundImage(nullptr);
}

vtkBRDFRender::Scene& vtkBRDFRender::GetScene()
{
  if (!this->Graphics)
  {
    this->Graphics = std::make_unique<Scene>();
  }
  return *this->Graphics;
}

int vtkBRDFRender::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // where there are other objects
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkBRDFRender::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

vtkImageData* vtkBRDFRender::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkBRDFRender::GetSamplesOfPicture()
{
  int samples = this->NumberOfSamples;
  for (const Scene::Object* object : this->GetScene().Objects())
  {
    samples = std::min(samples, object->Mapper->GetSamplesDrawn());
  }
  return samples;
}

vtkMTimeType vtkBRDFRender::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkObject* part : { static_cast<vtkObject*>(this->Environment),
                           static_cast<vtkObject*>(this->Camera),
                           static_cast<vtkObject*>(this->BackgroundImage) })
  {
    time = part ? std::max(time, part->GetMTime()) : time;
  }
  return time;
}

int vtkBRDFRender::RequestInformation(vtkInformation*,
                                      vtkInformationVector** vtkNotUsed(inputs),
                                      vtkInformationVector* outputs)
{
  if (this->Size[0] < 1 || this->Size[1] < 1 || this->Size[0] > 16384 || this->Size[1] > 16384)
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "size of the picture",
                        {},
                        std::to_string(this->Size[0]) + " x " + std::to_string(this->Size[1]),
                        "1 to 16384 pixels a side" });
  }
  vtkInformation* info = outputs->GetInformationObject(0);
  const int extent[6] = { 0, this->Size[0] - 1, 0, this->Size[1] - 1, 0, 0 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, this->Background == BACKGROUND_TRANSPARENT ? 4 : 3);
  return 1;
}

// The picture from what the pass has drawn, over a background that is not the environment.
void vtkBRDFRender::Compose(vtkImageData* output)
{
  const std::vector<float>& drawn = this->GetScene().Pass->Pixels;
  brdf::SceneBackground background;
  if (this->Background == BACKGROUND_COLOR)
  {
    background.kind = brdf::SceneBackground::Kind::Colour;
    std::copy_n(this->BackgroundColor, 3, background.rgb.begin());
  }
  else if (this->Background == BACKGROUND_IMAGE && this->BackgroundImage)
  {
    background.kind = brdf::SceneBackground::Kind::Picture;
    background.picture = std::make_shared<const brdf::Image>(vtkBRDFImageConversion::FromVtk(this->BackgroundImage));
  }
  const std::size_t channels = this->Background == BACKGROUND_TRANSPARENT ? 4 : 3;
  const auto width = static_cast<std::size_t>(this->Size[0]), height = static_cast<std::size_t>(this->Size[1]);
  output->SetDimensions(this->Size[0], this->Size[1], 1);
  output->AllocateScalars(VTK_FLOAT, static_cast<int>(channels));
  output->GetPointData()->GetScalars()->SetName("radiance");
  auto* to = static_cast<float*>(output->GetScalarPointer());
  for (std::size_t pixel = 0; pixel < width * height; ++pixel)
  {
    std::copy_n(drawn.data() + 4 * pixel, channels, to + channels * pixel);
    const double open = 1.0 - static_cast<double>(drawn[4 * pixel + 3]);
    if (open > 0 && background.kind != brdf::SceneBackground::Kind::Environment)
    {
      const brdf::Rgb behind = brdf::backgroundRadiance(background,
                                                        (static_cast<double>(pixel % width) + 0.5) / this->Size[0],
                                                        1 - (static_cast<double>(pixel / width) + 0.5) / this->Size[1],
                                                        static_cast<double>(width) / static_cast<double>(height));
      for (std::size_t channel = 0; channel < 3; ++channel)
      {
        to[channels * pixel + channel] += static_cast<float>(open * behind[channel]);
      }
    }
  }
}

int vtkBRDFRender::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->PrepareObjects(inputs);
  Scene& scene = this->GetScene();
  if (!scene.Window->IsAvailable())
  {
    throw brdf::Error(brdf::Error::Kind::Device, { scene.Window->GetErrorText(), {}, {}, {} });
  }
  this->PrepareCamera();
  this->PrepareBackground();
  scene.Pass->UnfilteredBackground = this->Mode == MODE_CONVERGING && this->BackgroundBlur <= 0;
  this->PrepareShadows();
  scene.Pass->EdgeSamples = this->EdgeSamples;
  scene.Seed = this->Seed;
  std::copy_n(this->Size, 2, scene.Pass->Size);
  scene.Window->SetSize(this->Size);
  this->StandardError->Initialize();
  if (this->Mode == MODE_CONVERGING)
  {
    this->Converge();
  }
  else
  {
    scene.Window->Render();
  }
  std::vector<std::string> errors{ scene.Pass->ErrorText };
  for (Scene::Object* object : scene.Objects())
  {
    errors.push_back(object->Mapper->GetErrorText());
  }
  for (const std::string& error : errors)
  {
    if (!error.empty())
    {
      throw brdf::Error(brdf::Error::Kind::Value, { error, {}, {}, {} });
    }
  }
  if (scene.Pass->Pixels.empty())
  {
    throw brdf::Error(brdf::Error::Kind::Device, { "nothing was drawn", {}, scene.Window->GetDeviceDescription(), {} });
  }
  vtkImageData* output = vtkImageData::GetData(outputs);
  this->Compose(output);
  if (this->Mode == MODE_CONVERGING)
  {
    output->GetPointData()->AddArray(this->StandardError->GetPointData()->GetScalars());
  }
  return 1;
}

// Draws frame after frame and leaves their mean in the pass, their standard error in StandardError.
void vtkBRDFRender::Converge()
{
  Scene& scene = this->GetScene();
  vtkBRDFRadiancePass* pass = scene.Pass;
  vtkBRDFConvergence convergence(
    this->Size[0], this->Size[1], this->MaximumSamples, this->Tolerance, this->EdgeSamples > 1);
  this->SamplesDrawn = 0;
  this->RelativeError = convergence.RelativeError();
  this->Converged = false;
  const auto beforeFrame = pass->BeforeFrame;
  pass->BeforeFrame = [&](int number, const std::vector<float>* wanted)
  {
    scene.CastShadows(number, wanted);
    const vtkBRDFConvergence::Frame& frame = convergence.Next();
    for (Scene::Object* object : scene.Objects())
    {
      object->Mapper->SetSeed(vtkBRDFConvergence::Replicates * this->Seed + frame.Replicate);
      object->Mapper->SetFrame(frame.First, frame.Count);
    }
  };
  std::copy_n(convergence.Next().Offset, 2, pass->Offset);
  pass->AfterFrame = [&]
  {
    for (Scene::Object* object : scene.Objects())
    {
      if (!object->Mapper->GetErrorText().empty())
      {
        return false;
      }
    }
    const bool more = convergence.Add(pass->Pixels);
    std::copy_n(convergence.Next().Offset, 2, pass->Offset);
    this->SamplesDrawn = static_cast<int>(convergence.Film().points());
    this->RelativeError = convergence.RelativeError();
    this->UpdateProgress(static_cast<double>(this->SamplesDrawn) / this->MaximumSamples);
    return more && !(this->GetAbortExecute() && convergence.HasPicture());
  };
  scene.Window->Render();
  pass->BeforeFrame = beforeFrame;
  pass->AfterFrame = nullptr;
  if (!pass->ErrorText.empty() || !convergence.HasPicture())
  {
    return;
  }
  this->Converged = convergence.Converged();
  this->RelativeError = convergence.RelativeError();
  pass->Pixels = convergence.Film().mean().values;
  const brdf::Image error = convergence.Film().standardError();
  this->StandardError->SetDimensions(this->Size[0], this->Size[1], 1);
  this->StandardError->AllocateScalars(VTK_FLOAT, 3);
  this->StandardError->GetPointData()->GetScalars()->SetName("standard error");
  std::copy(error.values.begin(), error.values.end(), static_cast<float*>(this->StandardError->GetScalarPointer()));
  if (convergence.Film().notFinite() > 0)
  {
    vtkWarningMacro(<< convergence.Film().notFinite() << " values of frames were not finite and counted as 0");
  }
}

vtkCamera* vtkBRDFRender::GetActiveCamera()
{
  return this->Graphics ? this->Graphics->Renderer->GetActiveCamera() : nullptr;
}

std::string vtkBRDFRender::GetDeviceDescription()
{
  return this->GetScene().Window->GetDeviceDescription();
}

double vtkBRDFRender::GetResamplingError()
{
  double error = -1;
  if (this->Graphics)
  {
    for (Scene::Object* object : this->Graphics->Objects())
    {
      error = std::max(error, object->Mapper->GetResampled() ? object->Mapper->GetResamplingError() : -1);
    }
  }
  return error;
}

std::string vtkBRDFRender::GetTableLayouts()
{
  std::string lines;
  if (this->Graphics)
  {
    for (Scene::Object* object : this->Graphics->Objects())
    {
      const std::string layout = object->Mapper->GetTableLayout();
      lines += layout.empty() ? layout : layout + "\n";
    }
  }
  return lines;
}

int vtkBRDFRender::GetNumberOfShaderBuilds()
{
  int builds = 0;
  if (this->Graphics)
  {
    for (Scene::Object* object : this->Graphics->Objects())
    {
      builds += object->Mapper->GetNumberOfShaderBuilds();
    }
  }
  return builds;
}

void vtkBRDFRender::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size[0] << " x " << this->Size[1] << "\n"
     << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n"
     << indent << "DesiredUpdateRate: " << this->DesiredUpdateRate << "\n"
     << indent << "LevelBias: " << this->LevelBias << "\n"
     << indent << "Mode: " << this->Mode << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "MaximumSamples: " << this->MaximumSamples << "\n"
     << indent << "Sequence: " << this->Sequence << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "ResamplingTolerance: " << this->ResamplingTolerance << "\n"
     << indent << "EdgeSamples: " << this->EdgeSamples << "\n"
     << indent << "Exposure: " << this->Exposure << "\n"
     << indent << "Illuminant: " << this->Illuminant << "\n"
     << indent << "Observer: " << this->Observer << "\n"
     << indent << "Adaptation: " << this->Adaptation << "\n"
     << indent << "Environment: " << this->Environment << "\n"
     << indent << "Camera: " << this->Camera << "\n"
     << indent << "Background: " << this->Background << "\n"
     << indent << "BackgroundBlur: " << this->BackgroundBlur << "\n"
     << indent << "Azimuth: " << this->Azimuth << ", Elevation: " << this->Elevation
     << ", ViewAngle: " << this->ViewAngle << "\n";
}
