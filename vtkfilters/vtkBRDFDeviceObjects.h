#ifndef vtkBRDFDeviceObjects_h
#define vtkBRDFDeviceObjects_h
// OpenGL objects of computations by fragment shaders, owned by scopes. For .cxx files only; every call needs the
// context that the objects belong to.

#include "vtkBRDFCompatibility.h"
#include VTK_BRDF_GL_LOADER_HEADER

#include <string>
#include <vector>

// A name that OpenGL gave, deleted by its function.
class vtkBRDFDeviceName
{
public:
  vtkBRDFDeviceName(GLuint name, void (*remove)(GLuint))
    : Value(name)
    , Remove(remove)
  {
  }
  vtkBRDFDeviceName(vtkBRDFDeviceName&& other) noexcept
    : Value(other.Value)
    , Remove(other.Remove)
  {
    other.Value = 0;
  }
  ~vtkBRDFDeviceName()
  {
    if (this->Value)
    {
      this->Remove(this->Value);
    }
  }
  vtkBRDFDeviceName(const vtkBRDFDeviceName&) = delete;
  void operator=(const vtkBRDFDeviceName&) = delete;
  GLuint Name() const { return this->Value; }

  static vtkBRDFDeviceName Texture();
  static vtkBRDFDeviceName Buffer();
  static vtkBRDFDeviceName Framebuffer();
  static vtkBRDFDeviceName VertexArray();

private:
  GLuint Value;
  void (*Remove)(GLuint);
};

// A fragment shader over the whole viewport: draw 3 vertices as triangles.
class vtkBRDFDeviceProgram
{
public:
  // Source with its #version; of several outputs their names, in the order of the attachments. Throws brdf::Error (kind
  // Device) that names the line at fault and shows it.
  explicit vtkBRDFDeviceProgram(const std::string& fragment, const std::vector<std::string>& outputs = {});
  void Use() const { glUseProgram(this->Program.Name()); }
  GLint Uniform(const std::string& name) const { return glGetUniformLocation(this->Program.Name(), name.c_str()); }

private:
  vtkBRDFDeviceName Program;
};

// Texels of four floats in a texture buffer.
class vtkBRDFDeviceBuffer
{
public:
  // Throws brdf::Error (kind Device), naming `what`, for more texels than the device takes.
  vtkBRDFDeviceBuffer(const float* texels, std::size_t count, const std::string& what);
  void Bind(GLenum unit) const;

private:
  vtkBRDFDeviceName Data, Texture;
};

// The texture bound to `target` is read by texel.
void vtkBRDFDescribeTexture(GLenum target);

#endif
