/**
 * @file IlluminatedScene.h
 * @brief A small scene of one volume and its lights, with everything in reach of a test.
 *
 * The volume's values 0 to 255 rise from transparent red to dense near-white. The camera looks at
 * the volume's centre from above, from the right and from the front, with everything set by
 * numbers.
 */
#ifndef IlluminatedScene_h
#define IlluminatedScene_h

#include "vtkIlluminatedVolumeMapper.h"
#include "vtkVolumeLight.h"

#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>

namespace penumbra
{
class IlluminatedScene
{
public:
  explicit IlluminatedScene(vtkImageData* image, int width = 128, int height = 128);

  vtkVolumeLight* AddDirectionalLight(double x, double y, double z, int shadow);
  vtkVolumeLight* AddPointLight(double x, double y, double z, int shadow);
  vtkVolumeLight* GetLight();

  /// Looks at a point from a direction and distance, with clipping planes that hold both.
  void LookFrom(double x, double y, double z, double distance, const double target[3]);
  void Shade(bool on);
  vtkSmartPointer<vtkImageData> Render();

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkIlluminatedVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkColorTransferFunction> Color;
};
}

#endif
