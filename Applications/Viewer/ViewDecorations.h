/**
 * @class   ViewDecorations
 * @brief   what the view draws beside the volume: orientation, scale bar
 *
 * They tell what is left and right, and how large things are. They are no part of the scene and are
 * on no picture that is saved.
 */

#ifndef ViewDecorations_h
#define ViewDecorations_h

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkActor2D;
class vtkAnnotatedCubeActor;
class vtkOrientationMarkerWidget;
class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkTextActor;
class vtkPoints;

namespace penumbra
{

class ViewDecorations
{
public:
  explicit ViewDecorations(vtkRenderWindowInteractor* interactor);
  ~ViewDecorations();

  /// Draws over this renderer from now on. A patient's axes get letters: R/L, A/P, S/I; `unit` is
  /// that of the scene's lengths.
  void Attach(vtkRenderer* renderer, bool isPatient, const std::string& unit);
  void Detach();

  void ShowOrientation(bool shown);
  void ShowScaleBar(bool shown);

  /// Takes all of it away for a while.
  void Hide(bool hidden);

  /// To be called before each frame: the bar has a round length at the focal point.
  void FitScaleBar();

private:
  void SetLetters(bool isPatient);
  void Refresh();

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkNew<vtkOrientationMarkerWidget> Marker;
  vtkNew<vtkAnnotatedCubeActor> Cube;
  vtkNew<vtkPoints> BarPoints;
  vtkNew<vtkActor2D> Bar;
  vtkNew<vtkTextActor> BarText;
  std::string Unit;
  bool OrientationShown = true;
  bool ScaleBarShown = true;
  bool Hidden = false;
};

/// The largest of 1, 2 and 5 times a power of ten that is not above `length`.
double RoundLength(double length);

}

#endif
