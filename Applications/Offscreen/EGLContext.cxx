#include "OffscreenContext.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <sstream>
#include <stdexcept>

namespace penumbra
{
namespace
{
[[noreturn]] void Fail(const char* what)
{
  std::ostringstream message;
  message << what << " (EGL error 0x" << std::hex << eglGetError() << ")";
  throw std::runtime_error(message.str());
}

/// Displays are shared by all contexts of the process and stay open until it ends.
EGLDisplay SurfacelessDisplay()
{
  const auto getPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
    eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const EGLDisplay display = getPlatformDisplay
    ? getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
    : EGL_NO_DISPLAY;
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
  {
    Fail("no EGL driver offers rendering without a surface");
  }
  return display;
}

class EGLContextWithoutSurface : public OffscreenContext
{
public:
  EGLContextWithoutSurface()
    : Display(SurfacelessDisplay())
  {
    const EGLint wanted[] = { EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE };
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(this->Display, wanted, &config, 1, &count) || count < 1)
    {
      Fail("EGL offers no OpenGL");
    }
    const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2,
      EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
    eglBindAPI(EGL_OPENGL_API);
    this->Context = eglCreateContext(this->Display, config, EGL_NO_CONTEXT, attributes);
    if (this->Context == EGL_NO_CONTEXT)
    {
      Fail("EGL gives no OpenGL 3.2 context");
    }
  }

  ~EGLContextWithoutSurface() override
  {
    if (this->IsCurrent())
    {
      eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(this->Display, this->Context);
  }

  bool MakeCurrent() override
  {
    eglBindAPI(EGL_OPENGL_API);
    return eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, this->Context) == EGL_TRUE;
  }

  bool IsCurrent() const override { return eglGetCurrentContext() == this->Context; }

  Function FindFunction(const char* name) const override { return eglGetProcAddress(name); }

private:
  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLContext Context = EGL_NO_CONTEXT;
};
}

std::unique_ptr<OffscreenContext> MakeEGLContext()
{
  return std::make_unique<EGLContextWithoutSurface>();
}
}
