#include "AccumulationBuffer.h"

#include "ShaderSource.h"
#include "TextureSampling.h"

#include "OpenGLEnumerants.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPixelBufferObject.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

namespace penumbra
{

//------------------------------------------------------------------------------
bool AccumulationBuffer::Resize(vtkOpenGLRenderWindow* window, int width, int height)
{
  for (auto& picture : this->Pictures)
  {
    if (picture->GetHandle() && static_cast<int>(picture->GetWidth()) == width &&
      static_cast<int>(picture->GetHeight()) == height)
    {
      continue;
    }
    ResetTexture(picture, window, vtkTextureObject::Linear);
    if (!picture->Create2D(width, height, 4, VTK_FLOAT, false))
    {
      return false;
    }
  }
  this->Framebuffer->SetContext(window);
  return true;
}

//------------------------------------------------------------------------------
void AccumulationBuffer::Clear(vtkOpenGLRenderWindow* window, int target)
{
  this->Framebuffer->RemoveColorAttachment(0);
  this->Framebuffer->AddColorAttachment(0, this->Pictures[target]);
  this->Framebuffer->ActivateDrawBuffer(0);
  window->GetState()->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  window->GetState()->vtkglClear(GL_COLOR_BUFFER_BIT);
}

//------------------------------------------------------------------------------
bool AccumulationBuffer::Gather(vtkOpenGLRenderWindow* window, const Viewport& viewport, int width,
  int height, int draws, const std::function<void(int)>& draw)
{
  if (!this->Resize(window, width, height))
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  {
    vtkOpenGLState::ScopedglViewport savedViewport(state);
    vtkOpenGLState::ScopedglScissor savedScissor(state);
    vtkOpenGLState::ScopedglEnableDisable savedScissorTest(state, GL_SCISSOR_TEST);
    vtkOpenGLState::ScopedglClearColor savedClearColor(state);
    vtkOpenGLState::ScopedglColorMask savedColorMask(state);
    vtkOpenGLState::ScopedglEnableDisable savedBlend(state, GL_BLEND);
    state->PushDrawFramebufferBinding();
    this->Framebuffer->Bind(vtkOpenGLFramebufferObject::GetDrawMode());
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (width == viewport.Width && height == viewport.Height)
    {
      // What is cut off in the window needs not be gathered.
      int box[4];
      state->vtkglGetIntegerv(GL_SCISSOR_BOX, box);
      state->vtkglScissor(box[0] - viewport.X, box[1] - viewport.Y, box[2], box[3]);
    }
    else
    {
      state->vtkglDisable(GL_SCISSOR_TEST);
    }
    this->Clear(window, 1);
    for (int i = 0; i < draws; ++i)
    {
      this->Clear(window, i % 2);
      this->Previous = this->Pictures[(i + 1) % 2];
      this->Previous->Activate();
      // The ray caster reads the depth of opaque geometry where the viewport is.
      state->vtkglViewport(viewport.X, viewport.Y, viewport.Width, viewport.Height);
      draw(i);
      this->Previous->Deactivate();
    }
    this->Framebuffer->RemoveColorAttachment(0);
    state->PopDrawFramebufferBinding();
  }
  this->Previous = nullptr;
  this->Gathered = this->Pictures[(draws - 1) % 2];
  return true;
}

//------------------------------------------------------------------------------
void AccumulationBuffer::PreparePrimitives(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_BLEND);
  state->vtkglViewport(0, 0, static_cast<int>(this->Previous->GetWidth()),
    static_cast<int>(this->Previous->GetHeight()));
}

//------------------------------------------------------------------------------
int AccumulationBuffer::GetPreviousTextureUnit()
{
  return this->Previous ? this->Previous->GetTextureUnit() : 0;
}

//------------------------------------------------------------------------------
void AccumulationBuffer::Composite(vtkOpenGLRenderWindow* window, const Viewport& viewport)
{
  // The window's shader cache keeps the program; a quad that is kept would outlive it.
  vtkOpenGLQuadHelper quad(window, nullptr, GetCompositeShaderSource().c_str(), nullptr);
  if (!quad.Program)
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport savedViewport(state);
  vtkOpenGLState::ScopedglEnableDisable savedBlend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable savedDepthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable savedCulling(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglBlendFuncSeparate savedBlendFunction(state);
  vtkOpenGLState::ScopedglDepthMask savedDepthMask(state);
  state->vtkglViewport(viewport.X, viewport.Y, viewport.Width, viewport.Height);
  state->vtkglEnable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglDepthMask(GL_FALSE);
  this->Gathered->Activate();
  quad.Program->SetUniformi("scene_accumulated", this->Gathered->GetTextureUnit());
  quad.Render();
  this->Gathered->Deactivate();
}

//------------------------------------------------------------------------------
Vector3 AccumulationBuffer::Sum()
{
  constexpr int channels = 4;
  unsigned int size[2] = { this->Gathered->GetWidth(), this->Gathered->GetHeight() };
  std::vector<float> pixels(static_cast<std::size_t>(channels) * size[0] * size[1]);
  vtkIdType increments[2] = { 0, 0 };
  const auto download = vtkSmartPointer<vtkPixelBufferObject>::Take(this->Gathered->Download());
  download->Download2D(VTK_FLOAT, pixels.data(), size, channels, increments);
  Vector3 sum{};
  for (std::size_t value = 0; value < pixels.size(); value += channels)
  {
    for (std::size_t channel = 0; channel < sum.size(); ++channel)
    {
      sum[channel] += pixels[value + channel];
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
void AccumulationBuffer::Release(vtkOpenGLRenderWindow* window)
{
  for (auto& picture : this->Pictures)
  {
    picture->ReleaseGraphicsResources(window);
  }
  this->Framebuffer->ReleaseGraphicsResources(window);
}

}
