/**
 * @class   vtkOffscreenWindow
 * @brief   a render window on an OpenGL context that needs no window system
 *
 * VTK before 9.4 has such windows only where it was built for nothing else. The picture lives in
 * VTK's own framebuffer objects and is read from there, as by vtkWindowToImageFilter.
 *
 * Where no context can be made the window says so once, SupportsOpenGL() is 0, and rendering and
 * reading pixels do nothing.
 */
#ifndef vtkOffscreenWindow_h
#define vtkOffscreenWindow_h

#include "OffscreenContext.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <memory>

class vtkOffscreenWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkOffscreenWindow* New();
  vtkTypeMacro(vtkOffscreenWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What makes the contexts of all windows that are created from now on.
   */
  static void SetContextMaker(penumbra::OffscreenContextMaker maker);
  static penumbra::OffscreenContextMaker GetContextMaker();
  ///@}

  ///@{
  /**
   * The context is made by the first call that needs it, and again after Finalize().
   */
  void Initialize() override;
  void MakeCurrent() override;
  bool IsCurrent() override;
  void Render() override;
  void Finalize() override;
  ///@}

  int SupportsOpenGL() override;
  vtkTypeBool IsDirect() override;
  const char* ReportCapabilities() override;

  void OpenGLInitContext() override;

protected:
  vtkOffscreenWindow();
  ~vtkOffscreenWindow() override;

private:
  vtkOffscreenWindow(const vtkOffscreenWindow&) = delete;
  void operator=(const vtkOffscreenWindow&) = delete;

  void MakeContext();

  penumbra::OffscreenContextMaker ContextMaker;
  std::unique_ptr<penumbra::OffscreenContext> Context;
};

#endif
