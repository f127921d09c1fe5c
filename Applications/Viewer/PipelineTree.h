/**
 * @class   PipelineTree
 * @brief   what the picture is made of, from the file to the lights
 *
 * Check boxes are eyes: what is unchecked is not seen. Selecting a part brings up its controls.
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

private:
  QTreeWidgetItem* AddPart(QTreeWidgetItem* above, const QString& text, PipelinePart part);
  void Rebuild();
  void TakeSelection();
  void TakeCheck(QTreeWidgetItem* item);

  SceneDocument* Document;
};

}

#endif
