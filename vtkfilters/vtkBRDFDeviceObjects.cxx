#include "vtkBRDFDeviceObjects.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace
{
using brdf::Error;

constexpr const char* kVertexSource = "#version 150 core\n"
                                      "void main()\n"
                                      "{\n"
                                      "  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));\n"
                                      "  gl_Position = vec4(4.0 * corner - 1.0, 0.0, 1.0);\n"
                                      "}\n";

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
                line > 0 ? "GLSL line " + std::to_string(line) + ": " + LineOf(source, line) : "GLSL",
                {},
                {} });
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

template<class Generate>
GLuint Generated(const Generate& generate)
{
  GLuint name = 0;
  generate(1, &name);
  return name;
}
}

vtkBRDFDeviceName vtkBRDFDeviceName::Texture()
{
  return { Generated([](GLsizei n, GLuint* name) { glGenTextures(n, name); }),
           [](GLuint name) { glDeleteTextures(1, &name); } };
}

vtkBRDFDeviceName vtkBRDFDeviceName::Buffer()
{
  return { Generated([](GLsizei n, GLuint* name) { glGenBuffers(n, name); }),
           [](GLuint name) { glDeleteBuffers(1, &name); } };
}

vtkBRDFDeviceName vtkBRDFDeviceName::Framebuffer()
{
  return { Generated([](GLsizei n, GLuint* name) { glGenFramebuffers(n, name); }),
           [](GLuint name) { glDeleteFramebuffers(1, &name); } };
}

vtkBRDFDeviceName vtkBRDFDeviceName::VertexArray()
{
  return { Generated([](GLsizei n, GLuint* name) { glGenVertexArrays(n, name); }),
           [](GLuint name) { glDeleteVertexArrays(1, &name); } };
}

vtkBRDFDeviceProgram::vtkBRDFDeviceProgram(const std::string& fragment, const std::vector<std::string>& outputs)
  : Program(glCreateProgram(), [](GLuint name) { glDeleteProgram(name); })
{
  const auto remove = [](GLuint name) { glDeleteShader(name); };
  const vtkBRDFDeviceName vertexShader(glCreateShader(GL_VERTEX_SHADER), remove);
  const vtkBRDFDeviceName fragmentShader(glCreateShader(GL_FRAGMENT_SHADER), remove);
  Compile(vertexShader.Name(), kVertexSource);
  Compile(fragmentShader.Name(), fragment);
  glAttachShader(this->Program.Name(), vertexShader.Name());
  glAttachShader(this->Program.Name(), fragmentShader.Name());
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    glBindFragDataLocation(this->Program.Name(), static_cast<GLuint>(k), outputs[k].c_str());
  }
  glLinkProgram(this->Program.Name());
  GLint linked = 0;
  glGetProgramiv(this->Program.Name(), GL_LINK_STATUS, &linked);
  if (!linked)
  {
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(this->Program.Name(), static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(std::max<GLsizei>(length, 0)));
    Fail("shader does not link", log, fragment);
  }
}

vtkBRDFDeviceBuffer::vtkBRDFDeviceBuffer(const float* texels, std::size_t count, const std::string& what)
  : Data(vtkBRDFDeviceName::Buffer())
  , Texture(vtkBRDFDeviceName::Texture())
{
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (count > static_cast<std::size_t>(most))
  {
    throw Error(Error::Kind::Device,
                { "too large for the graphics device",
                  what,
                  std::to_string(count) + " texels",
                  "at most " + std::to_string(most) });
  }
  glBindBuffer(GL_TEXTURE_BUFFER, this->Data.Name());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(4 * count * sizeof(float)), texels, GL_STATIC_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, this->Texture.Name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, this->Data.Name());
  glBindTexture(GL_TEXTURE_BUFFER, 0);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

void vtkBRDFDeviceBuffer::Bind(GLenum unit) const
{
  glActiveTexture(unit);
  glBindTexture(GL_TEXTURE_BUFFER, this->Texture.Name());
}

void vtkBRDFDescribeTexture(GLenum target)
{
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
}
