/**
 * @class   PipelineTree
 * @brief   what the picture is made of, from the file to the lights
 *
 * Eyes show and hide: a light's turns it on and off, which is an edit of the scene; the volume's is
 * of the view alone, and opens with each file. Selecting a part, and surely a double click or the
 * return key, brings up its controls.
 */

#ifndef PipelineTree_h
#define PipelineTree_h

#include <QTreeWidget>

namespace penumbra
{

class SceneDocument;

enum class PipelinePart
{
  Reader,
  Volume,
  Rendering,
  Light
};

class PipelineTree : public QTreeWidget
{
  Q_OBJECT
public:
  explicit PipelineTree(SceneDocument* document, QWidget* parent = nullptr);

signals:
  void selected(penumbra::PipelinePart part);
  void controlsAsked(penumbra::PipelinePart part);
  void volumeShown(bool shown);

private:
  QTreeWidgetItem* AddPart(QTreeWidgetItem* above, const QString& text, PipelinePart part);
  QTreeWidgetItem* AddVolume(QTreeWidgetItem* reader);
  QTreeWidgetItem* AddLight(QTreeWidgetItem* volume, std::size_t light);
  void Rebuild();
  void TakeSelection();
  void TakeEye(QTreeWidgetItem* item);
  void ShowVolume(bool shown);
  void TurnLight(int light, bool on);

  SceneDocument* Document;
  bool VolumeShown = true;
};

}

#endif
