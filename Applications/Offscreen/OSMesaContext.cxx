#include "OffscreenContext.h"

#include <GL/osmesa.h>

#include <array>
#include <stdexcept>

namespace penumbra
{
namespace
{
class OSMesaContext : public OffscreenContext
{
public:
  OSMesaContext()
  {
    const int attributes[] = { OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24,
      OSMESA_STENCIL_BITS, 8, OSMESA_PROFILE, OSMESA_CORE_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION, 3,
      OSMESA_CONTEXT_MINOR_VERSION, 2, 0 };
    this->Context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!this->Context)
    {
      throw std::runtime_error("libOSMesa gives no OpenGL 3.2 context");
    }
  }

  ~OSMesaContext() override
  {
    if (this->IsCurrent())
    {
      OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    }
    OSMesaDestroyContext(this->Context);
  }

  bool MakeCurrent() override
  {
    return OSMesaMakeCurrent(this->Context, this->Pixel.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE;
  }

  bool IsCurrent() const override { return OSMesaGetCurrentContext() == this->Context; }

  Function FindFunction(const char* name) const override { return OSMesaGetProcAddress(name); }

private:
  ::OSMesaContext Context = nullptr;
  // OSMesa insists on a framebuffer in memory; nothing is drawn into it.
  std::array<unsigned char, 4> Pixel = {};
};
}

std::unique_ptr<OffscreenContext> MakeOSMesaContext()
{
  return std::make_unique<OSMesaContext>();
}
}
