/**
 * @file OffscreenContext.h
 * @brief An OpenGL 3.2 core context without a window system.
 *
 * vtkOffscreenWindow draws into VTK's own framebuffer objects, so that a context needs no
 * framebuffer of the picture's size, and resizing a window does not concern it.
 */
#ifndef OffscreenContext_h
#define OffscreenContext_h

#include <memory>

namespace penumbra
{
class OffscreenContext
{
public:
  using Function = void (*)();

  OffscreenContext() = default;
  virtual ~OffscreenContext() = default;
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  /// Makes this the calling thread's context; false where the driver refuses.
  virtual bool MakeCurrent() = 0;
  virtual bool IsCurrent() const = 0;

  /// The OpenGL function of that name, null where there is none.
  virtual Function FindFunction(const char* name) const = 0;
};

using OffscreenContextMaker = std::unique_ptr<OffscreenContext> (*)();

/// @throw std::runtime_error with the reason where no context can be made.
std::unique_ptr<OffscreenContext> MakeOSMesaContext();
std::unique_ptr<OffscreenContext> MakeEGLContext();
}

#endif
