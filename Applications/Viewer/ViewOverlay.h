/**
 * @class   ViewOverlay
 * @brief   a layer over the scene for what is dragged in the view
 *
 * It is seen by the scene's camera, whatever it shows lies over the volume, and it is on no picture
 * that is saved.
 */

#ifndef ViewOverlay_h
#define ViewOverlay_h

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkAbstractWidget;
class vtkRenderWindow;
class vtkRenderWindowInteractor;
class vtkRenderer;

namespace penumbra
{

class ViewOverlay
{
public:
  explicit ViewOverlay(vtkRenderWindow* window);

  /// Lies over this renderer's scene from now on.
  void Attach(vtkRenderer* scene);

  /// Where the camera is now; each frame begins with it.
  void FollowCamera();

  /// Lets a widget be drawn and dragged here, by the left button: the others are the camera's.
  void Add(vtkAbstractWidget* widget, vtkRenderWindowInteractor* interactor);

  void Show(bool shown);

  vtkRenderer* GetRenderer() { return this->Renderer; }

private:
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderer> Scene;
};

}

#endif
