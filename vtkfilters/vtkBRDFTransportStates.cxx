#include "vtkBRDFTransportStates.h"

#include <brdf/base/Error.h>

namespace
{
using brdf::Error;

template<class Texel>
void ReadTexels(std::size_t index, GLsizei rows, GLenum format, GLenum type, std::vector<Texel>& to)
{
  constexpr GLsizei width = vtkBRDFTransportStates::Width;
  to.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows));
  glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(index));
  glReadPixels(0, 0, width, rows, format, type, to.data());
}
}

const std::array<vtkBRDFTransportStates::Texture, 6> vtkBRDFTransportStates::Textures = {
  { { "brdfPosition", "brdfPositions", false },
    { "brdfDirection", "brdfDirections", false },
    { "brdfWeight", "brdfWeights", false },
    { "brdfAbsorption", "brdfAbsorbed", false },
    { "brdfCount", "brdfCounts", true },
    { "brdfState", "brdfStates", true } }
};

GLsizei vtkBRDFTransportStates::RowsOf(std::size_t rays)
{
  return static_cast<GLsizei>((rays + Width - 1) / static_cast<std::size_t>(Width));
}

vtkBRDFTransportStates::vtkBRDFTransportStates(GLsizei rows)
  : Framebuffer(vtkBRDFDeviceName::Framebuffer())
{
  this->BindForDrawing();
  std::array<GLenum, std::tuple_size_v<decltype(Textures)>> attachments;
  glActiveTexture(GL_TEXTURE0);
  for (std::size_t k = 0; k < attachments.size(); ++k)
  {
    attachments[k] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(k);
    this->Names.push_back(vtkBRDFDeviceName::Texture());
    glBindTexture(GL_TEXTURE_2D, this->Names[k].Name());
    vtkBRDFDescribeTexture(GL_TEXTURE_2D);
    const bool words = Textures[k].Words;
    const GLint inside = words ? GL_RGBA32UI : GL_RGBA32F;
    const GLenum format = words ? GL_RGBA_INTEGER : GL_RGBA, type = words ? GL_UNSIGNED_INT : GL_FLOAT;
    glTexImage2D(GL_TEXTURE_2D, 0, inside, Width, rows, 0, format, type, nullptr);
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachments[k], GL_TEXTURE_2D, this->Names[k].Name(), 0);
  }
  glBindTexture(GL_TEXTURE_2D, 0);
  glDrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    throw Error(Error::Kind::Device,
                { "no framebuffer of six 32-bit textures", "gpu backend", {}, "an OpenGL 3.2 device that has them" });
  }
}

void vtkBRDFTransportStates::BindTextures() const
{
  for (std::size_t k = 0; k < this->Names.size(); ++k)
  {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(k));
    glBindTexture(GL_TEXTURE_2D, this->Names[k].Name());
  }
}

void vtkBRDFTransportStates::Read(Index index, GLsizei rows, std::vector<std::array<float, 4>>& to)
{
  ReadTexels(index, rows, GL_RGBA, GL_FLOAT, to);
}

void vtkBRDFTransportStates::Read(Index index, GLsizei rows, std::vector<std::array<std::uint32_t, 4>>& to)
{
  ReadTexels(index, rows, GL_RGBA_INTEGER, GL_UNSIGNED_INT, to);
}
