#ifndef vtkBRDFVectorDevice_h
#define vtkBRDFVectorDevice_h
// Takes what a vtkContextScene paints as lines, areas, text and images of a brdf::VectorPicture. For .cxx files only.
//
// VTK's own exporters (9.1) were tried: SVG with words that SVG does not have (text-anchor="right"), which viewers
// ignore, and PDF without a degree sign.

#include <brdf/view/VectorPicture.h>

class vtkContextScene;

namespace vtkBRDFDrawing
{
/** The scene of a window of this size, one point a pixel. */
brdf::VectorPicture PaintedVectors(vtkContextScene* scene, int width, int height);
}

#endif
