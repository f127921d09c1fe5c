#include "ClippingPlaneHandle.h"

#include "SceneDocument.h"
#include "ViewOverlay.h"
#include "VolumeBox.h"
#include "VolumeView.h"
#include "vtkClippingPlaneRepresentation.h"

#include <vtkBoundingBox.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkImplicitPlaneWidget2.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>

namespace penumbra
{
namespace
{
constexpr double BallPixels = 7.0;
constexpr Vector3 Selected = { 0.35, 0.75, 1.0 };
constexpr Vector3 NotSelected = { 0.40, 0.48, 0.55 };

// The point of the plane that is nearest to the middle of the volume.
Vector3 MiddleOf(const ClippingPlaneDescription& plane, const VolumeBox& box)
{
  const Vector3 normal = UnitVector(plane.Normal);
  const Vector3 center = box.GetCenter();
  return Sum(center, Scaled(normal, Dot(Difference(plane.Origin, center), normal)));
}
}

//------------------------------------------------------------------------------
ClippingPlaneHandle::ClippingPlaneHandle(
  SceneDocument* document, VolumeView* view, std::size_t plane)
  : Document(document)
  , View(view)
  , Plane(plane)
{
  this->Shape->SetHandleSize(BallPixels);
  this->Shape->GetSelectedNormalProperty()->SetColor(0.85, 0.95, 1.0);
  this->Widget->SetRepresentation(this->Shape);
  this->View->GetOverlay()->Add(this->Widget, view->interactor());
  this->Widget->AddObserver(vtkCommand::InteractionEvent, this, &ClippingPlaneHandle::TakePlane);
}

//------------------------------------------------------------------------------
ClippingPlaneHandle::~ClippingPlaneHandle()
{
  this->View->makeCurrent();
  this->Widget->SetInteractor(nullptr);
}

//------------------------------------------------------------------------------
void ClippingPlaneHandle::Refresh()
{
  const SceneDescription& scene = this->Document->GetScene();
  const VolumeBox box(this->Document->GetVoxels().Volume, scene.Volume.Transform);
  vtkBoundingBox around;
  for (Vector3 corner : box.GetCorners())
  {
    around.AddPoint(corner.data());
  }
  double bounds[6];
  around.GetBounds(bounds);
  const ClippingPlaneDescription& plane = scene.ClippingPlanes[this->Plane];
  this->Shape->PlaceWidget(bounds);
  Vector3 middle = MiddleOf(plane, box);
  this->Shape->SetOrigin(middle.data());
  Vector3 normal = UnitVector(plane.Normal);
  this->Shape->SetNormal(normal.data());
  this->Shape->Modified(); // placing has moved the arrow's end, also where the plane is as it was
  const bool selected = static_cast<int>(this->Plane) == this->Document->GetSelectedPlane();
  const Vector3 color = selected ? Selected : NotSelected;
  this->Shape->SetHandles(selected);
  this->Shape->GetNormalProperty()->SetColor(color[0], color[1], color[2]);
  this->Shape->SetEdgeColor(color[0], color[1], color[2]);
  if (!this->Widget->GetEnabled())
  {
    this->Widget->On();
  }
}

//------------------------------------------------------------------------------
void ClippingPlaneHandle::TakePlane()
{
  this->Document->SelectPlane(static_cast<int>(this->Plane));
  ClippingPlaneDescription plane;
  this->Shape->GetOrigin(plane.Origin.data());
  this->Shape->GetNormal(plane.Normal.data());
  this->Document->Edit(
    QObject::tr("drag of a clipping plane"),
    [&](SceneDescription& scene) { scene.ClippingPlanes[this->Plane] = plane; },
    "plane" + QString::number(this->Plane));
}

}
