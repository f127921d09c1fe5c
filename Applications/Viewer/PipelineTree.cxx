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
QTreeWidgetItem* PipelineTree::AddLight(QTreeWidgetItem* volume, std::size_t light)
{
  const SceneDescription& scene = this->Document->GetScene();
  const QString name = NameOfLight(scene, light);
  const bool on = scene.Lights[light].On;
  QTreeWidgetItem* item = this->AddPart(volume, name, PipelinePart::Light);
  item->setData(0, LightRole, static_cast<int>(light));
  item->setCheckState(0, on ? Qt::Checked : Qt::Unchecked);
  item->setData(
    0, Qt::AccessibleTextRole, on ? tr("%1, shown").arg(name) : tr("%1, hidden").arg(name));
  item->setToolTip(0,
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
  QTreeWidgetItem* volume = this->AddPart(reader, tr("Volume"), PipelinePart::Volume);
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
  const int light = item->data(0, LightRole).toInt();
  const bool on = item->checkState(0) == Qt::Checked;
  // The edit rebuilds the tree, whose item still speaks.
  QMetaObject::invokeMethod(
    this,
    [=]
    {
      this->Document->Edit(on ? tr("light on") : tr("light off"),
        [=](SceneDescription& scene) { scene.Lights[light].On = on; });
    },
    Qt::QueuedConnection);
}

}
