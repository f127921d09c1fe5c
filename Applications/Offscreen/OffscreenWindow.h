/**
 * @file OffscreenWindow.h
 * @brief The one place that chooses which window a program without a user interface renders to.
 *
 * No X server is needed. In order of preference, and by the names that the environment variable
 * PENUMBRA_WINDOW takes to force one of them:
 *
 * - `osmesa`: Mesa's software renderer, drawing into memory, where libOSMesa was found;
 * - `egl`: EGL without a surface or a display, as Mesa's llvmpipe offers it;
 * - `native`: VTK's own window, which on Linux needs an X server.
 */
#ifndef OffscreenWindow_h
#define OffscreenWindow_h

#include <string>

namespace penumbra
{
/**
 * From here on vtkRenderWindow::New() gives a window of the chosen kind. Calling it again changes
 * nothing.
 * @throw std::runtime_error where PENUMBRA_WINDOW names an unknown window, or one that does not
 * work here; the message says which do.
 */
void UseOffscreenWindows();

/**
 * The kind that UseOffscreenWindows() installs: osmesa, egl or native.
 * @throw std::runtime_error as UseOffscreenWindows() does.
 */
std::string OffscreenWindowKind();
}

#endif
