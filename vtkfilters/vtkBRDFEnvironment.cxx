#include "vtkBRDFEnvironment.h"

#include "vtkBRDFTextureBuffer.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <brdf/base/Error.h>
#include <brdf/io/EnvironmentMap.h>
#include <brdf/io/EnvironmentSampler.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <optional>

namespace
{
// A world direction in the coordinates of the map.
brdf::Direction Unrotated(const double direction[3], double degrees)
{
  const double angle = brdf::radians(degrees), c = std::cos(angle), s = std::sin(angle);
  return brdf::normalized({ c * direction[0] - s * direction[2], direction[1], s * direction[0] + c * direction[2] });
}

// A picture of four floats a texel on the device, read bilinearly.
vtkSmartPointer<vtkTextureObject> Upload(const float* texels,
                                         std::size_t width,
                                         std::size_t height,
                                         int wrap,
                                         vtkOpenGLRenderWindow* window)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetWrapS(wrap);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  const auto largest = static_cast<std::size_t>(vtkTextureObject::GetMaximumTextureSize(window));
  // VTK's signature wants a pointer to what is not constant; it reads only.
  if (std::max(width, height) > largest ||
      !texture->Create2DFromRaw(
        static_cast<unsigned int>(width), static_cast<unsigned int>(height), 4, VTK_FLOAT, const_cast<float*>(texels)))
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
  // What a window's device holds: windows that share an environment draw in turn.
  struct Textures
  {
    vtkWeakPointer<vtkOpenGLRenderWindow> Window;
    vtkSmartPointer<vtkTextureObject> Radiance, Footprints, Diffuse;
    vtkSmartPointer<vtkTextureObject> Light, Rows; // for unfiltered light; else null
    float FootprintUnit = 1;

    // All that there are.
    template<class Action>
    void ForEach(Action action)
    {
      for (vtkTextureObject* texture :
           { this->Radiance.Get(), this->Footprints.Get(), this->Diffuse.Get(), this->Light.Get(), this->Rows.Get() })
      {
        if (texture)
        {
          action(texture);
        }
      }
    }
  };

  // Takes a map and forgets what was made from the last one.
  void SetMap(brdf::EnvironmentMap map)
  {
    this->Map = std::move(map);
    this->Radiance.reset();
    this->Current = nullptr;
    this->Windows.clear();
  }
  // Forgets what a window holds, and what windows held that are gone.
  void Release(vtkWindow* window)
  {
    this->Windows.remove_if(
      [&](const Textures& held)
      {
        const bool gone = !held.Window || held.Window == window;
        this->Current = gone && this->Current == &held ? nullptr : this->Current;
        return gone;
      });
  }
  void Upload(Textures& textures, vtkOpenGLRenderWindow* window);
  void UploadLight(Textures& textures, vtkOpenGLRenderWindow* window) const;

  brdf::EnvironmentMap Map = brdf::EnvironmentMap::constant({ 1, 1, 1 });
  std::optional<brdf::OctahedralMap> Radiance;
  brdf::Image Diffuse;
  std::list<Textures> Windows;
  Textures* Current = nullptr; // of the drawing at hand
};

void vtkBRDFEnvironment::Internals::Upload(Textures& textures, vtkOpenGLRenderWindow* window)
{
  const brdf::OctahedralMap& radiance = *this->Radiance;
  textures.Radiance =
    ::Upload(radiance.picture().data(), radiance.width(), radiance.height(), vtkTextureObject::ClampToEdge, window);
  const brdf::OctahedralMap::Footprints footprints = radiance.footprints();
  textures.Footprints =
    vtkBRDFTextureBuffer::Make(window, "the environment map", footprints.words.data(), footprints.words.size() / 4, 4);
  textures.FootprintUnit = footprints.unit;
  textures.Diffuse =
    ::Upload(this->Diffuse.values.data(), this->Diffuse.width, this->Diffuse.height, vtkTextureObject::Repeat, window);
  textures.Window = window;
}

// The map itself with the tables of its density: see brdf_light.glsl.
void vtkBRDFEnvironment::Internals::UploadLight(Textures& textures, vtkOpenGLRenderWindow* window) const
{
  const brdf::EnvironmentSampler sampler(this->Map);
  const std::vector<float> columns = sampler.columnShares(), rows = sampler.rowShares();
  std::vector<float> texels(4 * columns.size()), rowTexels(4 * rows.size());
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    std::copy_n(this->Map.picture().values.data() + 3 * i, 3, texels.data() + 4 * i);
    texels[4 * i + 3] = columns[i];
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    rowTexels[4 * i + 3] = rows[i];
  }
  textures.Light =
    ::Upload(texels.data(), this->Map.width(), this->Map.height(), vtkTextureObject::ClampToEdge, window);
  textures.Rows = ::Upload(rowTexels.data(), rows.size(), 1, vtkTextureObject::ClampToEdge, window);
}

vtkStandardNewMacro(vtkBRDFEnvironment);

vtkBRDFEnvironment::vtkBRDFEnvironment()
  : Data(std::make_unique<Internals>())
{
}

vtkBRDFEnvironment::~vtkBRDFEnvironment() = default;

bool vtkBRDFEnvironment::ReadFile(const std::string& path)
{
  return this->Read(path, false);
}

bool vtkBRDFEnvironment::ReadAngularFile(const std::string& path)
{
  return this->Read(path, true);
}

bool vtkBRDFEnvironment::Read(const std::string& path, bool angular)
{
  using Mapping = brdf::EnvironmentMap::Mapping;
  this->ErrorText.clear();
  try
  {
    this->Data->SetMap(brdf::EnvironmentMap::read(path, angular ? Mapping::Angular : Mapping::Equirectangular));
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

void vtkBRDFEnvironment::UpdateTextures(vtkOpenGLRenderWindow* window, bool unfiltered)
{
  Internals& data = *this->Data;
  if (!data.Radiance)
  {
    data.Radiance = data.Map.radianceMap(static_cast<std::size_t>(this->GetMapSize()));
    data.Diffuse = data.Map.diffuseMap();
  }
  auto held = std::find_if(data.Windows.begin(),
                           data.Windows.end(),
                           [&](const Internals::Textures& textures) { return textures.Window == window; });
  if (held == data.Windows.end() || !held->Radiance->GetHandle())
  {
    data.Release(window);
    Internals::Textures textures;
    data.Upload(textures, window);
    held = data.Windows.insert(data.Windows.end(), textures);
  }
  if (unfiltered && !held->Light)
  {
    data.UploadLight(*held, window);
  }
  data.Current = &*held;
}

void vtkBRDFEnvironment::ActivateTextures()
{
  this->Data->Current->ForEach([](vtkTextureObject* texture) { texture->Activate(); });
}

void vtkBRDFEnvironment::SetUniforms(vtkShaderProgram* program)
{
  const Internals& data = *this->Data;
  const Internals::Textures& textures = *data.Current;
  const float texel[2] = { 1.0f / static_cast<float>(data.Radiance->width()),
                           1.0f / static_cast<float>(data.Radiance->height()) };
  program->SetUniformi("brdfRadiancePicture", textures.Radiance->GetTextureUnit());
  program->SetUniformi("brdfFootprints", textures.Footprints->GetTextureUnit());
  program->SetUniformf("brdfFootprintUnit", textures.FootprintUnit);
  program->SetUniformf("brdfRadianceMap.size", static_cast<float>(data.Radiance->size()));
  program->SetUniformf("brdfRadianceMap.last", static_cast<float>(data.Radiance->levels() - 1));
  program->SetUniform2f("brdfRadianceMap.texel", texel);
  program->SetUniformi("brdfDiffusePicture", textures.Diffuse->GetTextureUnit());
  if (textures.Light)
  {
    program->SetUniformi("brdfLightPicture", textures.Light->GetTextureUnit());
    program->SetUniformi("brdfLightRows", textures.Rows->GetTextureUnit());
  }
}

void vtkBRDFEnvironment::DeactivateTextures()
{
  this->Data->Current->ForEach([](vtkTextureObject* texture) { texture->Deactivate(); });
}

void vtkBRDFEnvironment::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Data->Release(window);
}

void vtkBRDFEnvironment::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Map: " << this->GetMapWidth() << " x " << this->GetMapHeight() << "\n"
     << indent << "Rotation: " << this->Rotation << "\n"
     << indent << "MaximumMapSize: " << this->MaximumMapSize << "\n";
}
