#include "vtkClippingPlaneRepresentation.h"

#include <vtkActor.h>
#include <vtkCellPicker.h>
#include <vtkObjectFactory.h>
#include <vtkProperty.h>

vtkStandardNewMacro(vtkClippingPlaneRepresentation);

//------------------------------------------------------------------------------
vtkClippingPlaneRepresentation::vtkClippingPlaneRepresentation()
{
  this->SetPlaceFactor(1.0);
  this->SetDrawOutline(false);
  this->SetDrawPlane(false);
  this->ConstrainToWidgetBoundsOff();
  this->Picker->DeletePickList(this->CutActor);
  this->Picker->DeletePickList(this->OutlineActor);
  this->Picker->AddPickList(this->EdgesActor);
}

//------------------------------------------------------------------------------
void vtkClippingPlaneRepresentation::SetHandles(bool shown)
{
  for (vtkActor* part : { this->LineActor, this->ConeActor, this->ConeActor2, this->SphereActor })
  {
    part->SetPickable(shown);
  }
  this->NormalProperty->SetOpacity(shown ? 1.0 : 0.0);
}

//------------------------------------------------------------------------------
int vtkClippingPlaneRepresentation::ComputeInteractionState(int x, int y, int modify)
{
  const int state = this->Superclass::ComputeInteractionState(x, y, modify);
  if (state == MovingOrigin || state == MovingOutline)
  {
    this->InteractionState = Pushing;
    this->SetRepresentationState(Pushing);
  }
  return this->InteractionState;
}
