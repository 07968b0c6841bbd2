#include "vtkBRDFRender.h"

#include "vtkBRDF.h"
#include "vtkBRDFEnvironment.h"
#include "vtkBRDFHeadlessRenderWindow.h"
#include "vtkBRDFPolyDataMapper.h"
#include "vtkBRDFRadiancePass.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <cmath>

namespace
{
// A sphere of radius 1 whose normals are exact and whose tangents run around +y. Between vertices the interpolated
// normal is off by at most (edge angle)^2 / 8 = 7.5e-5 rad.
vtkSmartPointer<vtkPolyData> MakeSphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1);
  source->SetThetaResolution(256);
  source->SetPhiResolution(129);
  source->Update();
  vtkSmartPointer<vtkPolyData> sphere = source->GetOutput();
  vtkNew<vtkFloatArray> tangents;
  tangents->SetName("Tangents");
  tangents->SetNumberOfComponents(3);
  tangents->SetNumberOfTuples(sphere->GetNumberOfPoints());
  for (vtkIdType point = 0; point < sphere->GetNumberOfPoints(); ++point)
  {
    double n[3];
    sphere->GetPoint(point, n);
    const double length = std::hypot(n[0], n[2]);
    const double tangent[3] = { length > 0 ? n[2] / length : 1, 0, length > 0 ? -n[0] / length : 0 };
    tangents->SetTuple(point, tangent);
  }
  sphere->GetPointData()->SetTangents(tangents);
  return sphere;
}
}

class vtkBRDFRender::Scene
{
public:
  Scene()
  {
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Pass);
    this->Renderer->AddActor(this->Actor);
    this->Actor->SetMapper(this->Mapper);
    this->Mapper->SetBRDFData(this->Material);
    this->Pass->BeforeFrame = [this](int frame) { this->Mapper->SetSeed(frame); };
  }

  vtkNew<vtkBRDFHeadlessRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkBRDFRadiancePass> Pass;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkBRDFPolyDataMapper> Mapper;
  vtkNew<vtkBRDF> Material;
  vtkNew<vtkCamera> Camera;
  vtkSmartPointer<vtkPolyData> Sphere;
};

vtkStandardNewMacro(vtkBRDFRender);
vtkCxxSetObjectMacro(vtkBRDFRender, Environment, vtkBRDFEnvironment);
vtkCxxSetObjectMacro(vtkBRDFRender, Camera, vtkCamera);

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
  for (vtkObject* part : { static_cast<vtkObject*>(this->Environment), static_cast<vtkObject*>(this->Camera) })
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
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 3);
  return 1;
}

// Sets the camera up; the radius of the object's bounding sphere. Works on a copy, so that drawing changes nothing that
// the pipeline watches.
double vtkBRDFRender::PlaceCamera(const double bounds[6])
{
  Scene& scene = this->GetScene();
  vtkCamera* camera = scene.Camera;
  scene.Renderer->SetActiveCamera(camera);
  // Of the sphere the bounds give the radius itself, of other objects half their diagonal.
  double radius = 1;
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    radius = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]) / 2;
  }
  if (this->Camera)
  {
    camera->DeepCopy(this->Camera);
    scene.Renderer->ResetCameraClippingRange();
    return radius;
  }
  const double center[3] = { (bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2 };
  const double vertical = vtkMath::RadiansFromDegrees(this->ViewAngle) / 2;
  const double aspect = static_cast<double>(this->Size[0]) / this->Size[1];
  const double narrow = std::min(vertical, std::atan(std::tan(vertical) * aspect));
  const double distance = 1.08 * radius / std::sin(narrow);
  const double azimuth = vtkMath::RadiansFromDegrees(this->Azimuth);
  const double elevation = vtkMath::RadiansFromDegrees(this->Elevation);
  vtkNew<vtkCamera> placed;
  placed->SetFocalPoint(center);
  placed->SetPosition(center[0] + distance * std::cos(elevation) * std::sin(azimuth),
                      center[1] + distance * std::sin(elevation),
                      center[2] + distance * std::cos(elevation) * std::cos(azimuth));
  placed->SetViewUp(0, 1, 0);
  placed->SetViewAngle(this->ViewAngle);
  placed->SetClippingRange(std::max(distance - 1.1 * radius, 1e-3 * distance), distance + 1.1 * radius);
  camera->DeepCopy(placed);
  return radius;
}

int vtkBRDFRender::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  Scene& scene = this->GetScene();
  if (!scene.Window->IsAvailable())
  {
    throw brdf::Error(brdf::Error::Kind::Device, { scene.Window->GetErrorText(), {}, {}, {} });
  }
  scene.Material->SetBrdf(GetInputBrdf(inputs));

  vtkPolyData* object = vtkPolyData::GetData(inputs[1]);
  if (object && object->GetNumberOfCells() == 0)
  {
    throw brdf::Error(brdf::Error::Kind::Value, { "the object to render is empty", {}, "no cells", {} });
  }
  if (object && !object->GetPointData()->GetNormals())
  {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(object);
    normals->SetFeatureAngle(40);
    normals->Update();
    scene.Mapper->SetInputDataObject(normals->GetOutput());
  }
  else if (object)
  {
    scene.Mapper->SetInputDataObject(object);
  }
  else
  {
    if (!scene.Sphere)
    {
      scene.Sphere = MakeSphere();
    }
    scene.Mapper->SetInputDataObject(scene.Sphere);
  }
  scene.Mapper->SetEnvironment(this->Environment);
  scene.Mapper->SetNumberOfSamples(this->NumberOfSamples);
  scene.Mapper->SetLevelBias(this->LevelBias);
  scene.Mapper->SetExposure(this->Exposure);
  scene.Mapper->SetIlluminant(this->Illuminant);
  scene.Mapper->SetObserver(this->Observer);
  scene.Mapper->SetAdaptation(this->Adaptation);
  // Neighbours a fiftieth of the object apart in depth are different surfaces.
  scene.Pass->DepthStep = this->PlaceCamera(scene.Mapper->GetBounds()) / 50;

  const bool showsEnvironment = this->Environment && this->Background == BACKGROUND_ENVIRONMENT;
  scene.Renderer->SetBackground(this->BackgroundColor);
  scene.Pass->Background = showsEnvironment ? this->Environment : nullptr;
  if (showsEnvironment)
  {
    const double texel = 260.0 / this->Environment->GetMapSize();
    scene.Pass->BackgroundLevel = std::max(0.0, std::log2(std::max(this->BackgroundBlur, 1e-6) / texel));
    scene.Pass->BackgroundGain = std::exp2(this->Exposure);
  }
  scene.Pass->EdgeSamples = this->EdgeSamples;
  std::copy_n(this->Size, 2, scene.Pass->Size);
  scene.Window->SetSize(this->Size);
  scene.Window->Render();
  for (const std::string& error : { scene.Mapper->GetErrorText(), scene.Pass->ErrorText })
  {
    if (!error.empty())
    {
      throw brdf::Error(brdf::Error::Kind::Value, { error, {}, {}, {} });
    }
  }
  const std::size_t pixels = static_cast<std::size_t>(this->Size[0]) * static_cast<std::size_t>(this->Size[1]);
  if (scene.Pass->Pixels.size() != 4 * pixels)
  {
    throw brdf::Error(brdf::Error::Kind::Device, { "nothing was drawn", {}, scene.Window->GetDeviceDescription(), {} });
  }
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->SetDimensions(this->Size[0], this->Size[1], 1);
  output->AllocateScalars(VTK_FLOAT, 3);
  output->GetPointData()->GetScalars()->SetName("radiance");
  auto* to = static_cast<float*>(output->GetScalarPointer());
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
  {
    std::copy_n(scene.Pass->Pixels.data() + 4 * pixel, 3, to + 3 * pixel);
  }
  return 1;
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

int vtkBRDFRender::GetNumberOfShaderBuilds()
{
  return this->Graphics ? this->Graphics->Mapper->GetNumberOfShaderBuilds() : 0;
}

void vtkBRDFRender::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size[0] << " x " << this->Size[1] << "\n"
     << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n"
     << indent << "LevelBias: " << this->LevelBias << "\n"
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
