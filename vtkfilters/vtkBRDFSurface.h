#ifndef vtkBRDFSurface_h
#define vtkBRDFSurface_h
#include "vtkSmartPointer.h"

#include <brdf/render/Scene.h>

class vtkPolyData;

// Surfaces on their way between VTK's data and the core's. Not wrapped.
namespace vtkBRDFSurface
{
// A sphere of radius 1 whose normals are exact and whose tangents run around +y. Between vertices the interpolated
// normal is off by at most (edge angle)^2 / 8 = 7.5e-5 rad.
vtkSmartPointer<vtkPolyData> UnitSphere();

// Throws brdf::Error where a corner of a polygon is no point: VTK's own filters trust corners.
void RequireCorners(vtkPolyData* surface);

// A surface ready to be drawn by either renderer: triangles, with normals and tangents made where it has none (normals
// splitting edges sharper than 40 degrees; tangents by brdf::addTangents). Throws brdf::Error where there are no
// polygons with an area, a corner is no point, or a point, normal or tangent is not finite.
vtkSmartPointer<vtkPolyData> Complete(vtkPolyData* surface);

// The triangles of a completed surface, and back.
brdf::TriangleMesh ToMesh(vtkPolyData* surface);
vtkSmartPointer<vtkPolyData> FromMesh(const brdf::TriangleMesh& mesh);
}
#endif
