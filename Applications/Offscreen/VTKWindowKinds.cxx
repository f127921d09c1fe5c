#include "WindowKinds.h"

// These headers register VTK's OpenGL classes with its object factories (vtk_module_autoinit).
#include <vtkRenderingCoreModule.h>
#include <vtkRenderingVolumeModule.h>

#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkRenderWindow.h>
#include <vtksys/SystemTools.hxx>

#include <string>

namespace penumbra
{
namespace
{
constexpr const char* vtkChoice = "VTK_DEFAULT_OPENGL_WINDOW";

const char* ClassName(WindowKind kind)
{
  switch (kind)
  {
    case WindowKind::OSMesa:
      return "vtkOSOpenGLRenderWindow";
    case WindowKind::EGL:
      return "vtkEGLRenderWindow";
    case WindowKind::Native:
      break;
  }
  return "vtkXOpenGLRenderWindow";
}

void AskVTKFor(WindowKind kind)
{
  vtksys::SystemTools::PutEnv(std::string(vtkChoice) + "=" + ClassName(kind));
}

/// VTK makes another kind where the asked one does not work, and warns of it.
std::string ClassMadeFor(WindowKind kind)
{
  AskVTKFor(kind);
  const int warnings = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  std::string made;
  {
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(true);
    made = window->SupportsOpenGL() ? window->GetClassName() : "";
  }
  vtkObject::SetGlobalWarningDisplay(warnings);
  vtksys::SystemTools::UnPutEnv(vtkChoice);
  return made;
}
}

std::string WhyUnavailable(WindowKind kind)
{
#if !defined(__unix__)
  if (kind == WindowKind::Native)
  {
    return "";
  }
#endif
  return ClassMadeFor(kind) == ClassName(kind)
    ? ""
    : std::string("VTK cannot make a ") + ClassName(kind) + " here";
}

void InstallWindowKind(WindowKind kind)
{
  if (kind != WindowKind::Native)
  {
    AskVTKFor(kind);
  }
}
}
