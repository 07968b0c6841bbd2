#ifndef vtkBRDFLobeScene_h
#define vtkBRDFLobeScene_h
// What stands around a lobe: disc, half circle, arrows and labels in units of the disc's radius. For .cxx files only.

#include "vtkBRDFDrawing.h"

#include <brdf/geometry/Directions.h>

class vtkPolyData;
class vtkProp3D;
class vtkProperty;
class vtkRenderer;

namespace vtkBRDFLobeScene
{
constexpr vtkBRDFDrawing::Color LightColor = { 0.93, 0.66, 0.0 };

/** Where one lobe stands. */
struct Stage
{
  vtkRenderer* Renderer;
  brdf::Direction Origin;
  int Text;               ///< pixels
  double PixelsPerRadius; ///< of the disc: less room has fewer labels

  bool HasRoomForAngles() const { return this->PixelsPerRadius > 9 * this->Text; }
  bool HasRoomForNames() const { return this->PixelsPerRadius > 4 * this->Text; }
};

/** A lamp over the viewer's left shoulder, which shows shapes, and a weak one at the eye. */
void SetLights(vtkRenderer* renderer);

/** A disc with rings of polar angle and spokes of azimuth, and the half circle in the plane of incidence. The angle of
 * the light is not written there: its arrow says it. Angles in degrees. */
void AddGround(const Stage& stage, double thetaI, double phiI);

/** The arrow of the light (with `light`; its label in any case) and that of the mirror direction. */
void AddDirections(const Stage& stage, double thetaI, double phiI, bool light);

/** A hemisphere of lines. */
void AddHemisphere(const Stage& stage, double radius);

/** A surface with colours of its points ("Scalars" of 8 bits) or one. */
vtkProperty* AddSurface(const Stage& stage,
                        vtkPolyData* surface,
                        double scale,
                        const vtkBRDFDrawing::Color& color,
                        bool colored);

/** Points of a size in pixels, coloured as a surface, in front of surfaces that they lie on. */
void AddPoints(const Stage& stage, vtkPolyData* points, double scale, const vtkBRDFDrawing::Color& color, bool colored);
}

#endif
