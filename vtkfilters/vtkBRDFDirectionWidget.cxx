#include "vtkBRDFDirectionWidget.h"

#include "vtkBRDFDirectionRepresentation.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkWidgetCallbackMapper.h"
#include "vtkWidgetEvent.h"

vtkStandardNewMacro(vtkBRDFDirectionWidget);

vtkBRDFDirectionWidget::vtkBRDFDirectionWidget()
{
  vtkWidgetCallbackMapper* mapper = this->CallbackMapper;
  mapper->SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, this, &Press);
  mapper->SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, &Move);
  mapper->SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, this, &Release);
}

vtkBRDFDirectionWidget::~vtkBRDFDirectionWidget() = default;

void vtkBRDFDirectionWidget::SetRepresentation(vtkBRDFDirectionRepresentation* representation)
{
  this->Superclass::SetWidgetRepresentation(representation);
}

void vtkBRDFDirectionWidget::CreateDefaultRepresentation()
{
  if (!this->WidgetRep)
  {
    this->WidgetRep = vtkBRDFDirectionRepresentation::New(); // given up by the base class
  }
}

vtkBRDFDirectionRepresentation* vtkBRDFDirectionWidget::GetDirectionRepresentation()
{
  this->CreateDefaultRepresentation();
  return vtkBRDFDirectionRepresentation::SafeDownCast(this->WidgetRep);
}

void vtkBRDFDirectionWidget::SetTheta(double degrees)
{
  this->GetDirectionRepresentation()->SetTheta(degrees);
}

double vtkBRDFDirectionWidget::GetTheta()
{
  return this->GetDirectionRepresentation()->GetTheta();
}

void vtkBRDFDirectionWidget::SetPhi(double degrees)
{
  this->GetDirectionRepresentation()->SetPhi(degrees);
}

double vtkBRDFDirectionWidget::GetPhi()
{
  return this->GetDirectionRepresentation()->GetPhi();
}

void vtkBRDFDirectionWidget::Press(vtkAbstractWidget* widget)
{
  auto* self = static_cast<vtkBRDFDirectionWidget*>(widget);
  const int* at = self->Interactor->GetEventPosition();
  vtkBRDFDirectionRepresentation* arrow = self->GetDirectionRepresentation();
  if (!self->CurrentRenderer || !self->CurrentRenderer->IsInViewport(at[0], at[1]) ||
      arrow->ComputeInteractionState(at[0], at[1]) == vtkBRDFDirectionRepresentation::Outside)
  {
    return;
  }
  self->Dragging = true;
  self->GrabFocus(self->EventCallbackCommand);
  double position[2] = { static_cast<double>(at[0]), static_cast<double>(at[1]) };
  arrow->StartWidgetInteraction(position);
  arrow->Highlight(1);
  self->EventCallbackCommand->SetAbortFlag(1);
  self->StartInteraction();
  self->InvokeEvent(vtkCommand::StartInteractionEvent, nullptr);
  self->Render();
}

void vtkBRDFDirectionWidget::Move(vtkAbstractWidget* widget)
{
  auto* self = static_cast<vtkBRDFDirectionWidget*>(widget);
  const int* at = self->Interactor->GetEventPosition();
  vtkBRDFDirectionRepresentation* arrow = self->GetDirectionRepresentation();
  if (!self->Dragging)
  {
    const int before = arrow->GetInteractionState();
    const int now = arrow->ComputeInteractionState(at[0], at[1]);
    if (now != before)
    {
      arrow->Highlight(now == vtkBRDFDirectionRepresentation::OnArrow);
      self->Render();
    }
    return;
  }
  double position[2] = { static_cast<double>(at[0]), static_cast<double>(at[1]) };
  arrow->WidgetInteraction(position);
  self->EventCallbackCommand->SetAbortFlag(1);
  self->InvokeEvent(vtkCommand::InteractionEvent, nullptr);
  self->Render();
}

void vtkBRDFDirectionWidget::Release(vtkAbstractWidget* widget)
{
  auto* self = static_cast<vtkBRDFDirectionWidget*>(widget);
  if (!self->Dragging)
  {
    return;
  }
  self->Dragging = false;
  self->GetDirectionRepresentation()->Highlight(0);
  self->ReleaseFocus();
  self->EventCallbackCommand->SetAbortFlag(1);
  self->EndInteraction();
  self->InvokeEvent(vtkCommand::EndInteractionEvent, nullptr);
  self->Render();
}

void vtkBRDFDirectionWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dragging: " << this->Dragging << "\n";
}
