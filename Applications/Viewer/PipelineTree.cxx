#include "PipelineTree.h"

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
}

//------------------------------------------------------------------------------
PipelineTree::PipelineTree(SceneDocument* document, QWidget* parent)
  : QTreeWidget(parent)
  , Document(document)
{
  this->setObjectName("pipelineTree");
  this->setAccessibleName(tr("Pipeline"));
  this->setHeaderHidden(true);
  this->setMinimumSize(170, 90);
  this->connect(document, &SceneDocument::changed, this, &PipelineTree::Rebuild);
  this->connect(document, &SceneDocument::lightSelected, this, &PipelineTree::Rebuild);
  this->connect(this, &QTreeWidget::itemSelectionChanged, this, &PipelineTree::TakeSelection);
  this->connect(this, &QTreeWidget::itemChanged, this, &PipelineTree::TakeCheck);
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
    QTreeWidgetItem* light = this->AddPart(volume, NameOfLight(scene, i), PipelinePart::Light);
    light->setData(0, LightRole, static_cast<int>(i));
    light->setCheckState(0, scene.Lights[i].On ? Qt::Checked : Qt::Unchecked);
    light->setToolTip(0, tr("Check: the light shines"));
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
  const auto part = static_cast<PipelinePart>(item->data(0, PartRole).toInt());
  const int light = item->data(0, LightRole).toInt();
  if (part == PipelinePart::Light)
  {
    this->Document->SelectLight(light);
  }
  emit this->selected(part);
}

//------------------------------------------------------------------------------
void PipelineTree::TakeCheck(QTreeWidgetItem* item)
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
