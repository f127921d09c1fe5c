/**
 * @class   ClippingHandles
 * @brief   the clipping box and planes of the scene in the 3D view, to be dragged
 */

#ifndef ClippingHandles_h
#define ClippingHandles_h

#include "ClippingBoxHandle.h"
#include "ClippingPlaneHandle.h"

#include <QObject>

#include <memory>
#include <vector>

namespace penumbra
{

class ClippingHandles : public QObject
{
  Q_OBJECT
public:
  /// The view has to outlive it.
  ClippingHandles(SceneDocument* document, VolumeView* view, QObject* parent = nullptr);

  void Show(bool shown);

private:
  void Refresh();

  SceneDocument* Document;
  VolumeView* View;
  ClippingBoxHandle Box;
  std::vector<std::unique_ptr<ClippingPlaneHandle>> Planes;
  bool Shown = false;
};

}

#endif
