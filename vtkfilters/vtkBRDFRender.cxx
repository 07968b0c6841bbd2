#include "vtkBRDFRender.h"

#include "vtkBRDF.h"
#include "vtkBRDFConvergence.h"
#include "vtkBRDFEnvironment.h"
#include "vtkBRDFHeadlessRenderWindow.h"
#include "vtkBRDFImageConversion.h"
#include "vtkBRDFPolyDataMapper.h"
#include "vtkBRDFRadiancePass.h"
#include "vtkBRDFShadows.h"
#include "vtkBRDFSurface.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkWeakPointer.h"

#include <brdf/base/Error.h>
#include <brdf/render/Scene.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
// A thing in the world, for rays. A sphere stays round where its matrix keeps angles, as ours do.
brdf::SceneObject PlacedObject(vtkPolyData* surface, vtkMatrix4x4* matrix)
{
  brdf::SceneObject object;
  if (!surface)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        object.placement.axes[axis][k] = matrix->GetElement(static_cast<int>(k), static_cast<int>(axis));
      }
      object.placement.shift[k] = matrix->GetElement(static_cast<int>(k), 3);
    }
    object.placement.scale = std::sqrt(brdf::dot(object.placement.axes[0], object.placement.axes[0]));
    for (brdf::Direction& axis : object.placement.axes)
    {
      axis = brdf::normalized(axis);
    }
    return object;
  }
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputData(surface);
  filter->SetTransform(transform);
  filter->Update();
  object.mesh = std::make_shared<const brdf::TriangleMesh>(vtkBRDFSurface::ToMesh(filter->GetOutput()));
  return object;
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
    this->Add(this->Input);
    this->Pass->BeforeFrame = [this](int frame, const std::vector<float>* wanted)
    {
      this->CastShadows(frame, wanted);
      for (Object* object : this->Objects())
      {
        object->Mapper->SetSeed(64 * this->Seed + frame); // at most 64 frames: EdgeSamples
      }
    };
  }

  // One thing of one material.
  struct Object
  {
    vtkNew<vtkActor> Actor;
    vtkNew<vtkBRDFPolyDataMapper> Mapper;
    vtkNew<vtkBRDF> Material;
    vtkSmartPointer<vtkPolyData> Surface; // null for the sphere
  };

  void Add(Object& object)
  {
    object.Mapper->SetBRDFData(object.Material);
    object.Actor->SetMapper(object.Mapper);
    this->Renderer->AddActor(object.Actor);
  }

  void CastShadows(int frame, const std::vector<float>* wanted)
  {
    if (this->CastsShadows)
    {
      this->Shadows.Cast(this->Renderer, this->Pass->Size, frame, wanted);
    }
  }

  // The input's, where it has a material, and the others.
  std::vector<Object*> Objects()
  {
    std::vector<Object*> objects;
    if (this->Input.Actor->GetVisibility())
    {
      objects.push_back(&this->Input);
    }
    for (const auto& object : this->Others)
    {
      objects.push_back(object.get());
    }
    return objects;
  }

  vtkNew<vtkBRDFHeadlessRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkBRDFRadiancePass> Pass;
  vtkNew<vtkCamera> Camera;
  int Seed = 0;
  bool CastsShadows = false;
  vtkBRDFShadows Shadows;
  Object Input;
  vtkWeakPointer<vtkPolyData> InputSource; // what the input's surface was made from, and its time then
  vtkMTimeType InputTime = 0;
  std::vector<std::unique_ptr<Object>> Others;
  vtkSmartPointer<vtkPolyData> Sphere = vtkBRDFSurface::UnitSphere();
};

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

// What is to be drawn; throws where it cannot be. Needs no device.
void vtkBRDFRender::PrepareObjects(vtkInformationVector** inputs)
{
  Scene& scene = this->GetScene();
  const bool hasInput = this->GetNumberOfInputConnections(0) > 0;
  scene.Input.Actor->SetVisibility(hasInput);
  if (!hasInput && scene.Others.empty())
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "nothing to render", {}, "no material and no objects", "an input, or AddObject" });
  }
  if (hasInput)
  {
    scene.Input.Material->SetBrdf(GetInputBrdf(inputs));
    vtkPolyData* object = vtkPolyData::GetData(inputs[1]);
    const vtkMTimeType time = object ? object->GetMTime() : 0;
    if (object != scene.InputSource || time != scene.InputTime) // a sweep of the material keeps the surface
    {
      scene.Input.Surface = object ? vtkBRDFSurface::Complete(object) : nullptr;
      scene.InputSource = object;
      scene.InputTime = time;
    }
  }
  scene.Window->SetDesiredUpdateRate(std::max(this->DesiredUpdateRate, 1e-4));
  for (Scene::Object* object : scene.Objects())
  {
    object->Mapper->SetInputDataObject(object->Surface ? object->Surface : scene.Sphere);
    object->Mapper->SetEnvironment(this->Environment);
    object->Mapper->SetNumberOfSamples(this->NumberOfSamples);
    object->Mapper->SetAdaptSamples(this->DesiredUpdateRate > 0);
    object->Mapper->SetLevelBias(this->LevelBias);
    object->Mapper->SetResamplingTolerance(this->ResamplingTolerance);
    object->Mapper->SetMode(this->Mode);
    object->Mapper->SetSequence(this->Sequence);
    object->Mapper->SetExposure(this->Exposure);
    object->Mapper->SetIlluminant(this->Illuminant);
    object->Mapper->SetObserver(this->Observer);
    object->Mapper->SetAdaptation(this->Adaptation);
  }
}

// Sets the camera up. Works on a copy, so that drawing changes nothing that the pipeline watches.
void vtkBRDFRender::PrepareCamera()
{
  Scene& scene = this->GetScene();
  scene.Renderer->SetActiveCamera(scene.Camera);
  vtkBoundingBox box;
  double smallest = VTK_DOUBLE_MAX;
  for (Scene::Object* object : scene.Objects())
  {
    const double* bounds = object->Actor->GetBounds();
    box.AddBounds(bounds);
    smallest = std::min(smallest, vtkBoundingBox(bounds).GetDiagonalLength() / 2);
  }
  // Neighbours a fiftieth of the smallest object apart in depth are different surfaces.
  scene.Pass->DepthStep = smallest / 50;
  if (this->Camera)
  {
    scene.Camera->DeepCopy(this->Camera);
    scene.Renderer->ResetCameraClippingRange();
    return;
  }
  // Of the sphere the bounds give the radius itself, of other objects half their diagonal.
  const bool sphere = scene.Others.empty() && !scene.Input.Surface;
  const double radius = sphere ? 1 : box.GetDiagonalLength() / 2;
  brdf::Position center;
  box.GetCenter(center.data());
  const brdf::SceneCamera placed = brdf::cameraAround(center,
                                                      radius,
                                                      this->Azimuth,
                                                      this->Elevation,
                                                      this->ViewAngle,
                                                      static_cast<double>(this->Size[0]) / this->Size[1]);
  const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(placed.position.data(), center.data()));
  vtkNew<vtkCamera> camera;
  camera->SetFocalPoint(placed.target.data());
  camera->SetPosition(placed.position.data());
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(this->ViewAngle);
  camera->SetClippingRange(std::max(distance - 1.1 * radius, 1e-3 * distance), distance + 1.1 * radius);
  scene.Camera->DeepCopy(camera);
}

void vtkBRDFRender::PrepareBackground()
{
  Scene& scene = this->GetScene();
  const bool showsEnvironment = this->Environment && this->Background == BACKGROUND_ENVIRONMENT;
  scene.Renderer->SetBackground(0, 0, 0); // and alpha 0: see Compose
  scene.Pass->Background = showsEnvironment ? this->Environment : nullptr;
  if (showsEnvironment)
  {
    const double texel = 260.0 / this->Environment->GetMapSize();
    scene.Pass->BackgroundLevel = std::max(0.0, std::log2(std::max(this->BackgroundBlur, 1e-6) / texel));
    scene.Pass->BackgroundGain = std::exp2(this->Exposure);
  }
}

// What the shadow rays meet: the same surfaces in the same places.
void vtkBRDFRender::PrepareShadows()
{
  Scene& scene = this->GetScene();
  const std::vector<Scene::Object*> objects = scene.Objects();
  const bool alone = objects.size() == 1 && !objects[0]->Surface;
  scene.CastsShadows = this->Shadows != SHADOWS_NONE && !alone;
  for (Scene::Object* object : objects)
  {
    object->Mapper->SetShadows(scene.CastsShadows ? &scene.Shadows : nullptr);
  }
  if (!scene.CastsShadows)
  {
    return;
  }
  brdf::Scene world;
  for (Scene::Object* object : objects)
  {
    world.objects.push_back(PlacedObject(object->Surface, object->Actor->GetMatrix()));
  }
  vtkCollectionSimpleIterator iterator;
  scene.Renderer->GetLights()->InitTraversal(iterator);
  while (vtkLight* light = scene.Renderer->GetLights()->GetNextLight(iterator))
  {
    const auto kind = light->GetPositional() ? brdf::SceneLight::Kind::Point : brdf::SceneLight::Kind::Directional;
    world.lights.push_back({ kind, { 0, 0, 0 }, { 1, 1, 1 } });
    light->GetPosition(world.lights.back().position.data());
  }
  if (this->Environment)
  {
    // Not owned: it is used at once.
    world.environment = brdf::SceneEnvironment{ std::shared_ptr<const brdf::EnvironmentMap>(
                                                  std::shared_ptr<void>(), &this->Environment->GetMap()),
                                                this->Environment->GetRotation(),
                                                1 };
  }
  scene.Shadows.SetScene(world, this->Shadows == SHADOWS_ALL ? this->ShadowCells : 0);
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
