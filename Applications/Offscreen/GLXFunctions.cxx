#include "GLXFunctions.h"

#include "OffscreenContext.h"

#include <dlfcn.h>

#include <cstring>

namespace
{
using Function = penumbra::OffscreenContext::Function;

const penumbra::OffscreenContext* answering = nullptr;

template <typename Signature>
Signature* FromLibGLX(const char* name)
{
  return reinterpret_cast<Signature*>(dlsym(RTLD_NEXT, name));
}

// GLEW only looks whether there is a display, and hands it to the functions below.
void* StandInDisplay()
{
  static char display;
  return &display;
}
}

namespace penumbra
{
OpenGLFunctionsFrom::OpenGLFunctionsFrom(const OffscreenContext& context)
{
  answering = &context;
}

OpenGLFunctionsFrom::~OpenGLFunctionsFrom()
{
  answering = nullptr;
}
}

// Their types are those of GL/glx.h, whose X11 headers this file does without.
extern "C"
{
  Function glXGetProcAddressARB(const unsigned char* name)
  {
    if (!answering)
    {
      const auto original = FromLibGLX<Function(const unsigned char*)>("glXGetProcAddressARB");
      return original ? original(name) : nullptr;
    }
    const char* text = reinterpret_cast<const char*>(name);
    if (std::strcmp(text, "glXGetCurrentDisplay") == 0)
    {
      return reinterpret_cast<Function>(&StandInDisplay);
    }
    return std::strncmp(text, "glX", 3) == 0 ? nullptr : answering->FindFunction(text);
  }

  Function glXGetProcAddress(const unsigned char* name)
  {
    return glXGetProcAddressARB(name);
  }

  int glXQueryVersion(void* display, int* major, int* minor)
  {
    if (!answering)
    {
      const auto original = FromLibGLX<int(void*, int*, int*)>("glXQueryVersion");
      return original ? original(display, major, minor) : 0;
    }
    *major = 1;
    *minor = 2;
    return 1;
  }

  const char* glXGetClientString(void* display, int name)
  {
    if (!answering)
    {
      const auto original = FromLibGLX<const char*(void*, int)>("glXGetClientString");
      return original ? original(display, name) : nullptr;
    }
    return "";
  }
}
