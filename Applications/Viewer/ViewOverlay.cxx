#include "ViewOverlay.h"

#include <vtkAbstractWidget.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWidgetEventTranslator.h>

namespace penumbra
{

//------------------------------------------------------------------------------
ViewOverlay::ViewOverlay(vtkRenderWindow* window)
{
  this->Renderer->SetLayer(1);
  this->Renderer->SetInteractive(false);
  this->Renderer->AddObserver(vtkCommand::StartEvent, this, &ViewOverlay::FollowCamera);
  window->SetNumberOfLayers(2);
  window->AddRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
void ViewOverlay::Attach(vtkRenderer* scene)
{
  this->Scene = scene;
}

//------------------------------------------------------------------------------
void ViewOverlay::FollowCamera()
{
  if (this->Scene)
  {
    this->Renderer->GetActiveCamera()->DeepCopy(this->Scene->GetActiveCamera());
    this->Renderer->ResetCameraClippingRange();
  }
}

//------------------------------------------------------------------------------
void ViewOverlay::Add(vtkAbstractWidget* widget, vtkRenderWindowInteractor* interactor)
{
  widget->SetInteractor(interactor);
  widget->SetDefaultRenderer(this->Renderer);
  widget->SetCurrentRenderer(this->Renderer);
  vtkWidgetEventTranslator* events = widget->GetEventTranslator();
  events->RemoveTranslation(vtkCommand::MiddleButtonPressEvent);
  events->RemoveTranslation(vtkCommand::RightButtonPressEvent);
}

//------------------------------------------------------------------------------
void ViewOverlay::Show(bool shown)
{
  this->Renderer->SetDraw(shown);
}

}
