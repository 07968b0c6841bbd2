#ifndef vtkBRDFAlbedoPlot_h
#define vtkBRDFAlbedoPlot_h
// The directional albedo over the angle of the light, as a plot with axes. For .cxx files only.

#include "vtkBRDFDrawing.h"

class vtkTable;

namespace vtkBRDFDrawing
{
/** Draws the columns of `albedo` over its column "theta" (degrees), between two corners in pixels, and the white
 * furnace's bound, 1, in the colour `alarm`. `size`: of text, pixels. */
void AddAlbedoPlot(vtkRenderer* renderer, vtkTable* albedo, Point from, Point to, int size, const Color& alarm);
}

#endif
