#ifndef vtkBRDFCompatibility_h
#define vtkBRDFCompatibility_h
// What differs between VTK 9.1 (Debian 12) and 9.5, in one place. For .cxx files only.

#include <vtkVersionMacros.h>

// The OpenGL loader's header.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#define VTK_BRDF_GL_LOADER_HEADER <vtk_glad.h>
#else
#define VTK_BRDF_GL_LOADER_HEADER <vtk_glew.h>
#define VTK_BRDF_USES_GLEW
#endif

#endif
