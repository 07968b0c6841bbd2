#ifndef vtkBRDFParametricShapes_h
#define vtkBRDFParametricShapes_h
#include <brdf/render/Scene.h>

#include <optional>
#include <string>
#include <vector>

// VTK's parametric surfaces (vtkParametricFunction) by name, as meshes. Not wrapped.
namespace vtkBRDFParametricShapes
{
std::vector<std::string> Names();

// A surface with +y up in the sphere of radius 1 about the origin. Normals and tangents (along the first parameter) are
// those of the surface, not of its triangles: derivatives by differences of fourth order of the function itself (VTK's
// own are missing or wrong for some). Empty for a name that is none.
std::optional<brdf::TriangleMesh> Make(const std::string& name);
}
#endif
