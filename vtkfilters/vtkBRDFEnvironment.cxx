#include "vtkBRDFEnvironment.h"

#include "vtkBRDFCompatibility.h"
#include VTK_BRDF_GL_LOADER_HEADER

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <brdf/base/Error.h>
#include <brdf/io/EnvironmentMap.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace
{
// A world direction in the coordinates of the map.
brdf::Direction Unrotated(const double direction[3], double degrees)
{
  const double angle = brdf::radians(degrees), c = std::cos(angle), s = std::sin(angle);
  return brdf::normalized({ c * direction[0] - s * direction[2], direction[1], s * direction[0] + c * direction[2] });
}

// All levels of a cube map as a float texture, filtered across the edges of faces.
vtkSmartPointer<vtkTextureObject> Upload(const brdf::CubeMap& map, vtkOpenGLRenderWindow* window)
{
  const auto& levels = map.levels();
  const auto faces = [](const brdf::CubeMap::Level& level)
  {
    std::array<void*, 6> pointers{};
    for (std::size_t face = 0; face < 6; ++face)
    {
      pointers[face] = const_cast<float*>(level.face(face)); // VTK's signature; it reads only
    }
    return pointers;
  };
  vtkNew<vtkTextureObject> texture;
  texture->SetContext(window);
  auto finest = faces(levels[0]);
  const auto size = static_cast<unsigned int>(levels[0].size);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetMinificationFilter(levels.size() > 1 ? vtkTextureObject::LinearMipmapLinear : vtkTextureObject::Linear);
  texture->SetBaseLevel(0);
  texture->SetMaxLevel(static_cast<int>(levels.size()) - 1);
  if (!texture->CreateCubeFromRaw(size, size, 4, VTK_FLOAT, finest.data()))
  {
    throw brdf::Error(brdf::Error::Kind::Device,
                      { "cannot make a cube map texture", {}, std::to_string(size) + " texels a side", {} });
  }
  texture->Activate();
  for (std::size_t level = 1; level < levels.size(); ++level)
  {
    const auto side = static_cast<GLsizei>(levels[level].size);
    const auto pointers = faces(levels[level]);
    for (unsigned int face = 0; face < 6; ++face)
    {
      glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face,
                   static_cast<GLint>(level),
                   GL_RGBA32F,
                   side,
                   side,
                   0,
                   GL_RGBA,
                   GL_FLOAT,
                   pointers[face]);
    }
  }
  texture->SendParameters();
  texture->Deactivate();
  window->GetState()->vtkglEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  return texture;
}
}

class vtkBRDFEnvironment::Internals
{
public:
  void SetMap(brdf::EnvironmentMap map)
  {
    this->Map = std::move(map);
    this->Reset();
  }
  void Reset()
  {
    this->Radiance.reset();
    this->Diffuse.reset();
    this->Release();
  }
  void Release()
  {
    this->RadianceTexture = nullptr;
    this->DiffuseTexture = nullptr;
    this->Window = nullptr;
  }
  void UseWindow(vtkOpenGLRenderWindow* window)
  {
    if (this->Window != window)
    {
      this->Release();
      this->Window = window;
    }
  }

  brdf::EnvironmentMap Map = brdf::EnvironmentMap::constant({ 1, 1, 1 });
  std::optional<brdf::CubeMap> Radiance, Diffuse;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkTextureObject> RadianceTexture, DiffuseTexture;
};

vtkStandardNewMacro(vtkBRDFEnvironment);

vtkBRDFEnvironment::vtkBRDFEnvironment()
  : Data(std::make_unique<Internals>())
{
}

vtkBRDFEnvironment::~vtkBRDFEnvironment() = default;

bool vtkBRDFEnvironment::ReadFile(const std::string& path)
{
  this->ErrorText.clear();
  try
  {
    this->Data->SetMap(brdf::EnvironmentMap::read(path));
  }
  catch (const std::exception& error)
  {
    this->ErrorText = error.what();
    vtkErrorMacro(<< this->ErrorText);
    return false;
  }
  this->Modified();
  return true;
}

void vtkBRDFEnvironment::SetConstant(double red, double green, double blue)
{
  this->Data->SetMap(brdf::EnvironmentMap::constant({ red, green, blue }));
  this->Modified();
}

void vtkBRDFEnvironment::SetMaximumFaceSize(int size)
{
  size = std::max(1, std::min(size, 4096));
  if (size != this->MaximumFaceSize)
  {
    this->MaximumFaceSize = size;
    this->Data->Reset();
    this->Modified();
  }
}

int vtkBRDFEnvironment::GetMapWidth() const
{
  return static_cast<int>(this->Data->Map.width());
}

int vtkBRDFEnvironment::GetMapHeight() const
{
  return static_cast<int>(this->Data->Map.height());
}

int vtkBRDFEnvironment::GetFaceSize() const
{
  return static_cast<int>(this->Data->Map.faceSize(static_cast<std::size_t>(this->MaximumFaceSize)));
}

void vtkBRDFEnvironment::GetRadiance(const double direction[3], double rgb[3]) const
{
  const auto value = this->Data->Map.radiance(Unrotated(direction, this->Rotation));
  std::copy(value.begin(), value.end(), rgb);
}

void vtkBRDFEnvironment::GetIrradiance(const double normal[3], double rgb[3]) const
{
  const auto value = this->Data->Map.irradiance(Unrotated(normal, this->Rotation));
  std::copy(value.begin(), value.end(), rgb);
}

const brdf::EnvironmentMap& vtkBRDFEnvironment::GetMap() const
{
  return this->Data->Map;
}

vtkTextureObject* vtkBRDFEnvironment::GetRadianceTexture(vtkOpenGLRenderWindow* window)
{
  this->Data->UseWindow(window);
  if (!this->Data->RadianceTexture || !this->Data->RadianceTexture->GetHandle())
  {
    if (!this->Data->Radiance)
    {
      this->Data->Radiance = this->Data->Map.radianceCube(static_cast<std::size_t>(this->GetFaceSize()));
    }
    this->Data->RadianceTexture = Upload(*this->Data->Radiance, window);
  }
  return this->Data->RadianceTexture;
}

vtkTextureObject* vtkBRDFEnvironment::GetDiffuseTexture(vtkOpenGLRenderWindow* window)
{
  this->Data->UseWindow(window);
  if (!this->Data->DiffuseTexture || !this->Data->DiffuseTexture->GetHandle())
  {
    if (!this->Data->Diffuse)
    {
      this->Data->Diffuse = this->Data->Map.diffuseCube();
    }
    this->Data->DiffuseTexture = Upload(*this->Data->Diffuse, window);
  }
  return this->Data->DiffuseTexture;
}

void vtkBRDFEnvironment::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Data->Window == window)
  {
    this->Data->Release();
  }
}

void vtkBRDFEnvironment::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Map: " << this->GetMapWidth() << " x " << this->GetMapHeight() << "\n"
     << indent << "Rotation: " << this->Rotation << "\n"
     << indent << "MaximumFaceSize: " << this->MaximumFaceSize << "\n";
}
