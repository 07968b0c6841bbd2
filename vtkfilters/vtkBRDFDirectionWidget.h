#ifndef vtkBRDFDirectionWidget_h
#define vtkBRDFDirectionWidget_h
#include "vtkAbstractWidget.h"
#include "vtkBRDFFiltersModule.h" // For export macro

class vtkBRDFDirectionRepresentation;

/**
 * @class vtkBRDFDirectionWidget
 * @brief The direction of light by hand: an arrow on the unit hemisphere to be dragged with the left button
 *
 * As other widgets of VTK: SetInteractor, On. Invokes StartInteractionEvent, InteractionEvent (at each step of a drag)
 * and EndInteractionEvent; GetTheta and GetPhi then give the direction. Beside the arrow the interactor's style works
 * as ever.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFDirectionWidget : public vtkAbstractWidget
{
public:
  static vtkBRDFDirectionWidget* New();
  vtkTypeMacro(vtkBRDFDirectionWidget, vtkAbstractWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Polar angle from the normal (+z), 0 to 89 degrees; default 45. */
  void SetTheta(double degrees);
  double GetTheta();
  ///@}

  ///@{
  /** Azimuth from +x, degrees; default 0. */
  void SetPhi(double degrees);
  double GetPhi();
  ///@}

  /** The arrow; null gives none. A default one is made when the widget is first enabled or asked for its direction. */
  void SetRepresentation(vtkBRDFDirectionRepresentation* representation);
  vtkBRDFDirectionRepresentation* GetDirectionRepresentation();
  void CreateDefaultRepresentation() override;

protected:
  vtkBRDFDirectionWidget();
  ~vtkBRDFDirectionWidget() override;

private:
  vtkBRDFDirectionWidget(const vtkBRDFDirectionWidget&) = delete;
  void operator=(const vtkBRDFDirectionWidget&) = delete;

  static void Press(vtkAbstractWidget* widget);
  static void Move(vtkAbstractWidget* widget);
  static void Release(vtkAbstractWidget* widget);

  bool Dragging = false;
};
#endif
