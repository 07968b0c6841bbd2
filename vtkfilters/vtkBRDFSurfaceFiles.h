#ifndef vtkBRDFSurfaceFiles_h
#define vtkBRDFSurfaceFiles_h
#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

// Surfaces from files, by VTK's readers. Not wrapped.
namespace vtkBRDFSurfaceFiles
{
// What can be read, told by the ending: ".ply, .obj, .stl, .vtp, .gltf, .glb".
std::string Endings();

// A surface as the file holds it. Throws brdf::Error, with the file's name, where it cannot be read or has no polygons.
vtkSmartPointer<vtkPolyData> Read(const std::string& path);
}
#endif
