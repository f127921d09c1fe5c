#include "WindowKinds.h"

#include "vtkOffscreenWindow.h"

// These headers register VTK's OpenGL classes with its object factories (vtk_module_autoinit).
#include <vtkRenderingCoreModule.h>
#include <vtkRenderingVolumeModule.h>

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkVersion.h>

#include <cstdlib>
#include <stdexcept>

namespace
{
VTK_CREATE_CREATE_FUNCTION(vtkOffscreenWindow);

class vtkOffscreenWindowFactory : public vtkObjectFactory
{
public:
  static vtkOffscreenWindowFactory* New();
  vtkTypeMacro(vtkOffscreenWindowFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Windows without X server"; }

protected:
  vtkOffscreenWindowFactory()
  {
    this->RegisterOverride("vtkRenderWindow", "vtkOffscreenWindow", "Needs no X server", 1,
      vtkObjectFactoryCreatevtkOffscreenWindow);
  }
};

vtkStandardNewMacro(vtkOffscreenWindowFactory);
}

namespace penumbra
{
namespace
{
OffscreenContextMaker ContextMaker([[maybe_unused]] WindowKind kind)
{
#ifdef PENUMBRA_HAS_OSMESA
  if (kind == WindowKind::OSMesa)
  {
    return MakeOSMesaContext;
  }
#endif
#ifdef PENUMBRA_HAS_EGL
  if (kind == WindowKind::EGL)
  {
    return MakeEGLContext;
  }
#endif
  return nullptr;
}

std::string WhyNoX()
{
  const char* display = std::getenv("DISPLAY");
  return display && *display ? "" : "there is no X server (DISPLAY is not set)";
}
}

std::string WhyUnavailable(WindowKind kind)
{
  if (kind == WindowKind::Native)
  {
    return WhyNoX();
  }
  const OffscreenContextMaker maker = ContextMaker(kind);
  if (!maker)
  {
    return "its library was not found when this program was built";
  }
  try
  {
    return maker()->MakeCurrent() ? "" : "its context cannot be made current";
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}

void InstallWindowKind(WindowKind kind)
{
  if (kind == WindowKind::Native)
  {
    return;
  }
  vtkOffscreenWindow::SetContextMaker(ContextMaker(kind));
  // The factory asked first wins, and VTK's own window has been registered first.
  vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderWindow");
  vtkObjectFactory::RegisterFactory(vtkNew<vtkOffscreenWindowFactory>());
}
}
