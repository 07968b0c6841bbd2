#ifndef vtkBRDFMicrosurfaceData_h
#define vtkBRDFMicrosurfaceData_h
#include "vtkSmartPointer.h"

#include <brdf/simulate/SurfaceKinds.h>

class vtkImageData;
class vtkPolyData;

// Microsurfaces on their way between VTK's data and the core's. Not wrapped. All throw brdf::Error.
namespace vtkBRDFMicrosurfaceData
{
// Meshes by vtkBRDFSurfaceFiles; pictures of heights by the file's ending: PNG, JPEG, TIFF, BMP with VTK (integers are
// divided by the largest of their type, 65535 of 16 bits; no display curve is undone), all others by brdf::readImage.
brdf::SurfaceReaders Readers();

// Heights in micrometres: the first component of the point scalars times `scale`. One layer of points along z.
brdf::HeightField FromImage(vtkImageData* image, double scale);
// Triangles of the polygons and strips; without periods.
brdf::TiledMesh FromPolyData(vtkPolyData* surface);

vtkSmartPointer<vtkImageData> ToImage(const brdf::HeightField& field);
// See vtkBRDFMicrosurfaceGeometry.
vtkSmartPointer<vtkPolyData> ToPolyData(const brdf::SurfaceShape& shape, int tilesX, int tilesY, int stride);
}
#endif
