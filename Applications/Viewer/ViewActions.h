/**
 * @class   ViewActions
 * @brief   the menu of views: from where one looks, and what is drawn beside the volume
 */

#ifndef ViewActions_h
#define ViewActions_h

#include <QObject>

class QMenu;
class QToolBar;

namespace penumbra
{

class SceneDocument;
class ViewDecorations;
class VolumeView;

class ViewActions : public QObject
{
  Q_OBJECT
public:
  ViewActions(SceneDocument* document, VolumeView* view, QObject* parent);

  void Fill(QMenu* menu, QToolBar* bar);

private:
  void FillDirections(QMenu* menu);
  void AddToggle(
    QMenu* menu, const QString& text, const QString& tip, void (ViewDecorations::*show)(bool));
  void FillTheme(QMenu* menu);
  void ToggleParallel(bool parallel);

  SceneDocument* Document;
  VolumeView* View;
};

}

#endif
