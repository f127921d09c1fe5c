#include "ViewHandles.h"

#include "ClippingHandles.h"
#include "LightHandle.h"
#include "SceneDocument.h"
#include "VolumeView.h"

#include <QAction>

namespace penumbra
{

//------------------------------------------------------------------------------
ViewHandles::ViewHandles(SceneDocument* document, VolumeView* view, QObject* parent)
  : QObject(parent)
  , Light(new LightHandle(document, view, this))
  , Clipping(new ClippingHandles(document, view, this))
  , LightAction(this->MakeAction("showLight", tr("&Show the selected light in the view"), tr("L")))
  , ClippingAction(this->MakeAction("dragClipping", tr("Drag the &clipping in the view"), tr("C")))
{
  this->LightAction->setToolTip(tr("A ball in the view that can be dragged to move the light"));
  this->ClippingAction->setToolTip(
    tr("The clipping box and planes in the view: drag a ball to cut more or less, an arrow to turn "
       "a plane"));
  this->connect(this->LightAction, &QAction::toggled, this->Light, &LightHandle::Show);
  this->connect(this->ClippingAction, &QAction::toggled, this->Clipping, &ClippingHandles::Show);
}

//------------------------------------------------------------------------------
QAction* ViewHandles::MakeAction(const char* name, const QString& text, const QString& keys)
{
  auto* const action = new QAction(text, this);
  action->setObjectName(name);
  action->setShortcut(keys);
  action->setCheckable(true);
  return action;
}

}
