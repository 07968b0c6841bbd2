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
    this->LightTexture = nullptr;
    this->RowsTexture = nullptr;
    this->Window = nullptr;
  }
  // All that there are.
  template<class Action>
  void ForEachTexture(Action action)
  {
    for (vtkTextureObject* texture : { this->RadianceTexture.Get(),
                                       this->FootprintTexture.Get(),
                                       this->DiffuseTexture.Get(),
                                       this->LightTexture.Get(),
                                       this->RowsTexture.Get() })
    {
      if (texture)
      {
        action(texture);
      }
    }
  }
  void UploadLight(vtkOpenGLRenderWindow* window);

  brdf::EnvironmentMap Map = brdf::EnvironmentMap::constant({ 1, 1, 1 });
  std::optional<brdf::OctahedralMap> Radiance;
  brdf::Image Diffuse;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkTextureObject> RadianceTexture, FootprintTexture, DiffuseTexture;
  float FootprintUnit = 1;
  vtkSmartPointer<vtkTextureObject> LightTexture, RowsTexture; // for unfiltered light
};

// The map itself with the tables of its density: see brdf_light.glsl.
void vtkBRDFEnvironment::Internals::UploadLight(vtkOpenGLRenderWindow* window)
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
  this->LightTexture =
    Upload(texels.data(), this->Map.width(), this->Map.height(), vtkTextureObject::ClampToEdge, window);
  this->RowsTexture = Upload(rowTexels.data(), rows.size(), 1, vtkTextureObject::ClampToEdge, window);
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
  if (data.Window != window || !data.RadianceTexture || !data.RadianceTexture->GetHandle())
  {
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
    data.FootprintTexture = vtkBRDFTextureBuffer::Make(
      window, "the environment map", footprints.words.data(), footprints.words.size() / 4, 4);
    data.FootprintUnit = footprints.unit;
    data.DiffuseTexture =
      Upload(data.Diffuse.values.data(), data.Diffuse.width, data.Diffuse.height, vtkTextureObject::Repeat, window);
    data.Window = window;
  }
  if (unfiltered && !data.LightTexture)
  {
    data.UploadLight(window);
  }
}

void vtkBRDFEnvironment::ActivateTextures()
{
  this->Data->ForEachTexture([](vtkTextureObject* texture) { texture->Activate(); });
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
  if (data.LightTexture)
  {
    program->SetUniformi("brdfLightPicture", data.LightTexture->GetTextureUnit());
    program->SetUniformi("brdfLightRows", data.RowsTexture->GetTextureUnit());
  }
}

void vtkBRDFEnvironment::DeactivateTextures()
{
  this->Data->ForEachTexture([](vtkTextureObject* texture) { texture->Deactivate(); });
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
