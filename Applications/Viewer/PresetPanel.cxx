#include "PresetPanel.h"

#include "OutputFile.h"
#include "PresetThumbnails.h"
#include "SceneDocument.h"
#include "VolumeFields.h"
#include "VolumeView.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <vtkImageData.h>

#include <exception>

namespace penumbra
{

//------------------------------------------------------------------------------
PresetPanel::PresetPanel(SceneDocument* document, VolumeView* view, QWidget* parent)
  : QWidget(parent)
  , Document(document)
  , View(view)
  , List(new QListWidget(this))
  , Thumbnails(new PresetThumbnails(this))
{
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  this->List->setObjectName("presetList");
  this->List->setAccessibleName(tr("Presets"));
  this->List->setViewMode(QListView::IconMode);
  this->List->setIconSize({ PresetThumbnails::Size, PresetThumbnails::Size });
  this->List->setGridSize({ PresetThumbnails::Size + 12, PresetThumbnails::Size + 26 });
  this->List->setMovement(QListView::Static);
  this->List->setResizeMode(QListView::Adjust);
  this->List->setSelectionMode(QAbstractItemView::NoSelection); // the one in use is marked instead
  this->List->setMinimumHeight(PresetThumbnails::Size + 34);
  column->addWidget(this->List);
  auto* const row = new QHBoxLayout;
  auto* const load = new QPushButton(tr("Load preset..."), this);
  load->setToolTip(tr("Use a look that was saved before"));
  auto* const save = new QPushButton(tr("Save preset..."), this);
  save->setToolTip(tr("Keep transfer function and material for other volumes"));
  row->addWidget(load);
  row->addWidget(save);
  column->addLayout(row);
  this->setEnabled(false);
  this->connect(load, &QPushButton::clicked, this, &PresetPanel::AskAndLoad);
  this->connect(save, &QPushButton::clicked, this, &PresetPanel::AskAndSave);
  this->connect(document, &SceneDocument::opened, this, &PresetPanel::ShowOpened);
  this->connect(document, &SceneDocument::changed, this, &PresetPanel::MarkUsed);
  this->connect(view, &VolumeView::refined, this, &PresetPanel::DrawThumbnails);
  const auto choose = [this](QListWidgetItem* item)
  { this->Apply(this->Presets[static_cast<std::size_t>(this->List->row(item))].Name, {}); };
  this->connect(this->List, &QListWidget::itemClicked, this, choose);
  this->connect(this->List, &QListWidget::itemActivated, this, choose);
  this->connect(this->Thumbnails, &PresetThumbnails::drawn, this,
    [this](int preset, const QImage& picture)
    { this->List->item(preset)->setIcon(QIcon(QPixmap::fromImage(picture))); });
}

//------------------------------------------------------------------------------
void PresetPanel::ShowOpened()
{
  this->setEnabled(true);
  this->Thumbnails->Stop();
  this->List->clear();
  this->Looks.clear();
  vtkImageData* volume = this->Document->GetVoxels().Volume;
  this->Statistics.emplace(volume);
  this->Presets = ListPresets(TextField(volume, "Modality"));
  QPixmap empty(PresetThumbnails::Size, PresetThumbnails::Size);
  empty.fill(this->palette().color(QPalette::Mid));
  for (const PresetName& preset : this->Presets)
  {
    auto* const item =
      new QListWidgetItem(QIcon(empty), QString::fromStdString(preset.Name), this->List);
    item->setToolTip(QString::fromStdString(preset.Description));
    this->Looks.push_back(
      LookOfPreset(preset.Name, volume, *this->Statistics, this->Document->GetScene()));
  }
  this->ThumbnailsDue = true;
}

//------------------------------------------------------------------------------
void PresetPanel::MarkUsed()
{
  const std::string look = LookOf(this->Document->GetScene());
  QColor mark = this->palette().color(QPalette::Highlight);
  mark.setAlphaF(0.35);
  for (int row = 0; row < this->List->count(); ++row)
  {
    const bool used = this->Looks[static_cast<std::size_t>(row)] == look;
    QListWidgetItem* item = this->List->item(row);
    QFont font = this->List->font();
    font.setBold(used);
    item->setFont(font);
    item->setBackground(used ? QBrush(mark) : QBrush());
    item->setData(Qt::AccessibleTextRole, used ? tr("%1, in use").arg(item->text()) : item->text());
  }
}

//------------------------------------------------------------------------------
void PresetPanel::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  this->DrawThumbnails();
}

//------------------------------------------------------------------------------
void PresetPanel::DrawThumbnails()
{
  if (this->ThumbnailsDue && this->isVisible() && this->View->IsRefined())
  {
    this->ThumbnailsDue = false;
    this->Thumbnails->Start(
      this->Document->GetScene(), this->Document->GetVoxels().Volume, this->Presets);
  }
}

//------------------------------------------------------------------------------
void PresetPanel::Apply(const std::string& preset, const std::filesystem::path& folder)
{
  vtkImageData* volume = this->Document->GetVoxels().Volume;
  this->Document->Edit(tr("preset %1").arg(QString::fromStdString(preset)),
    [&](SceneDescription& scene)
    { ApplyPreset(preset, folder, volume, *this->Statistics, scene); });
}

//------------------------------------------------------------------------------
void PresetPanel::Save(const std::filesystem::path& file)
{
  OutputFile output("preset", file);
  output.Write(WritePreset(this->Document->GetScene(), file.stem().u8string()));
  output.Commit();
}

//------------------------------------------------------------------------------
void PresetPanel::AskAndLoad()
{
  const QString file =
    QFileDialog::getOpenFileName(this, tr("Load a preset"), QString(), tr("Presets (*.json)"));
  if (!file.isEmpty())
  {
    const auto path = std::filesystem::u8path(file.toStdString());
    this->Apply(path.filename().u8string(), path.parent_path());
  }
}

//------------------------------------------------------------------------------
void PresetPanel::AskAndSave()
{
  QString file = QFileDialog::getSaveFileName(
    this, tr("Save the look as a preset"), QString(), tr("Presets (*.json)"));
  if (file.isEmpty())
  {
    return;
  }
  file += file.endsWith(".json", Qt::CaseInsensitive) ? "" : ".json";
  try
  {
    this->Save(std::filesystem::u8path(file.toStdString()));
  }
  catch (const std::exception& error)
  {
    emit this->Document->refused(QString::fromUtf8(error.what()));
  }
}

}
