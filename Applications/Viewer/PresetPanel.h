/**
 * @class   PresetPanel
 * @brief   looks to choose from, with pictures of the open volume
 *
 * The one that is in use is marked until transfer function or material are edited.
 */

#ifndef PresetPanel_h
#define PresetPanel_h

#include "PresetLook.h"

#include <QWidget>

#include <optional>

class QListWidget;
class QListWidgetItem;

namespace penumbra
{

class PresetThumbnails;
class SceneDocument;
class VolumeView;

class PresetPanel : public QWidget
{
  Q_OBJECT
public:
  PresetPanel(SceneDocument* document, VolumeView* view, QWidget* parent = nullptr);

  /// By its name, or a file's name in `folder`.
  void Apply(const std::string& preset, const std::filesystem::path& folder);

  /// Writes the look of the scene. @throw InputError or RenderingError where that fails.
  void Save(const std::filesystem::path& file);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void ShowOpened();
  void MarkUsed();
  void DrawThumbnails();
  void AskAndLoad();
  void AskAndSave();

  SceneDocument* Document;
  VolumeView* View;
  QListWidget* List;
  PresetThumbnails* Thumbnails;
  std::vector<PresetName> Presets;
  /// What LookOf() tells of a scene in which they are used.
  std::vector<std::string> Looks;
  std::optional<VolumeStatistics> Statistics;
  bool ThumbnailsDue = false;
};

}

#endif
