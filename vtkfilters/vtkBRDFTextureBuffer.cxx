#include "vtkBRDFTextureBuffer.h"

#include "vtkBRDFCompatibility.h"
#include VTK_BRDF_GL_LOADER_HEADER

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <string>

namespace
{
template<class Number>
vtkSmartPointer<vtkTextureObject> Upload(vtkOpenGLRenderWindow* window,
                                         const char* what,
                                         const Number* numbers,
                                         std::size_t count,
                                         int components,
                                         int type,
                                         unsigned int format)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  vtkNew<vtkOpenGLBufferObject> object;
  texture->SetContext(window);
  texture->SetInternalFormat(format);
  if (count > vtkBRDFTextureBuffer::LargestSize() ||
      !object->Upload(numbers, count * static_cast<std::size_t>(components), vtkOpenGLBufferObject::TextureBuffer) ||
      !texture->CreateTextureBuffer(static_cast<unsigned int>(count), components, type, object))
  {
    throw brdf::Error(brdf::Error::Kind::Device,
                      { std::string("the OpenGL device cannot hold ") + what,
                        {},
                        std::to_string(count) + " texels",
                        "at most " + std::to_string(vtkBRDFTextureBuffer::LargestSize()) });
  }
  return texture;
}
}

std::size_t vtkBRDFTextureBuffer::LargestSize()
{
  GLint texels = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
  return static_cast<std::size_t>(std::max(texels, 0));
}

vtkSmartPointer<vtkTextureObject> vtkBRDFTextureBuffer::Make(vtkOpenGLRenderWindow* window,
                                                             const char* what,
                                                             const float* numbers,
                                                             std::size_t count)
{
  return Upload(window, what, numbers, count, 4, VTK_FLOAT, GL_RGBA32F);
}

vtkSmartPointer<vtkTextureObject> vtkBRDFTextureBuffer::Make(vtkOpenGLRenderWindow* window,
                                                             const char* what,
                                                             const std::uint32_t* words,
                                                             std::size_t count,
                                                             int components)
{
  return Upload(window, what, words, count, components, VTK_UNSIGNED_INT, components == 1 ? GL_R32UI : GL_RGBA32UI);
}
