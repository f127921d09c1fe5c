#include <VolumeFile.h>
#include <vtkColorTransferFunction.h>
#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeLight.h>
#include <vtkVolumeProperty.h>

int main(int argc, char* argv[])
{
  std::vector<std::string> warnings;
  auto image = penumbra::ReadVolumeFile(argc > 1 ? argv[1] : "stent.mhd", {}, warnings);

  vtkNew<vtkIlluminatedVolumeMapper> mapper; // where vtkGPUVolumeRayCastMapper stood
  mapper->SetInputData(image);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);

  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(200, 0.0);
  opacity->AddPoint(500, 0.6);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(200, 0.8, 0.4, 0.3);
  color->AddRGBPoint(500, 1.0, 0.95, 0.85);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetInterpolationTypeToLinear();
  volume->GetProperty()->ShadeOn();

  vtkNew<vtkVolumeLight> light; // a vtkLight that casts shadows inside volumes
  light->SetPosition(1, 2, 3);
  light->SetShadowToSoft();

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->AddLight(light);
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
