// What vtkBRDFRender draws: objects, lights, camera, background and shadows, set up before a picture.
#include "vtkBRDFRenderStage.h"

#include "vtkBRDFColourSettings.h"
#include "vtkBRDFEnvironment.h"

#include "vtkBoundingBox.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <brdf/base/Error.h>
#include <brdf/render/Scene.h>

#include <algorithm>
#include <cmath>

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
    vtkBRDFColourSettings::Copy(this, object->Mapper.Get());
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
