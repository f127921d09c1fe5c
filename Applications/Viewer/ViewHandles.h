/**
 * @class   ViewHandles
 * @brief   what can be dragged in the 3D view, and the actions that show it
 */

#ifndef ViewHandles_h
#define ViewHandles_h

#include <QObject>

class QAction;

namespace penumbra
{

class ClippingHandles;
class LightHandle;
class SceneDocument;
class VolumeView;

class ViewHandles : public QObject
{
  Q_OBJECT
public:
  /// The view has to outlive it.
  ViewHandles(SceneDocument* document, VolumeView* view, QObject* parent);

  QAction* GetLightAction() { return this->LightAction; }
  QAction* GetClippingAction() { return this->ClippingAction; }
  LightHandle* GetLight() { return this->Light; }

private:
  QAction* MakeAction(const char* name, const QString& text, const QString& keys);

  LightHandle* Light;
  ClippingHandles* Clipping;
  QAction* LightAction;
  QAction* ClippingAction;
};

}

#endif
