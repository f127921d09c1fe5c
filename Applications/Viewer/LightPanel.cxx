#include "LightPanel.h"

#include "DirectionBall.h"
#include "EyeStyle.h"
#include "LightEdits.h"
#include "LightForms.h"
#include "PanelButton.h"
#include "PropertyForm.h"
#include "SceneDocument.h"
#include "ScrollableArea.h"
#include "VolumeBox.h"
#include "VolumeView.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <vtkImageData.h>

namespace penumbra
{
namespace
{
QToolButton* MakeMenuButton(
  const QString& text, const QString& tip, const QList<QAction*>& actions, QWidget* parent)
{
  QToolButton* button = MakePanelButton(text, tip, parent);
  auto* const menu = new QMenu(button);
  menu->addActions(actions);
  menu->setToolTipsVisible(true);
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
  return button;
}
}

//------------------------------------------------------------------------------
LightPanel::LightPanel(SceneDocument* document, VolumeView* view, QWidget* parent)
  : QWidget(parent)
  , Document(document)
  , View(view)
  , List(new QListWidget(this))
{
  this->setObjectName("lightPanel");
  this->List->setObjectName("lightList");
  this->List->setAccessibleName(tr("Lights"));
  this->List->setMaximumHeight(100);
  this->List->setStyle(new EyeStyle(this->List));
  this->List->setToolTip(tr("The lights of the scene; those with a closed eye are off."));
  this->MakeActions();
  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(this->List);
  layout->addWidget(this->MakeButtons());
  layout->addWidget(this->MakePages(), 1);
  this->connect(this->List, &QListWidget::currentRowChanged, document, &SceneDocument::SelectLight);
  this->connect(this->List, &QListWidget::itemChanged, this, &LightPanel::SwitchLight);
  this->connect(document, &SceneDocument::changed, this, &LightPanel::Refresh);
  this->connect(document, &SceneDocument::lightSelected, this, &LightPanel::Refresh);
  this->connect(view, &VolumeView::cameraMoved, this, &LightPanel::ShowDirection);
  this->Refresh();
}

//------------------------------------------------------------------------------
void LightPanel::MakeActions()
{
  const QString names[] = { tr("&Directional light"), tr("&Point light"), tr("&Spot light"),
    tr("&Headlight") };
  const QString tips[] = { tr("Light from far away, like the sun"),
    tr("A lamp near the volume that shines all around"), tr("A lamp with a cone"),
    tr("A lamp at your eye") };
  for (int type = 0; type < 4; ++type)
  {
    auto* const action = new QAction(names[type], this);
    action->setToolTip(tips[type]);
    action->setObjectName("addLight" + QString::number(type));
    this->connect(
      action, &QAction::triggered, this, [=] { this->Add(static_cast<LightType>(type)); });
    this->AddActions << action;
  }
  this->AddActions[0]->setShortcut(tr("Ctrl+L"));
  const auto rigs = GetLightRigs(1.0);
  for (int rig = 0; rig < static_cast<int>(rigs.size()); ++rig)
  {
    auto* const action = new QAction(rigs[rig].Name, this);
    action->setToolTip(rigs[rig].Tip);
    action->setObjectName("rig" + QString::number(rig));
    this->connect(action, &QAction::triggered, this, [=] { this->UseRig(rig); });
    this->RigActions << action;
  }
  this->CopyAction = new QAction(tr("D&uplicate light"), this);
  this->connect(this->CopyAction, &QAction::triggered, this, &LightPanel::CopySelected);
  this->RemoveAction = new QAction(tr("&Remove light"), this);
  this->RemoveAction->setObjectName("removeLight");
  this->RemoveAction->setShortcut(tr("Ctrl+Shift+L"));
  this->connect(this->RemoveAction, &QAction::triggered, this, &LightPanel::RemoveSelected);
  this->ResetAction = new QAction(tr("R&eset lights"), this);
  this->ResetAction->setToolTip(tr("The lights as they were when the scene was opened"));
  this->connect(this->ResetAction, &QAction::triggered, this, &LightPanel::Reset);
}

//------------------------------------------------------------------------------
QWidget* LightPanel::MakeButtons()
{
  auto* const row = new QWidget(this);
  auto* const layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  this->AddButton =
    MakeMenuButton(tr("Add"), tr("Add a light to the scene"), this->AddActions, row);
  this->AddButton->setObjectName("addLightButton");
  layout->addWidget(this->AddButton);
  QToolButton* remove = MakePanelButton(tr("Remove"), tr("Remove the selected light"), row);
  remove->setObjectName("removeLightButton");
  this->connect(remove, &QToolButton::clicked, this->RemoveAction, &QAction::trigger);
  this->connect(this->RemoveAction, &QAction::changed, remove,
    [=] { remove->setEnabled(this->RemoveAction->isEnabled()); });
  layout->addWidget(remove);
  this->RigButton = MakeMenuButton(
    tr("Rigs"), tr("Replace all lights by a tried arrangement"), this->RigActions, row);
  this->RigButton->menu()->addSeparator();
  this->RigButton->menu()->addAction(this->ResetAction);
  layout->addWidget(this->RigButton);
  return row;
}

//------------------------------------------------------------------------------
QWidget* LightPanel::MakePages()
{
  auto* const pages = new QTabWidget(this);
  auto* const simple = new QWidget;
  auto* const layout = new QVBoxLayout(simple);
  this->Hint = new QLabel(simple);
  this->Hint->setObjectName("lightHint");
  this->Hint->setWordWrap(true);
  layout->addWidget(this->Hint);
  this->Ball = new DirectionBall(simple);
  layout->addWidget(this->Ball, 1);
  auto* const form = new PropertyForm(this->Document, simple);
  FillSimpleLightForm(form, this->Document);
  layout->addWidget(form);
  layout->addStretch();
  this->connect(this->Ball, &DirectionBall::edited, this, &LightPanel::TurnSelected);

  auto* const advanced = new PropertyForm(this->Document);
  FillAdvancedLightForm(advanced, this->Document, this->View);
  pages->addTab(MakeScrollable(simple), tr("Simple"));
  pages->addTab(MakeScrollable(advanced), tr("Advanced"));
  return pages;
}

//------------------------------------------------------------------------------
void LightPanel::Add(LightType type)
{
  if (!this->Document->IsOpen())
  {
    return;
  }
  const double bias = SmallestSpacing(this->Document->GetVoxels().Volume);
  this->Document->Edit(tr("new %1").arg(NameOfType(type)),
    [&](SceneDescription& scene)
    { scene.Lights.push_back(MakeNewLight(scene, type, this->View->GetFrame(), bias)); });
  this->Document->SelectLight(static_cast<int>(this->Document->GetScene().Lights.size()) - 1);
}

//------------------------------------------------------------------------------
void LightPanel::CopySelected()
{
  const int light = this->Document->GetSelectedLight();
  this->Document->Edit(tr("copy of a light"),
    [&](SceneDescription& scene) { scene.Lights.push_back(CopyOfLight(scene, light)); });
  this->Document->SelectLight(static_cast<int>(this->Document->GetScene().Lights.size()) - 1);
}

//------------------------------------------------------------------------------
void LightPanel::RemoveSelected()
{
  const int light = this->Document->GetSelectedLight();
  this->Document->Edit(tr("removal of %1").arg(NameOfLight(this->Document->GetScene(), light)),
    [&](SceneDescription& scene) { scene.Lights.erase(scene.Lights.begin() + light); });
}

//------------------------------------------------------------------------------
void LightPanel::UseRig(int rig)
{
  const auto rigs = GetLightRigs(SmallestSpacing(this->Document->GetVoxels().Volume));
  this->Document->Edit(tr("lights: %1").arg(rigs[rig].Name),
    [&](SceneDescription& scene) { scene.Lights = rigs[rig].Lights; });
}

//------------------------------------------------------------------------------
void LightPanel::Reset()
{
  this->Document->Edit(tr("reset of the lights"),
    [this](SceneDescription& scene) { scene.Lights = this->Document->GetOpenedScene().Lights; });
}

//------------------------------------------------------------------------------
void LightPanel::TurnSelected(const Vector3& toLight)
{
  const int light = this->Document->GetSelectedLight();
  this->Document->Edit(
    tr("turn of a light"),
    [&](SceneDescription& scene)
    { TurnLight(scene.Lights[light], this->View->GetFrame(), toLight); },
    "turn" + QString::number(light));
}

//------------------------------------------------------------------------------
void LightPanel::AimSelected(const Vector3& target)
{
  if (HasSelectedLight(this->Document))
  {
    const int light = this->Document->GetSelectedLight();
    this->Document->Edit(tr("aim of a light"),
      [&](SceneDescription& scene)
      { AimLight(scene.Lights[light], this->View->GetFrame(), target); });
  }
}

//------------------------------------------------------------------------------
void LightPanel::SwitchLight(QListWidgetItem* item)
{
  const int light = this->List->row(item);
  const bool on = item->checkState() == Qt::Checked;
  this->Document->Edit(on ? tr("light on") : tr("light off"),
    [=](SceneDescription& scene) { scene.Lights[light].On = on; });
}

//------------------------------------------------------------------------------
void LightPanel::Refresh()
{
  const QSignalBlocker blocker(this->List);
  const bool open = this->Document->IsOpen();
  const int count = open ? static_cast<int>(this->Document->GetScene().Lights.size()) : 0;
  while (this->List->count() > count)
  {
    delete this->List->takeItem(count);
  }
  for (int i = 0; i < count; ++i)
  {
    if (i == this->List->count())
    {
      this->List->addItem(new QListWidgetItem);
    }
    const LightDescription& light = this->Document->GetScene().Lights[i];
    QListWidgetItem* item = this->List->item(i);
    item->setText(NameOfLight(this->Document->GetScene(), i));
    item->setCheckState(light.On ? Qt::Checked : Qt::Unchecked);
    item->setToolTip(light.On ? NameOfType(light.Type) : tr("%1, off").arg(NameOfType(light.Type)));
  }
  this->List->setCurrentRow(this->Document->GetSelectedLight());
  const bool selected = HasSelectedLight(this->Document);
  this->RemoveAction->setEnabled(selected);
  this->CopyAction->setEnabled(selected);
  for (QAction* action : this->AddActions + this->RigActions)
  {
    action->setEnabled(open);
  }
  this->ResetAction->setEnabled(open);
  this->AddButton->setEnabled(open);
  this->RigButton->setEnabled(open);
  this->ShowDirection();
}

//------------------------------------------------------------------------------
void LightPanel::ShowDirection()
{
  const bool selected = HasSelectedLight(this->Document) && this->View->GetRendering();
  this->Ball->setEnabled(selected);
  if (!selected)
  {
    this->Hint->setText(this->Document->IsOpen()
        ? tr("There is no light: add one, or take a rig of several.")
        : tr("Lights can be added once a volume is open."));
    return;
  }
  const LightDescription& light =
    this->Document->GetScene().Lights[this->Document->GetSelectedLight()];
  const bool turns = light.Type != LightType::Headlight;
  this->Hint->setText(turns
      ? tr("Drag the light around the ball; in the ring it shines from behind:")
      : tr("A headlight is at your eye: it shines wherever you look."));
  this->Ball->setEnabled(turns);
  this->Ball->ShowDirection(DirectionToLight(light, this->View->GetFrame()), light.Diffuse);
}

}
