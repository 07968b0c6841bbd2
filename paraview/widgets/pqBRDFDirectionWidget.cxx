#include "pqBRDFDirectionWidget.h"

#include "pqDoubleRangeWidget.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"

#include <QCheckBox>
#include <QFormLayout>

pqBRDFDirectionWidget::pqBRDFDirectionWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : pqInteractivePropertyWidget("representations", "BRDFDirectionWidgetRepresentation", proxy, group, parent)
{
  this->setShowLabel(false);
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  this->addSlider("Theta", 0, 89);
  this->addSlider("Phi", -180, 180);
  auto* visible = new QCheckBox(tr("Arrow in the view"), this);
  visible->setChecked(true);
  layout->addRow(visible);
  this->connect(visible, &QCheckBox::toggled, this, &pqBRDFDirectionWidget::setWidgetVisible);
  this->connect(
    this, &pqBRDFDirectionWidget::widgetVisibilityToggled, visible, [visible](bool on) { visible->setChecked(on); });
  this->setWidgetVisible(true);
}

void pqBRDFDirectionWidget::addSlider(const char* function, double low, double high)
{
  vtkSMProperty* property = this->propertyGroup()->GetProperty(function);
  if (!property)
  {
    return;
  }
  auto* slider = new pqDoubleRangeWidget(this);
  slider->setMinimum(low);
  slider->setMaximum(high);
  static_cast<QFormLayout*>(this->layout())->addRow(tr(property->GetXMLLabel()), slider);
  this->addPropertyLink(slider, "value", SIGNAL(valueChanged(double)), property);
  this->connect(slider, SIGNAL(valueEdited(double)), this, SIGNAL(changeAvailable()));
  this->connect(slider, SIGNAL(valueEdited(double)), this, SIGNAL(changeFinished()));
}
