#include "vtkBRDFShaderProbe.h"

#include "vtkBRDFDeviceObjects.h"
#include "vtkBRDFHeadlessRenderWindow.h"

#include <brdf/base/Error.h>

#include <algorithm>

namespace
{
using brdf::Error;

// Rows of one pass: a texture of at most 1024 x 1024 in each of the columns' layers.
constexpr std::size_t kWidth = 1024;
constexpr std::size_t kHeight = 1024;
constexpr std::size_t kMaximumColumns = 256; // layers that every OpenGL 3.3 has

std::string FragmentSource(const std::string& functions,
                           const std::vector<vtkBRDFShaderProbe::Column>& columns,
                           const std::vector<std::string>& expressions)
{
  std::string text = "#version 330 core\n" + functions +
                     "\nuniform sampler2DArray brdfProbeColumns;\nout vec4 brdfProbeValue;\nvoid main()\n{\n";
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    text += "  float " + columns[k].Name + " = texelFetch(brdfProbeColumns, ivec3(ivec2(gl_FragCoord.xy), " +
            std::to_string(k) + "), 0).r;\n";
  }
  text += "  brdfProbeValue = vec4(0.0);\n";
  for (std::size_t k = 0; k < expressions.size(); ++k)
  {
    text += "  brdfProbeValue[" + std::to_string(k) + "] = " + expressions[k] + ";\n";
  }
  return text + "}\n";
}

}

vtkBRDFShaderProbe::vtkBRDFShaderProbe()
{
  if (!this->Window->IsAvailable())
  {
    throw Error(Error::Kind::Device, { this->Window->GetErrorText(), {}, {}, {} });
  }
  this->Window->Initialize();
}

vtkBRDFShaderProbe::~vtkBRDFShaderProbe() = default;

std::string vtkBRDFShaderProbe::GetDeviceDescription()
{
  return this->Window->GetDeviceDescription();
}

std::vector<std::vector<float>> vtkBRDFShaderProbe::Evaluate(const std::string& functions,
                                                             const std::vector<Column>& columns,
                                                             const std::vector<std::string>& expressions,
                                                             const std::vector<Buffer>& buffers)
{
  if (columns.empty() || columns.size() > kMaximumColumns || expressions.empty() || expressions.size() > 4)
  {
    throw Error(Error::Kind::Value,
                { "wrong number of columns or expressions",
                  "shader probe",
                  std::to_string(columns.size()) + " and " + std::to_string(expressions.size()),
                  "1 to " + std::to_string(kMaximumColumns) + " and 1 to 4" });
  }
  const std::size_t count = columns[0].Values.size();
  for (const Column& column : columns)
  {
    if (column.Values.size() != count)
    {
      throw Error(Error::Kind::Value,
                  { "columns of different lengths",
                    "shader probe, column " + column.Name,
                    std::to_string(column.Values.size()),
                    std::to_string(count) });
    }
  }
  this->Window->MakeCurrent();

  const vtkBRDFDeviceProgram program(FragmentSource(functions, columns, expressions));
  const auto input = vtkBRDFDeviceName::Texture(), output = vtkBRDFDeviceName::Texture();
  const auto framebuffer = vtkBRDFDeviceName::Framebuffer();
  const auto vertices = vtkBRDFDeviceName::VertexArray();
  std::vector<vtkBRDFDeviceBuffer> textures;
  for (const Buffer& buffer : buffers)
  {
    textures.emplace_back(buffer.Texels.data(), buffer.Texels.size() / 4, buffer.Name);
    textures.back().Bind(GL_TEXTURE0 + static_cast<GLenum>(textures.size()));
  }

  const std::size_t passRows = std::min((count + kWidth - 1) / kWidth, kHeight);
  const auto width = static_cast<GLsizei>(kWidth), height = static_cast<GLsizei>(std::max<std::size_t>(passRows, 1));
  const auto layers = static_cast<GLsizei>(columns.size());
  glActiveTexture(GL_TEXTURE0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glBindTexture(GL_TEXTURE_2D, output.Name());
  vtkBRDFDescribeTexture(GL_TEXTURE_2D);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.Name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, output.Name(), 0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindTexture(GL_TEXTURE_2D_ARRAY, input.Name());
  vtkBRDFDescribeTexture(GL_TEXTURE_2D_ARRAY);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R32F, width, height, layers, 0, GL_RED, GL_FLOAT, nullptr);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    throw Error(Error::Kind::Device, { "no 32-bit float framebuffer", "shader probe", {}, {} });
  }
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glViewport(0, 0, width, height);
  glBindVertexArray(vertices.Name());
  program.Use();
  glUniform1i(program.Uniform("brdfProbeColumns"), 0);
  for (std::size_t k = 0; k < buffers.size(); ++k)
  {
    glUniform1i(program.Uniform(buffers[k].Name), static_cast<GLint>(k + 1));
  }

  std::vector<std::vector<float>> results(expressions.size(), std::vector<float>(count));
  const std::size_t passCount = kWidth * passRows;
  std::vector<float> texels(4 * passCount);
  for (std::size_t first = 0; first < count; first += passCount)
  {
    const std::size_t length = std::min(passCount, count - first);
    for (std::size_t k = 0; k < columns.size(); ++k)
    {
      // Texels beyond the end hold the last row's numbers: nothing undefined is computed.
      std::copy_n(columns[k].Values.begin() + static_cast<std::ptrdiff_t>(first), length, texels.begin());
      std::fill(texels.begin() + static_cast<std::ptrdiff_t>(length),
                texels.begin() + static_cast<std::ptrdiff_t>(passCount),
                texels[length - 1]);
      glTexSubImage3D(
        GL_TEXTURE_2D_ARRAY, 0, 0, 0, static_cast<GLint>(k), width, height, 1, GL_RED, GL_FLOAT, texels.data());
    }
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, texels.data());
    for (std::size_t k = 0; k < results.size(); ++k)
    {
      for (std::size_t i = 0; i < length; ++i)
      {
        results[k][first + i] = texels[4 * i + k];
      }
    }
  }
  glUseProgram(0);
  glBindVertexArray(0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR)
  {
    throw Error(Error::Kind::Device, { "OpenGL error " + std::to_string(error), "shader probe", {}, {} });
  }
  return results;
}
