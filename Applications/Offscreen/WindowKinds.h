/**
 * @file WindowKinds.h
 * @brief What each supported version of VTK has to say about the kinds of windows.
 *
 * VTK 9.4 and newer have all kinds themselves (VTKWindowKinds.cxx); older ones are given
 * vtkOffscreenWindow (OwnWindowKinds.cxx) where windows are of an X server, and elsewhere have
 * their own alone (NativeWindowKind.cxx).
 */
#ifndef WindowKinds_h
#define WindowKinds_h

#include <string>

namespace penumbra
{
enum class WindowKind
{
  OSMesa,
  EGL,
  Native
};

/// Why windows of this kind cannot be made here; empty where they can.
std::string WhyUnavailable(WindowKind kind);

/// Makes vtkRenderWindow::New() give windows of this kind.
void InstallWindowKind(WindowKind kind);
}

#endif
