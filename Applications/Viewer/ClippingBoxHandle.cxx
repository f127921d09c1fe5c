#include "ClippingBoxHandle.h"

#include "ClippingFrame.h"
#include "SceneDocument.h"
#include "ViewOverlay.h"
#include "VolumeView.h"

#include <vtkBoxRepresentation.h>
#include <vtkBoxWidget2.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr double BallPixels = 9.0;
// Of the volume along an axis: what a side has to be dragged at least, above rounding.
constexpr double LeastMove = 1e-9;

CroppingBox BoundsOfCorners(vtkPolyData* hull, vtkMatrix4x4* fromWorld)
{
  CroppingBox box = { 1e300, -1e300, 1e300, -1e300, 1e300, -1e300 };
  for (vtkIdType corner = 0; corner < 8; ++corner)
  {
    double place[4] = { 0.0, 0.0, 0.0, 1.0 };
    hull->GetPoint(corner, place);
    fromWorld->MultiplyPoint(place, place);
    for (int axis = 0; axis < 3; ++axis)
    {
      box[2 * axis] = std::min(box[2 * axis], place[axis]);
      box[2 * axis + 1] = std::max(box[2 * axis + 1], place[axis]);
    }
  }
  return box;
}
}

//------------------------------------------------------------------------------
ClippingBoxHandle::ClippingBoxHandle(SceneDocument* document, VolumeView* view)
  : Document(document)
  , View(view)
{
  this->Box->SetPlaceFactor(1.0);
  this->Box->SetHandleSize(BallPixels);
  this->Box->OutlineCursorWiresOff();
  this->Box->GetOutlineProperty()->SetColor(0.35, 0.75, 1.0);
  this->Box->GetSelectedOutlineProperty()->SetColor(0.35, 0.75, 1.0);
  this->Box->GetHandleProperty()->SetColor(0.35, 0.75, 1.0);
  this->Box->GetSelectedHandleProperty()->SetColor(0.85, 0.95, 1.0);
  this->Box->GetSelectedFaceProperty()->SetOpacity(0.1);
  this->Widget->SetRepresentation(this->Box);
  this->Widget->RotationEnabledOff();
  this->Widget->ScalingEnabledOff();
  this->View->GetOverlay()->Add(this->Widget, view->interactor());
  this->Widget->AddObserver(vtkCommand::InteractionEvent, this, &ClippingBoxHandle::TakeBox);
}

//------------------------------------------------------------------------------
ClippingBoxHandle::~ClippingBoxHandle()
{
  this->View->makeCurrent();
  this->Widget->SetInteractor(nullptr);
}

//------------------------------------------------------------------------------
void ClippingBoxHandle::Refresh(bool shown)
{
  if (!shown || !this->Document->GetScene().Volume.Cropping)
  {
    this->Widget->Off();
    return;
  }
  const SceneDescription& scene = this->Document->GetScene();
  CroppingBox box = *scene.Volume.Cropping;
  vtkNew<vtkTransform> toWorld;
  toWorld->SetMatrix(CroppingToWorld(scene, this->Document->GetVoxels().Volume));
  this->Box->PlaceWidget(box.data());
  this->Box->SetTransform(toWorld);
  if (!this->Widget->GetEnabled())
  {
    this->Widget->On();
  }
}

//------------------------------------------------------------------------------
void ClippingBoxHandle::TakeBox()
{
  vtkImageData* image = this->Document->GetVoxels().Volume;
  vtkNew<vtkPolyData> hull;
  this->Box->GetPolyData(hull);
  vtkNew<vtkMatrix4x4> fromWorld;
  vtkMatrix4x4::Invert(CroppingToWorld(this->Document->GetScene(), image), fromWorld);
  const CroppingBox dragged = BoundsOfCorners(hull, fromWorld);
  const CroppingBox whole = WholeBox(image);
  CroppingBox box = KeptBox(this->Document->GetScene(), image);
  for (int side = 0; side < 6; ++side)
  {
    const double length = whole[side / 2 * 2 + 1] - whole[side / 2 * 2];
    if (std::abs(dragged[side] - box[side]) > LeastMove * length)
    {
      box = WithSideAt(box, side, dragged[side], whole);
    }
  }
  this->Document->Edit(
    QObject::tr("drag of the clipping box"),
    [&](SceneDescription& scene) { scene.Volume.Cropping = box; }, "clippingBox");
  this->Refresh(true); // what cannot be followed is not shown
}

}
