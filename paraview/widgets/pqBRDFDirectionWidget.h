#ifndef pqBRDFDirectionWidget_h
#define pqBRDFDirectionWidget_h
#include "pqInteractivePropertyWidget.h"

/**
 * A direction of light in the panel of a filter: its polar angle and azimuth on sliders, and an arrow in the view that
 * is dragged over the unit hemisphere (vtkBRDFDirectionWidget). In XML: a PropertyGroup with
 * panel_widget="BRDFDirection" and properties of the functions Theta and Phi, in degrees.
 */
class pqBRDFDirectionWidget : public pqInteractivePropertyWidget
{
  Q_OBJECT

public:
  pqBRDFDirectionWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);

protected Q_SLOTS:
  /** The hemisphere stays where it is, whatever the data. */
  void placeWidget() override {}

private:
  Q_DISABLE_COPY(pqBRDFDirectionWidget)

  void addSlider(const char* function, double low, double high);
};
#endif
