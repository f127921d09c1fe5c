/**
 * @class   LightHandle
 * @brief   the selected light in the 3D view, to be dragged
 *
 * A ball where the light is, or for directional lights towards where it comes from, and a line to
 * where it shines. It is drawn over the volume and is on no picture that is saved. The view has to
 * outlive it.
 */

#ifndef LightHandle_h
#define LightHandle_h

#include "Vector3.h"

#include <QObject>

#include <vtkNew.h>

class vtkActor;
class vtkHandleWidget;
class vtkLineSource;
class vtkSphereHandleRepresentation;

namespace penumbra
{

class SceneDocument;
class VolumeView;

class LightHandle : public QObject
{
  Q_OBJECT
public:
  LightHandle(SceneDocument* document, VolumeView* view, QObject* parent = nullptr);
  ~LightHandle() override;

  void Show(bool shown);

  /// Where the ball is, in the world.
  Vector3 GetPlace() const;
  /// Drags the ball there.
  void Drag(Vector3 place);

  bool IsShown() const { return this->Shown; }

private:
  void Refresh();
  void TakePlace();

  SceneDocument* Document;
  VolumeView* View;
  vtkNew<vtkHandleWidget> Widget;
  vtkNew<vtkSphereHandleRepresentation> Ball;
  vtkNew<vtkLineSource> Line;
  vtkNew<vtkActor> LineActor;
  bool Shown = false;
};

}

#endif
