/**
 * @class   VolumeView
 * @brief   the 3D view of the document's scene
 *
 * Left button and arrow keys turn, middle button moves, right button, wheel, plus and minus zoom.
 * Moving is fluid and coarse; the whole picture follows when all is still.
 */

#ifndef VolumeView_h
#define VolumeView_h

#include "LightEdits.h"
#include "SceneDescription.h"
#include "ViewDrawing.h"

#include <QVTKOpenGLNativeWidget.h>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <memory>

class vtkGenericOpenGLRenderWindow;
class vtkImageData;

namespace penumbra
{

class SceneDocument;
class SceneRendering;
class ViewDecorations;
class ViewOverlay;

class VolumeView : public QVTKOpenGLNativeWidget
{
  Q_OBJECT
public:
  explicit VolumeView(SceneDocument* document, QWidget* parent = nullptr);
  ~VolumeView() override;

  /// Null where no scene is open.
  SceneRendering* GetRendering() { return this->Rendering.get(); }

  /// Where the user has moved the camera.
  CameraDescription GetCamera() const;
  void SetCamera(const CameraDescription& camera);

  /// Where the camera is, and its axes. Only where a scene is open.
  ViewFrame GetFrame() const;

  /// Of the picture, in its own pixels, which are smaller than the widget's on fine screens.
  std::array<int, 2> GetPictureSize() const;

  /// The whole picture of the scene, without decorations, drawn at once.
  vtkSmartPointer<vtkImageData> TakePicture() { return this->Drawing.TakePicture(); }

  /// In this view; pictures of the scene show it all the same.
  void ShowVolume(bool shown);

  /// Whether what is seen is the whole picture of the scene as it is now.
  bool IsRefined() const { return this->Drawing.IsRefined(); }

  ViewOverlay* GetOverlay() { return this->Overlay.get(); }
  ViewDecorations* GetDecorations() { return this->Decorations.get(); }

  /// Draws soon: coarsely, if whole frames are slow, and when nothing moves any more as a whole.
  void ScheduleFrame();

signals:
  /// The whole picture is seen; it took so long.
  void refined(double seconds);
  void cameraMoved();
  /// The user asks for light at this point of the world.
  void aimed(const penumbra::Vector3& target);
  /// What the renderer cannot do of the scene, or had to do otherwise.
  void warned(const QStringList& messages);

protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintGL() override;
  void resizeGL(int width, int height) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
  void ShowOpened();
  void Forget();
  void ShowChanged();
  void AttachDecorations();
  void TellWarnings();

  SceneDocument* Document;
  vtkNew<vtkGenericOpenGLRenderWindow> Window;
  std::unique_ptr<SceneRendering> Rendering;
  std::unique_ptr<ViewDecorations> Decorations;
  std::unique_ptr<ViewOverlay> Overlay;
  RendererChoice Renderer = RendererChoice::Penumbra;
  bool VolumeShown = true;
  ViewDrawing Drawing;
};

}

#endif
