#include "vtkBRDFRenderGraphics.h"

#include "vtkBRDFEnvironment.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <brdf/base/Error.h>
#include <brdf/render/Scene.h>

#include <algorithm>
#include <cmath>

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

void vtkBRDFRender::AddObject(vtkPolyData* surface, vtkBRDF* material, vtkMatrix4x4* placement)
{
  auto object = std::make_unique<Scene::Object>();
  object->Material->ShallowCopy(material);
  try
  {
    object->Surface = surface ? vtkBRDFSurface::Complete(surface) : nullptr;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return;
  }
  object->Actor->SetUserMatrix(placement);
  this->GetScene().Add(*object);
  this->GetScene().Others.push_back(std::move(object));
  this->Modified();
}

void vtkBRDFRender::RemoveAllObjects()
{
  Scene& scene = this->GetScene();
  for (const auto& object : scene.Others)
  {
    scene.Renderer->RemoveActor(object->Actor);
  }
  scene.Others.clear();
  this->Modified();
}

void vtkBRDFRender::AddDirectionalLight(double theta, double phi, double r, double g, double b)
{
  theta = vtkMath::RadiansFromDegrees(theta);
  phi = vtkMath::RadiansFromDegrees(phi);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(false);
  light->SetFocalPoint(0, 0, 0);
  light->SetPosition(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
  light->SetColor(r, g, b);
  this->GetScene().Renderer->AddLight(light);
  this->Modified();
}

void vtkBRDFRender::AddPointLight(double x, double y, double z, double r, double g, double b)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(true);
  light->SetPosition(x, y, z);
  light->SetColor(r, g, b);
  this->GetScene().Renderer->AddLight(light);
  this->Modified();
}

void vtkBRDFRender::RemoveAllLights()
{
  this->GetScene().Renderer->RemoveAllLights();
  this->Modified();
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
