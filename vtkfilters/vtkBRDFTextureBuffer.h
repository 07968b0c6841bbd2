#ifndef vtkBRDFTextureBuffer_h
#define vtkBRDFTextureBuffer_h
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>

class vtkOpenGLRenderWindow;
class vtkTextureObject;

// Numbers that a shader reads by texelFetch, of any amount that the device takes.
namespace vtkBRDFTextureBuffer
{
// Texels that one buffer holds on the device whose context is current; OpenGL 3.2 asks for 65,536.
std::size_t LargestSize();

// A samplerBuffer of texels of four floats, or a usamplerBuffer of texels of `components` (1 or 4) words; `count`
// texels. Throws brdf::Error (kind Device), which names `what`, where the device cannot hold them.
vtkSmartPointer<vtkTextureObject> Make(vtkOpenGLRenderWindow* window,
                                       const char* what,
                                       const float* numbers,
                                       std::size_t count);
vtkSmartPointer<vtkTextureObject> Make(vtkOpenGLRenderWindow* window,
                                       const char* what,
                                       const std::uint32_t* words,
                                       std::size_t count,
                                       int components);
}
#endif
