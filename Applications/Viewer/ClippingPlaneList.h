/**
 * @class   ClippingPlaneList
 * @brief   the scene's clipping planes, to be added, removed, flipped and selected
 */

#ifndef ClippingPlaneList_h
#define ClippingPlaneList_h

#include <QWidget>

class QListWidget;

namespace penumbra
{

class SceneDocument;
class VolumeView;

class ClippingPlaneList : public QWidget
{
  Q_OBJECT
public:
  ClippingPlaneList(SceneDocument* document, VolumeView* view, QWidget* parent = nullptr);

signals:
  void added();

private:
  QWidget* MakeButtons();
  void Add();
  void RemoveSelected();
  void FlipSelected();
  void TurnSelected();
  void Refresh();

  SceneDocument* Document;
  VolumeView* View;
  QListWidget* List;
  /// Need a selected plane.
  QList<QWidget*> Buttons;
};

}

#endif
