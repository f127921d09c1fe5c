#include "WindowKinds.h"

// These headers register VTK's OpenGL classes with its object factories (vtk_module_autoinit).
#include <vtkRenderingCoreModule.h>
#include <vtkRenderingVolumeModule.h>

namespace penumbra
{
std::string WhyUnavailable(WindowKind kind)
{
  return kind == WindowKind::Native ? "" : "this system needs VTK 9.4 or newer for it";
}

void InstallWindowKind(WindowKind) {}
}
