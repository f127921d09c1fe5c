#include "ClippingHandles.h"

#include "SceneDocument.h"
#include "ViewOverlay.h"
#include "VolumeView.h"

namespace penumbra
{

//------------------------------------------------------------------------------
ClippingHandles::ClippingHandles(SceneDocument* document, VolumeView* view, QObject* parent)
  : QObject(parent)
  , Document(document)
  , View(view)
  , Box(document, view)
{
  this->connect(document, &SceneDocument::changed, this, &ClippingHandles::Refresh);
  this->connect(document, &SceneDocument::planeSelected, this, &ClippingHandles::Refresh);
}

//------------------------------------------------------------------------------
void ClippingHandles::Show(bool shown)
{
  this->Shown = shown;
  if (this->Document->IsOpen())
  {
    this->Refresh();
    this->View->ScheduleFrame();
  }
}

//------------------------------------------------------------------------------
void ClippingHandles::Refresh()
{
  this->View->GetOverlay()->FollowCamera();
  this->Box.Refresh(this->Shown);
  const std::size_t count = this->Shown ? this->Document->GetScene().ClippingPlanes.size() : 0;
  while (this->Planes.size() > count)
  {
    this->Planes.pop_back();
  }
  while (this->Planes.size() < count)
  {
    this->Planes.push_back(
      std::make_unique<ClippingPlaneHandle>(this->Document, this->View, this->Planes.size()));
  }
  for (const auto& plane : this->Planes)
  {
    plane->Refresh();
  }
}

}
