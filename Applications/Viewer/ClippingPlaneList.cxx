#include "ClippingPlaneList.h"

#include "PanelButton.h"
#include "SceneDocument.h"
#include "VolumeView.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>

namespace penumbra
{
namespace
{
constexpr int ListHeight = 76;

// Cuts away what is before the point that the camera looks at.
ClippingPlaneDescription PlaneAcrossView(const VolumeView* view)
{
  const ViewFrame frame = view->GetFrame();
  return { frame.FocalPoint, Scaled(frame.Backward, -1.0) };
}
}

//------------------------------------------------------------------------------
ClippingPlaneList::ClippingPlaneList(SceneDocument* document, VolumeView* view, QWidget* parent)
  : QWidget(parent)
  , Document(document)
  , View(view)
  , List(new QListWidget(this))
{
  this->List->setObjectName("planeList");
  this->List->setAccessibleName(tr("Clipping planes"));
  this->List->setToolTip(tr("Planes that cut matter away; what is cut away casts no shadow."));
  this->List->setMaximumHeight(ListHeight);
  this->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 6, 0, 0);
  layout->addWidget(this->List);
  layout->addWidget(this->MakeButtons());
  this->connect(this->List, &QListWidget::currentRowChanged, document, &SceneDocument::SelectPlane);
  this->connect(document, &SceneDocument::changed, this, &ClippingPlaneList::Refresh);
  this->connect(document, &SceneDocument::planeSelected, this, &ClippingPlaneList::Refresh);
}

//------------------------------------------------------------------------------
QWidget* ClippingPlaneList::MakeButtons()
{
  struct Button
  {
    QString Text;
    QString Tip;
    const char* Name;
    void (ClippingPlaneList::*Task)();
  };
  const Button buttons[] = { { tr("Add plane"),
                               tr("Cut away what lies between you and the middle of the view"),
                               "addPlane", &ClippingPlaneList::Add },
    { tr("Remove"), tr("Bring back what the selected plane cuts away"), "removePlane",
      &ClippingPlaneList::RemoveSelected },
    { tr("Flip"), tr("Cut away the other side of the selected plane"), "flipPlane",
      &ClippingPlaneList::FlipSelected },
    { tr("Face me"), tr("Turn the selected plane to cut across your view as it is now"),
      "turnPlane", &ClippingPlaneList::TurnSelected } };
  auto* const row = new QWidget(this);
  auto* const layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  for (const auto& [text, tip, name, task] : buttons)
  {
    QToolButton* button = MakePanelButton(text, tip, row);
    button->setObjectName(name);
    this->connect(button, &QToolButton::clicked, this, task);
    layout->addWidget(button);
    if (task != &ClippingPlaneList::Add)
    {
      this->Buttons << button;
    }
  }
  return row;
}

//------------------------------------------------------------------------------
void ClippingPlaneList::Add()
{
  this->Document->Edit(tr("new clipping plane"),
    [this](SceneDescription& scene)
    { scene.ClippingPlanes.push_back(PlaneAcrossView(this->View)); });
  this->Document->SelectPlane(
    static_cast<int>(this->Document->GetScene().ClippingPlanes.size()) - 1);
  emit this->added();
}

//------------------------------------------------------------------------------
void ClippingPlaneList::RemoveSelected()
{
  const int plane = this->Document->GetSelectedPlane();
  this->Document->Edit(tr("removal of a clipping plane"),
    [=](SceneDescription& scene)
    { scene.ClippingPlanes.erase(scene.ClippingPlanes.begin() + plane); });
}

//------------------------------------------------------------------------------
void ClippingPlaneList::FlipSelected()
{
  const int plane = this->Document->GetSelectedPlane();
  this->Document->Edit(tr("flip of a clipping plane"),
    [=](SceneDescription& scene)
    {
      Vector3& normal = scene.ClippingPlanes[plane].Normal;
      normal = Scaled(normal, -1.0);
    });
}

//------------------------------------------------------------------------------
void ClippingPlaneList::TurnSelected()
{
  const int plane = this->Document->GetSelectedPlane();
  this->Document->Edit(tr("turn of a clipping plane"),
    [=](SceneDescription& scene) { scene.ClippingPlanes[plane] = PlaneAcrossView(this->View); });
}

//------------------------------------------------------------------------------
void ClippingPlaneList::Refresh()
{
  const QSignalBlocker blocker(this->List);
  const int count = static_cast<int>(this->Document->GetScene().ClippingPlanes.size());
  while (this->List->count() > count)
  {
    delete this->List->takeItem(count);
  }
  while (this->List->count() < count)
  {
    this->List->addItem(tr("Plane %1").arg(this->List->count() + 1));
  }
  this->List->setCurrentRow(this->Document->GetSelectedPlane());
  this->List->setVisible(count > 0);
  for (QWidget* button : this->Buttons)
  {
    button->setEnabled(count > 0);
  }
}

}
