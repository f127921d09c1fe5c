/**
 * @class   PresetThumbnails
 * @brief   small pictures of the open volume by each preset
 *
 * They are drawn one after the other while nothing else is to be done, of a coarse copy of the
 * volume.
 */

#ifndef PresetThumbnails_h
#define PresetThumbnails_h

#include "PresetLook.h"
#include "SceneVolume.h"

#include <QImage>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace penumbra
{

class OffscreenView;
class SceneRendering;

class PresetThumbnails : public QObject
{
  Q_OBJECT
public:
  static constexpr int Size = 84;

  explicit PresetThumbnails(QObject* parent = nullptr);
  ~PresetThumbnails() override;

  /// Begins to draw the volume of this scene by these presets.
  void Start(
    const SceneDescription& scene, vtkImageData* volume, const std::vector<PresetName>& presets);
  void Stop();

signals:
  void drawn(int preset, const QImage& picture);

private:
  void DrawNext();
  SceneDescription SceneOf(const std::string& preset) const;

  QTimer Timer;
  std::vector<PresetName> Presets;
  std::size_t Next = 0;
  SceneDescription Scene;
  SceneVoxels Voxels;
  std::optional<VolumeStatistics> Statistics;
  std::unique_ptr<SceneRendering> Rendering;
  std::unique_ptr<OffscreenView> View;
};

}

#endif
