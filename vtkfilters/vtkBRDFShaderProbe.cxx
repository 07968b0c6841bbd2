#include "vtkBRDFShaderProbe.h"

#include "vtkBRDFCompatibility.h"
#include VTK_BRDF_GL_LOADER_HEADER
#include "vtkBRDFHeadlessRenderWindow.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <memory>

namespace
{
using brdf::Error;

// Rows of one pass: a texture of at most 1024 x 1024 in each of the columns' layers.
constexpr std::size_t kWidth = 1024;
constexpr std::size_t kHeight = 1024;
constexpr std::size_t kMaximumColumns = 256; // layers that every OpenGL 3.3 has

// What the scope of a pass owns.
template <class Delete>
struct Owned
{
  GLuint Name = 0;
  Delete Remove;
  Owned(GLuint name, Delete remove)
    : Name(name)
    , Remove(remove)
  {
  }
  ~Owned() { this->Remove(this->Name); }
  Owned(const Owned&) = delete;
  void operator=(const Owned&) = delete;
};

// Texels of four floats, bound as a texture buffer to a unit.
class BufferTexture
{
public:
  BufferTexture(const std::vector<float>& texels, GLenum unit)
    : Unit(unit)
  {
    glGenBuffers(1, &this->Data);
    glGenTextures(1, &this->Texture);
    glBindBuffer(GL_TEXTURE_BUFFER, this->Data);
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(texels.size() * sizeof(float)), texels.data(), GL_STATIC_DRAW);
    glActiveTexture(unit);
    glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, this->Data);
    glActiveTexture(GL_TEXTURE0);
  }
  ~BufferTexture()
  {
    glActiveTexture(this->Unit);
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    glActiveTexture(GL_TEXTURE0);
    glDeleteTextures(1, &this->Texture);
    glDeleteBuffers(1, &this->Data);
  }
  BufferTexture(const BufferTexture&) = delete;
  void operator=(const BufferTexture&) = delete;

private:
  GLenum Unit;
  GLuint Data = 0, Texture = 0;
};

// The line of the first error that a driver's log names: "0:12(5): error" (Mesa) or "0(12) : error" (NVIDIA).
int FirstLine(const std::string& log)
{
  for (std::size_t k = 0; k + 1 < log.size(); ++k)
  {
    const bool start = k == 0 || !std::isalnum(static_cast<unsigned char>(log[k - 1]));
    if (start && log[k] == '0' && (log[k + 1] == ':' || log[k + 1] == '('))
    {
      return std::atoi(log.c_str() + k + 2);
    }
  }
  return 0;
}

std::string LineOf(const std::string& text, int number)
{
  std::size_t start = 0;
  for (int line = 1; line < number && start != std::string::npos; ++line)
  {
    start = text.find('\n', start);
    start += start == std::string::npos ? 0 : 1;
  }
  return start == std::string::npos ? std::string() : text.substr(start, text.find('\n', start) - start);
}

[[noreturn]] void Fail(const std::string& what, const std::string& log, const std::string& source)
{
  const int line = FirstLine(log);
  throw Error(Error::Kind::Device,
    { what + ": " + log.substr(0, log.find('\n')),
      line > 0 ? "GLSL line " + std::to_string(line) + ": " + LineOf(source, line) : "GLSL", {}, {} });
}

void Compile(GLuint shader, const std::string& source)
{
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (!compiled)
  {
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(std::max<GLsizei>(length, 0)));
    Fail("shader does not compile", log, source);
  }
}

std::string FragmentSource(const std::string& functions, const std::vector<vtkBRDFShaderProbe::Column>& columns,
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

constexpr const char* kVertexSource = "#version 330 core\n"
                                      "void main()\n"
                                      "{\n"
                                      "  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));\n"
                                      "  gl_Position = vec4(4.0 * corner - 1.0, 0.0, 1.0);\n"
                                      "}\n";

// A texture of `width` x `height` (x layers) 32-bit floats, bound to its target, never filtered.
void DescribeTexture(GLenum target)
{
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
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

std::vector<std::vector<float>> vtkBRDFShaderProbe::Evaluate(
  const std::string& functions, const std::vector<Column>& columns, const std::vector<std::string>& expressions,
  const std::vector<Buffer>& buffers)
{
  if (columns.empty() || columns.size() > kMaximumColumns || expressions.empty() || expressions.size() > 4)
  {
    throw Error(Error::Kind::Value, { "wrong number of columns or expressions", "shader probe",
      std::to_string(columns.size()) + " and " + std::to_string(expressions.size()),
      "1 to " + std::to_string(kMaximumColumns) + " and 1 to 4" });
  }
  const std::size_t count = columns[0].Values.size();
  for (const Column& column : columns)
  {
    if (column.Values.size() != count)
    {
      throw Error(Error::Kind::Value, { "columns of different lengths", "shader probe, column " + column.Name,
        std::to_string(column.Values.size()), std::to_string(count) });
    }
  }
  this->Window->MakeCurrent();

  const Owned vertex(glCreateShader(GL_VERTEX_SHADER), [](GLuint name) { glDeleteShader(name); });
  const Owned fragment(glCreateShader(GL_FRAGMENT_SHADER), [](GLuint name) { glDeleteShader(name); });
  const Owned program(glCreateProgram(), [](GLuint name) { glDeleteProgram(name); });
  const std::string source = FragmentSource(functions, columns, expressions);
  Compile(vertex.Name, kVertexSource);
  Compile(fragment.Name, source);
  glAttachShader(program.Name, vertex.Name);
  glAttachShader(program.Name, fragment.Name);
  glLinkProgram(program.Name);
  GLint linked = 0;
  glGetProgramiv(program.Name, GL_LINK_STATUS, &linked);
  if (!linked)
  {
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program.Name, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(std::max<GLsizei>(length, 0)));
    Fail("shader does not link", log, source);
  }

  GLuint name = 0;
  glGenTextures(1, &name);
  const Owned input(name, [](GLuint texture) { glDeleteTextures(1, &texture); });
  glGenTextures(1, &name);
  const Owned output(name, [](GLuint texture) { glDeleteTextures(1, &texture); });
  glGenFramebuffers(1, &name);
  const Owned framebuffer(name, [](GLuint object) { glDeleteFramebuffers(1, &object); });
  glGenVertexArrays(1, &name);
  const Owned vertices(name, [](GLuint object) { glDeleteVertexArrays(1, &object); });

  std::vector<std::unique_ptr<BufferTexture>> textures;
  for (const Buffer& buffer : buffers)
  {
    textures.push_back(std::make_unique<BufferTexture>(buffer.Texels, GL_TEXTURE1 + static_cast<GLenum>(textures.size())));
  }

  const std::size_t passRows = std::min((count + kWidth - 1) / kWidth, kHeight);
  const auto width = static_cast<GLsizei>(kWidth), height = static_cast<GLsizei>(std::max<std::size_t>(passRows, 1));
  const auto layers = static_cast<GLsizei>(columns.size());
  glActiveTexture(GL_TEXTURE0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glBindTexture(GL_TEXTURE_2D, output.Name);
  DescribeTexture(GL_TEXTURE_2D);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.Name);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, output.Name, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindTexture(GL_TEXTURE_2D_ARRAY, input.Name);
  DescribeTexture(GL_TEXTURE_2D_ARRAY);
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
  glBindVertexArray(vertices.Name);
  glUseProgram(program.Name);
  glUniform1i(glGetUniformLocation(program.Name, "brdfProbeColumns"), 0);
  for (std::size_t k = 0; k < buffers.size(); ++k)
  {
    glUniform1i(glGetUniformLocation(program.Name, buffers[k].Name.c_str()), static_cast<GLint>(k + 1));
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
        texels.begin() + static_cast<std::ptrdiff_t>(passCount), texels[length - 1]);
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
