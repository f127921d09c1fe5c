/**
 * @class   OffscreenView
 * @brief   draws scenes of any size without a window, by Qt's OpenGL
 */

#ifndef OffscreenView_h
#define OffscreenView_h

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>

class vtkGenericOpenGLRenderWindow;
class vtkImageData;
class vtkObject;

namespace penumbra
{

class SceneRendering;

class OffscreenView
{
public:
  /// @throw RenderingError where there is no OpenGL to draw with.
  OffscreenView();
  ~OffscreenView();
  OffscreenView(const OffscreenView&) = delete;
  OffscreenView& operator=(const OffscreenView&) = delete;

  /// What is drawn from now on. It has to outlive this, or be replaced by null.
  void SetRendering(SceneRendering* rendering);

  /// The whole picture, 8-bit RGBA. @throw RenderingError where it cannot be drawn.
  vtkSmartPointer<vtkImageData> TakePicture(const std::array<int, 2>& size);

private:
  void MakeCurrent();
  void TellIsCurrent(vtkObject* caller, unsigned long event, void* answer);

  QOffscreenSurface Surface;
  QOpenGLContext Context;
  vtkNew<vtkGenericOpenGLRenderWindow> Window;
};

}

#endif
