#include "vtkBRDFEnvironment.h"

#include "vtkBRDFCompatibility.h"
#include VTK_BRDF_GL_LOADER_HEADER

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <brdf/base/Error.h>
#include <brdf/io/EnvironmentMap.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace
{
// A world direction in the coordinates of the map.
brdf::Direction Unrotated(const double direction[3], double degrees)
{
  const double angle = brdf::radians(degrees), c = std::cos(angle), s = std::sin(angle);
  return brdf::normalized({ c * direction[0] - s * direction[2], direction[1], s * direction[0] + c * direction[2] });
}

// A picture of four numbers a texel on the device: floats, read bilinearly, or integers.
template<class Number>
vtkSmartPointer<vtkTextureObject> Upload(const Number* texels,
                                         std::size_t width,
                                         std::size_t height,
                                         int wrap,
                                         vtkOpenGLRenderWindow* window)
{
  constexpr bool integers = std::is_same_v<Number, std::uint32_t>;
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetWrapS(wrap);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMagnificationFilter(integers ? vtkTextureObject::Nearest : vtkTextureObject::Linear);
  texture->SetMinificationFilter(integers ? vtkTextureObject::Nearest : vtkTextureObject::Linear);
  if (integers)
  {
    texture->SetInternalFormat(GL_RGBA32UI);
    texture->SetFormat(GL_RGBA_INTEGER);
    texture->SetDataType(GL_UNSIGNED_INT);
  }
  const auto largest = static_cast<std::size_t>(vtkTextureObject::GetMaximumTextureSize(window));
  // VTK's signature wants a pointer to what is not constant; it reads only.
  if (std::max(width, height) > largest || !texture->Create2DFromRaw(static_cast<unsigned int>(width),
                                                                     static_cast<unsigned int>(height),
                                                                     4,
                                                                     integers ? VTK_UNSIGNED_INT : VTK_FLOAT,
                                                                     const_cast<Number*>(texels)))
  {
    throw brdf::Error(brdf::Error::Kind::Device,
                      { "cannot make the texture of an environment map",
                        {},
                        std::to_string(width) + " x " + std::to_string(height),
                        "at most " + std::to_string(largest) + " texels a side" });
  }
  return texture;
}
}

class vtkBRDFEnvironment::Internals
{
public:
  // Takes a map and forgets what was made from the last one.
  void SetMap(brdf::EnvironmentMap map)
  {
    this->Map = std::move(map);
    this->Radiance.reset();
    this->Release();
  }
  void Release()
  {
    this->RadianceTexture = nullptr;
    this->FootprintTexture = nullptr;
    this->DiffuseTexture = nullptr;
    this->Window = nullptr;
  }

  brdf::EnvironmentMap Map = brdf::EnvironmentMap::constant({ 1, 1, 1 });
  std::optional<brdf::OctahedralMap> Radiance;
  brdf::Image Diffuse;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkTextureObject> RadianceTexture, FootprintTexture, DiffuseTexture;
  float FootprintUnit = 1;
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

void vtkBRDFEnvironment::SetMap(const brdf::EnvironmentMap& map, double scale)
{
  brdf::Image picture = map.picture();
  for (float& value : picture.values)
  {
    value *= static_cast<float>(scale);
  }
  this->Data->SetMap(brdf::EnvironmentMap(picture));
  this->Modified();
}

void vtkBRDFEnvironment::SetMaximumMapSize(int size)
{
  size = std::max(2, std::min(size, 8192));
  if (size != this->MaximumMapSize)
  {
    this->MaximumMapSize = size;
    this->Data->SetMap(std::move(this->Data->Map));
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

int vtkBRDFEnvironment::GetMapSize() const
{
  return static_cast<int>(this->Data->Map.mapSize(static_cast<std::size_t>(this->MaximumMapSize)));
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

void vtkBRDFEnvironment::UpdateTextures(vtkOpenGLRenderWindow* window)
{
  Internals& data = *this->Data;
  if (data.Window == window && data.RadianceTexture && data.RadianceTexture->GetHandle())
  {
    return;
  }
  data.Release();
  if (!data.Radiance)
  {
    data.Radiance = data.Map.radianceMap(static_cast<std::size_t>(this->GetMapSize()));
    data.Diffuse = data.Map.diffuseMap();
  }
  const brdf::OctahedralMap& radiance = *data.Radiance;
  data.RadianceTexture =
    Upload(radiance.picture().data(), radiance.width(), radiance.height(), vtkTextureObject::ClampToEdge, window);
  const brdf::OctahedralMap::Footprints footprints = radiance.footprints();
  data.FootprintTexture =
    Upload(footprints.words.data(), radiance.width(), radiance.height(), vtkTextureObject::ClampToEdge, window);
  data.FootprintUnit = footprints.unit;
  data.DiffuseTexture =
    Upload(data.Diffuse.values.data(), data.Diffuse.width, data.Diffuse.height, vtkTextureObject::Repeat, window);
  data.Window = window;
}

void vtkBRDFEnvironment::ActivateTextures()
{
  this->Data->RadianceTexture->Activate();
  this->Data->FootprintTexture->Activate();
  this->Data->DiffuseTexture->Activate();
}

void vtkBRDFEnvironment::SetUniforms(vtkShaderProgram* program)
{
  const Internals& data = *this->Data;
  const float texel[2] = { 1.0f / static_cast<float>(data.Radiance->width()),
                           1.0f / static_cast<float>(data.Radiance->height()) };
  program->SetUniformi("brdfRadiancePicture", data.RadianceTexture->GetTextureUnit());
  program->SetUniformi("brdfFootprints", data.FootprintTexture->GetTextureUnit());
  program->SetUniformf("brdfFootprintUnit", data.FootprintUnit);
  program->SetUniformf("brdfRadianceMap.size", static_cast<float>(data.Radiance->size()));
  program->SetUniformf("brdfRadianceMap.last", static_cast<float>(data.Radiance->levels() - 1));
  program->SetUniform2f("brdfRadianceMap.texel", texel);
  program->SetUniformi("brdfDiffusePicture", data.DiffuseTexture->GetTextureUnit());
}

void vtkBRDFEnvironment::DeactivateTextures()
{
  this->Data->RadianceTexture->Deactivate();
  this->Data->FootprintTexture->Deactivate();
  this->Data->DiffuseTexture->Deactivate();
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
     << indent << "MaximumMapSize: " << this->MaximumMapSize << "\n";
}
