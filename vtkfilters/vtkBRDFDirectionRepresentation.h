#ifndef vtkBRDFDirectionRepresentation_h
#define vtkBRDFDirectionRepresentation_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkNew.h"               // For vtkNew
#include "vtkWidgetRepresentation.h"

class vtkActor;
class vtkConeSource;
class vtkLineSource;

/**
 * @class vtkBRDFDirectionRepresentation
 * @brief An arrow on the unit hemisphere that stands for the direction of light
 *
 * Points at the origin from the direction (Theta, Phi), its head just outside the unit sphere. Dragged, it follows the
 * pointer over the sphere that its middle lies on, on the side where it is, and never below the horizon.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFDirectionRepresentation : public vtkWidgetRepresentation
{
public:
  static vtkBRDFDirectionRepresentation* New();
  vtkTypeMacro(vtkBRDFDirectionRepresentation, vtkWidgetRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Polar angle from the normal (+z), 0 to 89 degrees; default 45. */
  vtkSetClampMacro(Theta, double, 0, 89);
  vtkGetMacro(Theta, double);
  ///@}

  ///@{
  /** Azimuth from +x, degrees; default 0. */
  vtkSetMacro(Phi, double);
  vtkGetMacro(Phi, double);
  ///@}

  ///@{
  /** How far from the arrow the pointer takes it: pixels, 1 to 100, default 10. */
  vtkSetClampMacro(Tolerance, double, 1, 100);
  vtkGetMacro(Tolerance, double);
  ///@}

  /** States of interaction: what is under the pointer. */
  enum
  {
    Outside = 0,
    OnArrow
  };

  ///@{
  /** For the widget: positions are pixels from the window's lower left corner. */
  int ComputeInteractionState(int x, int y, int modify = 0) override;
  void StartWidgetInteraction(double position[2]) override;
  void WidgetInteraction(double position[2]) override;
  void Highlight(int on) override;
  ///@}

  ///@{
  /** As props do. */
  void BuildRepresentation() override;
  double* GetBounds() override;
  void GetActors(vtkPropCollection* actors) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkBRDFDirectionRepresentation();
  ~vtkBRDFDirectionRepresentation() override;

private:
  vtkBRDFDirectionRepresentation(const vtkBRDFDirectionRepresentation&) = delete;
  void operator=(const vtkBRDFDirectionRepresentation&) = delete;

  double Theta = 45;
  double Phi = 0;
  double Tolerance = 10;
  double Offset[2] = { 0, 0 }; // from the pointer to the arrow's middle where the drag began, pixels
  double BoundingBox[6] = { -1.4, 1.4, -1.4, 1.4, 0, 1.4 };
  vtkNew<vtkLineSource> Shaft;
  vtkNew<vtkConeSource> Head;
  vtkNew<vtkActor> ShaftActor;
  vtkNew<vtkActor> HeadActor;
};
#endif
