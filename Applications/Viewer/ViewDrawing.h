/**
 * @class   ViewDrawing
 * @brief   when and how the frames of the 3D view are drawn
 *
 * While something moves, coarsely; when all is still, the whole picture, strip by strip where it
 * takes long.
 */

#ifndef ViewDrawing_h
#define ViewDrawing_h

#include "StillFrame.h"
#include "ViewQuality.h"

#include <QObject>
#include <QTimer>

#include <vtkSmartPointer.h>

#include <functional>

class QVTKOpenGLNativeWidget;
class vtkImageData;

namespace penumbra
{

class SceneDocument;
class SceneRendering;
class ViewDecorations;
class ViewOverlay;

class ViewDrawing : public QObject
{
  Q_OBJECT
public:
  ViewDrawing(QVTKOpenGLNativeWidget* widget, const SceneDocument* document);

  /// What is drawn from now on; null: nothing.
  void SetRendering(SceneRendering* rendering);

  /// What is drawn over the scene, which has to outlive this.
  void SetOver(ViewDecorations* decorations, ViewOverlay* overlay);

  /// Draws soon; `sceneChanged`: what is kept of shadows is outdated.
  void Schedule(bool sceneChanged);

  /// The whole picture of the scene alone, drawn at once.
  vtkSmartPointer<vtkImageData> TakePicture();

  /// Lets someone else draw a frame now, as coarsely as moving ones.
  void DrawBy(const std::function<void()>& draw);

  bool IsRefined() const { return this->Refined; }

signals:
  void moved();
  /// The whole picture is seen; it took so long.
  void refined(double seconds);

private:
  bool CanDraw() const;
  bool ShadowsChange() const;
  bool AreWholeFramesFluid() const;
  int FindMovingDistance() const;
  int FindQuickDistance() const;
  void SetRayDistance(int distance);
  void DrawMoving();
  void Refine();
  void DrawWhole();
  void DrawCoarsely(int distance);
  double Render();
  void BeginStrips();
  void DrawStrip();
  void EndStrips();
  void Finish(double seconds);
  void ShowOver(bool shown);

  QVTKOpenGLNativeWidget* Widget;
  const SceneDocument* Document;
  SceneRendering* Rendering = nullptr;
  ViewDecorations* Decorations = nullptr;
  ViewOverlay* Overlay = nullptr;
  ViewQuality Quality;
  StillFrame Still;
  QTimer FrameTimer;
  QTimer RefineTimer;
  QTimer StripTimer;
  double SecondsOfLastWholeFrame = 0.0;
  int Distance = 1;
  bool SceneChanged = false;
  bool ShadowsKept = false;
  bool Refined = false;
};

}

#endif
