#include "PipelineTree.h"

#include "EyeStyle.h"
#include "LightEdits.h"
#include "SceneDocument.h"

#include <QHeaderView>
#include <QSignalBlocker>

namespace penumbra
{
namespace
{
constexpr int PartRole = Qt::UserRole;
constexpr int LightRole = Qt::UserRole + 1;

PipelinePart PartOf(const QTreeWidgetItem* item)
{
  return static_cast<PipelinePart>(item->data(0, PartRole).toInt());
}

void SetEye(QTreeWidgetItem* item, bool open, const QString& toolTip)
{
  item->setCheckState(0, open ? Qt::Checked : Qt::Unchecked);
  item->setData(0, Qt::AccessibleTextRole,
    (open ? PipelineTree::tr("%1, shown") : PipelineTree::tr("%1, hidden")).arg(item->text(0)));
  item->setToolTip(0, toolTip);
}
}

//------------------------------------------------------------------------------
PipelineTree::PipelineTree(SceneDocument* document, QWidget* parent)
  : QTreeWidget(parent)
  , Document(document)
{
  this->setObjectName("pipelineTree");
  this->setAccessibleName(tr("Pipeline"));
  this->setHeaderHidden(true);
  this->setStyle(new EyeStyle(this));
  this->setMinimumSize(170, 90);
  this->connect(document, &SceneDocument::opened, this, [this] { this->ShowVolume(true); });
  this->connect(document, &SceneDocument::changed, this, &PipelineTree::Rebuild);
  this->connect(document, &SceneDocument::lightSelected, this, &PipelineTree::Rebuild);
  this->connect(this, &QTreeWidget::itemSelectionChanged, this, &PipelineTree::TakeSelection);
  this->connect(this, &QTreeWidget::itemChanged, this, &PipelineTree::TakeEye);
  this->connect(this, &QTreeWidget::itemActivated, this,
    [this](const QTreeWidgetItem* item) { emit this->controlsAsked(PartOf(item)); });
}

//------------------------------------------------------------------------------
QTreeWidgetItem* PipelineTree::AddPart(
  QTreeWidgetItem* above, const QString& text, PipelinePart part)
{
  auto* const item = new QTreeWidgetItem(above, { text });
  item->setData(0, PartRole, static_cast<int>(part));
  if (!above)
  {
    this->addTopLevelItem(item);
  }
  return item;
}

//------------------------------------------------------------------------------
QTreeWidgetItem* PipelineTree::AddVolume(QTreeWidgetItem* reader)
{
  QTreeWidgetItem* item = this->AddPart(reader, tr("Volume"), PipelinePart::Volume);
  SetEye(item, this->VolumeShown,
    this->VolumeShown
      ? tr("Shown. Click the eye, or press Space, to hide the volume in the view.")
      : tr("Hidden in the view; saved scenes and pictures show it. Click the eye, or press Space, "
           "to show it."));
  return item;
}

//------------------------------------------------------------------------------
QTreeWidgetItem* PipelineTree::AddLight(QTreeWidgetItem* volume, std::size_t light)
{
  const SceneDescription& scene = this->Document->GetScene();
  const bool on = scene.Lights[light].On;
  QTreeWidgetItem* item = this->AddPart(volume, NameOfLight(scene, light), PipelinePart::Light);
  item->setData(0, LightRole, static_cast<int>(light));
  SetEye(item, on,
    on ? tr("Shown: the light shines. Click the eye, or press Space, to hide it.")
       : tr("Hidden: the light is off. Click the eye, or press Space, to show it."));
  return item;
}

//------------------------------------------------------------------------------
void PipelineTree::Rebuild()
{
  const QSignalBlocker blocker(this);
  const QTreeWidgetItem* before = this->currentItem();
  const int part = before ? before->data(0, PartRole).toInt() : -1;
  this->clear();
  const SceneDescription& scene = this->Document->GetScene();
  const QString file = QString::fromStdString(scene.Volume.File.filename().u8string());
  QTreeWidgetItem* reader = this->AddPart(nullptr, file, PipelinePart::Reader);
  reader->setToolTip(0, QString::fromStdString(scene.Volume.File.u8string()));
  QTreeWidgetItem* volume = this->AddVolume(reader);
  QTreeWidgetItem* rendering = this->AddPart(reader, tr("Rendering"), PipelinePart::Rendering);
  QTreeWidgetItem* current = nullptr;
  for (QTreeWidgetItem* item : { reader, volume, rendering })
  {
    current = item->data(0, PartRole).toInt() == part ? item : current;
  }
  for (std::size_t i = 0; i < scene.Lights.size(); ++i)
  {
    QTreeWidgetItem* light = this->AddLight(volume, i);
    if (part == static_cast<int>(PipelinePart::Light) &&
      static_cast<int>(i) == this->Document->GetSelectedLight())
    {
      current = light;
    }
  }
  this->expandAll();
  this->setCurrentItem(current);
}

//------------------------------------------------------------------------------
void PipelineTree::TakeSelection()
{
  const QTreeWidgetItem* item = this->currentItem();
  if (!item)
  {
    return;
  }
  const PipelinePart part = PartOf(item);
  const int light = item->data(0, LightRole).toInt();
  if (part == PipelinePart::Light)
  {
    this->Document->SelectLight(light);
  }
  emit this->selected(part);
}

//------------------------------------------------------------------------------
void PipelineTree::TakeEye(QTreeWidgetItem* item)
{
  const bool isVolume = PartOf(item) == PipelinePart::Volume;
  const int light = item->data(0, LightRole).toInt();
  const bool open = item->checkState(0) == Qt::Checked;
  // Both rebuild the tree, whose item still speaks.
  QMetaObject::invokeMethod(
    this, [=] { isVolume ? this->ShowVolume(open) : this->TurnLight(light, open); },
    Qt::QueuedConnection);
}

//------------------------------------------------------------------------------
void PipelineTree::ShowVolume(bool shown)
{
  this->VolumeShown = shown;
  this->Rebuild();
  emit this->volumeShown(shown);
}

//------------------------------------------------------------------------------
void PipelineTree::TurnLight(int light, bool on)
{
  this->Document->Edit(on ? tr("light on") : tr("light off"),
    [=](SceneDescription& scene) { scene.Lights[light].On = on; });
}

}
