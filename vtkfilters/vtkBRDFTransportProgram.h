#ifndef vtkBRDFTransportProgram_h
#define vtkBRDFTransportProgram_h
// The shaders of the "gpu" backend with what they read. For .cxx files only.

#include "vtkBRDFDeviceObjects.h"
#include "vtkBRDFTransportScene.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

class vtkBRDFTransportProgram
{
public:
  // Unit of the texture buffer brdfSources.
  static constexpr GLint SourcesUnit = 6;

  // Compiles for a scene and takes it to the device.
  explicit vtkBRDFTransportProgram(const vtkBRDFTransportScene& scene);

  // What facets and media do with the channels that are traced side by side, at most four. Returns the index of
  // refraction of each medium, of the first of these channels.
  std::array<double, brdf::kMostDielectrics> SetChannels(const vtkBRDFTransportScene& scene,
                                                         std::size_t first,
                                                         std::size_t count);

  // Makes it and its textures current.
  void Use() const;
  GLint Uniform(const char* name) const { return this->Program.Uniform(name); }

private:
  void Upload(const brdf::FieldTexels& field, const vtkBRDFTransportScene& scene);
  void Upload(const brdf::TileTree& tree, const vtkBRDFTransportScene& scene);
  void Upload(const vtkBRDFShaderText& material);
  void UploadFlat(GLint unit, const char* name, std::size_t width, std::size_t height, const void* texels);
  void UploadBuffer(GLint unit, const char* name, const float* texels, std::size_t count);

  vtkBRDFDeviceProgram Program;
  std::vector<std::pair<GLint, vtkBRDFDeviceName>> Flat; // textures with their units
  std::vector<std::pair<GLint, vtkBRDFDeviceBuffer>> Buffers;
  std::optional<vtkBRDFDeviceBuffer> Facets;
};

#endif
