// vtkBRDFRender drawing a scene of the core.
#include "vtkBRDF.h"
#include "vtkBRDFEnvironment.h"
#include "vtkBRDFImageConversion.h"
#include "vtkBRDFRender.h"
#include "vtkBRDFSurface.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <brdf/base/Error.h>
#include <brdf/io/EnvironmentMap.h>
#include <brdf/render/Scene.h>

#include <cmath>

namespace
{
vtkSmartPointer<vtkMatrix4x4> Matrix(const brdf::Placement& placement)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 3; ++row)
  {
    const auto r = static_cast<std::size_t>(row);
    for (int column = 0; column < 3; ++column)
    {
      matrix->SetElement(row, column, placement.scale * placement.axes[static_cast<std::size_t>(column)][r]);
    }
    matrix->SetElement(row, 3, placement.shift[r]);
  }
  return matrix;
}

// The kinds of background have the same numbers here and there.
static_assert(static_cast<int>(brdf::SceneBackground::Kind::Environment) == vtkBRDFRender::BACKGROUND_ENVIRONMENT);
static_assert(static_cast<int>(brdf::SceneBackground::Kind::Colour) == vtkBRDFRender::BACKGROUND_COLOR);
static_assert(static_cast<int>(brdf::SceneBackground::Kind::Picture) == vtkBRDFRender::BACKGROUND_IMAGE);
static_assert(static_cast<int>(brdf::SceneBackground::Kind::Transparent) == vtkBRDFRender::BACKGROUND_TRANSPARENT);
}

void vtkBRDFRender::SetScene(const brdf::Scene& scene)
{
  brdf::checkScene(scene);
  constexpr std::size_t lights = 8; // what the shader has room for
  if (scene.lights.size() > lights)
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "too many lights for the shader",
                        "scene",
                        std::to_string(scene.lights.size()),
                        "at most " + std::to_string(lights) + ", or the reference renderer" });
  }
  this->RemoveAllObjects();
  for (const brdf::SceneObject& object : scene.objects)
  {
    vtkNew<vtkBRDF> material;
    material->SetBrdf(scene.materials[object.material]);
    const vtkSmartPointer<vtkPolyData> surface = object.mesh ? vtkBRDFSurface::FromMesh(*object.mesh) : nullptr;
    this->AddObject(surface, material, Matrix(object.placement));
  }
  this->RemoveAllLights();
  for (const brdf::SceneLight& light : scene.lights)
  {
    const auto& [x, y, z] = light.position;
    const auto& [r, g, b] = light.rgb;
    if (light.kind == brdf::SceneLight::Kind::Point)
    {
      this->AddPointLight(x, y, z, r, g, b);
      continue;
    }
    const brdf::Direction d = brdf::normalized(light.position);
    this->AddDirectionalLight(
      brdf::degrees(std::atan2(std::hypot(d[0], d[2]), d[1])), brdf::degrees(std::atan2(d[0], d[2])), r, g, b);
  }
  if (!scene.environment)
  {
    this->SetEnvironment(nullptr);
    this->SceneMap.reset();
  }
  else
  {
    const bool same =
      this->Environment && this->SceneMap == scene.environment->map && this->SceneMapScale == scene.environment->scale;
    if (!same) // its textures take a while to make
    {
      vtkNew<vtkBRDFEnvironment> environment;
      environment->SetMap(*scene.environment->map, scene.environment->scale);
      this->SetEnvironment(environment);
      this->SceneMap = scene.environment->map;
      this->SceneMapScale = scene.environment->scale;
    }
    this->Environment->SetRotation(scene.environment->rotation);
  }
  this->SetBackground(static_cast<int>(scene.background.kind));
  this->SetBackgroundColor(scene.background.rgb[0], scene.background.rgb[1], scene.background.rgb[2]);
  this->SetBackgroundImage(scene.background.picture ? vtkBRDFImageConversion::ToVtk(*scene.background.picture).Get()
                                                    : nullptr);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(scene.camera.position.data());
  camera->SetFocalPoint(scene.camera.target.data());
  camera->SetViewUp(scene.camera.up.data());
  camera->SetViewAngle(scene.camera.viewAngle);
  this->SetCamera(camera);
  this->SetSize(static_cast<int>(scene.width), static_cast<int>(scene.height));
}
