#include "RenderToImage.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>

#include <stdexcept>

vtkSmartPointer<vtkImageData> penumbra::RenderToImage(vtkRenderWindow* window)
{
  if (!window->SupportsOpenGL())
  {
    throw std::runtime_error("the window has no OpenGL");
  }
  window->Render();
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->SetInputBufferTypeToRGB();
  filter->ShouldRerenderOff();
  filter->Update();
  return filter->GetOutput();
}
