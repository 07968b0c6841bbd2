#ifndef vtkBRDFTransportStates_h
#define vtkBRDFTransportStates_h
// What the rays of the "gpu" backend are between two draws. For .cxx files only.

#include "vtkBRDFDeviceObjects.h"

#include <array>
#include <cstdint>
#include <vector>

// Six textures of one texel a ray, with the framebuffer that draws them.
class vtkBRDFTransportStates
{
public:
  // Of one texture: the output of the shader, its input, and whether texels are four words or four floats.
  struct Texture
  {
    const char* Output;
    const char* Input;
    bool Words;
  };
  static const std::array<Texture, 6> Textures;
  enum Index : std::size_t
  {
    Directions = 1,
    Weights = 2,
    Absorbed = 3,
    States = 5
  };
  static constexpr GLsizei Width = 512;
  static GLsizei RowsOf(std::size_t rays);

  // Throws brdf::Error (kind Device) where the device has no such framebuffer.
  explicit vtkBRDFTransportStates(GLsizei rows);

  void BindForDrawing() const { glBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer.Name()); }
  // To units 0 to 5.
  void BindTextures() const;

  // The first rows of the set that is bound for drawing.
  static void Read(Index index, GLsizei rows, std::vector<std::array<float, 4>>& to);
  static void Read(Index index, GLsizei rows, std::vector<std::array<std::uint32_t, 4>>& to);

private:
  vtkBRDFDeviceName Framebuffer;
  std::vector<vtkBRDFDeviceName> Names;
};

#endif
