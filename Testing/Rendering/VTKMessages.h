/**
 * @file VTKMessages.h
 * @brief Collects what VTK says while this object lives, errors and warnings alike.
 */
#ifndef VTKMessages_h
#define VTKMessages_h

#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkStringOutputWindow.h>

namespace penumbra
{
class VTKMessages
{
public:
  VTKMessages() { vtkOutputWindow::SetInstance(this->Window); }
  ~VTKMessages() { vtkOutputWindow::SetInstance(nullptr); }
  VTKMessages(const VTKMessages&) = delete;
  void operator=(const VTKMessages&) = delete;

  std::string Text() const { return this->Window->GetOutput(); }

private:
  vtkNew<vtkStringOutputWindow> Window;
};
}

#endif
