#include "LightHandle.h"

#include "LightEdits.h"
#include "LightForms.h"
#include "SceneDocument.h"
#include "ViewOverlay.h"
#include "VolumeView.h"

#include <vtkActor.h>
#include <vtkCommand.h>
#include <vtkHandleWidget.h>
#include <vtkLineSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSphereHandleRepresentation.h>

namespace penumbra
{
namespace
{
constexpr double BallPixels = 14.0;
// Of the distance from the eye to what is looked at: where the ball of a directional light is.
constexpr double DirectionalPart = 0.28;

LightDescription SelectedLight(const SceneDocument* document)
{
  return document->GetScene().Lights[static_cast<std::size_t>(document->GetSelectedLight())];
}

bool HasPosition(const LightDescription& light)
{
  return light.Type == LightType::Point || light.Type == LightType::Spot;
}

Vector3 ToWorld(const Vector3& direction, const ViewFrame& frame)
{
  return Sum(Scaled(frame.Right, direction[0]),
    Sum(Scaled(frame.Up, direction[1]), Scaled(frame.Backward, direction[2])));
}

Vector3 PlaceOf(const LightDescription& light, const ViewFrame& frame)
{
  const double distance = Length(Difference(frame.Position, frame.FocalPoint));
  if (!HasPosition(light))
  {
    return Sum(frame.FocalPoint,
      Scaled(ToWorld(DirectionToLight(light, frame), frame), DirectionalPart * distance));
  }
  LightDescription inScene = light;
  ChangeFrame(inScene, LightFrame::Scene, frame);
  return inScene.Position;
}

void Place(LightDescription& light, const ViewFrame& frame, const Vector3& place)
{
  const Vector3 toLight = Difference(place, frame.FocalPoint);
  if (Length(toLight) == 0.0)
  {
    return;
  }
  if (HasPosition(light))
  {
    const LightFrame kept = light.Frame;
    ChangeFrame(light, LightFrame::Scene, frame);
    light.Position = place;
    ChangeFrame(light, kept, frame);
    return;
  }
  TurnLight(light, frame,
    { Dot(toLight, frame.Right), Dot(toLight, frame.Up), Dot(toLight, frame.Backward) });
}
}

//------------------------------------------------------------------------------
LightHandle::LightHandle(SceneDocument* document, VolumeView* view, QObject* parent)
  : QObject(parent)
  , Document(document)
  , View(view)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(this->Line->GetOutputPort());
  this->LineActor->SetMapper(mapper);
  this->LineActor->GetProperty()->SetColor(1.0, 0.85, 0.3);
  this->LineActor->GetProperty()->SetLighting(false);
  this->LineActor->PickableOff();
  view->GetOverlay()->GetRenderer()->AddActor(this->LineActor);
  this->Ball->SetHandleSize(BallPixels);
  this->Ball->GetProperty()->SetColor(1.0, 0.85, 0.3);
  this->Ball->GetSelectedProperty()->SetColor(1.0, 1.0, 0.7);
  this->Widget->SetRepresentation(this->Ball);
  view->GetOverlay()->Add(this->Widget, view->interactor());
  this->Widget->AddObserver(vtkCommand::InteractionEvent, this, &LightHandle::TakePlace);
  this->connect(document, &SceneDocument::changed, this, &LightHandle::Refresh);
  this->connect(document, &SceneDocument::lightSelected, this, &LightHandle::Refresh);
  this->connect(view, &VolumeView::cameraMoved, this, &LightHandle::Refresh);
}

//------------------------------------------------------------------------------
LightHandle::~LightHandle()
{
  this->View->makeCurrent();
  this->Widget->SetInteractor(nullptr);
  this->View->GetOverlay()->GetRenderer()->RemoveActor(this->LineActor);
}

//------------------------------------------------------------------------------
void LightHandle::Show(bool shown)
{
  this->Shown = shown;
  this->Refresh();
  this->View->ScheduleFrame();
}

//------------------------------------------------------------------------------
void LightHandle::Refresh()
{
  const bool shown = this->Shown && this->View->GetRendering() &&
    HasSelectedLight(this->Document) && SelectedLight(this->Document).Type != LightType::Headlight;
  this->LineActor->SetVisibility(shown);
  if (!shown)
  {
    this->Widget->Off();
    return;
  }
  const ViewFrame frame = this->View->GetFrame();
  const LightDescription light = SelectedLight(this->Document);
  Vector3 place = PlaceOf(light, frame);
  Vector3 target = frame.FocalPoint;
  if (light.Type == LightType::Spot)
  {
    LightDescription inScene = light;
    ChangeFrame(inScene, LightFrame::Scene, frame);
    const double length = Length(Difference(frame.FocalPoint, place));
    target = Sum(place, Scaled(UnitVector(inScene.Direction), length));
  }
  this->View->GetOverlay()->FollowCamera();
  if (!this->Widget->GetEnabled())
  {
    this->Widget->On();
  }
  this->Ball->SetWorldPosition(place.data());
  this->Line->SetPoint1(place.data());
  this->Line->SetPoint2(target.data());
}

//------------------------------------------------------------------------------
Vector3 LightHandle::GetPlace() const
{
  Vector3 place;
  this->Ball->GetWorldPosition(place.data());
  return place;
}

//------------------------------------------------------------------------------
void LightHandle::Drag(Vector3 place)
{
  this->Ball->SetWorldPosition(place.data());
  this->TakePlace();
}

//------------------------------------------------------------------------------
void LightHandle::TakePlace()
{
  const Vector3 place = this->GetPlace();
  const int light = this->Document->GetSelectedLight();
  this->Document->Edit(
    tr("move of a light"),
    [&](SceneDescription& scene)
    { Place(scene.Lights[static_cast<std::size_t>(light)], this->View->GetFrame(), place); },
    "drag" + QString::number(light));
}

}
