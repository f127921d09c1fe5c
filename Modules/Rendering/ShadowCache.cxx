#include "ShadowCache.h"

#include "DrawnScene.h"
#include "MatrixUniforms.h"
#include "OpenGLEnumerants.h"
#include "TextureSampling.h"
#include "VolumeTextures.h"

#include "vtkAbstractArray.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <chrono>

namespace penumbra
{
namespace
{
// Fetches of textures that a ray through the whole box takes.
double CountFetches(const DrawnScene& scene)
{
  constexpr double fetchesOfMatter = 2.0;
  constexpr double fetchesOfGradient = 7.0;
  const double steps = scene.Placement.GetDiagonal() / scene.Plan.ShadowSampleDistance + 1.0;
  return steps *
    (scene.Requirements.GradientOpacity ? fetchesOfMatter + fetchesOfGradient : fetchesOfMatter);
}

// Rows that one draw may compute, so that it stays short on a slow graphics card: a tenth of a
// second where it fetches 5e8 texels a second.
int CountRowsPerDraw(int width, double fetches)
{
  constexpr double fetchesPerDraw = 5e7;
  return static_cast<int>(std::clamp(fetchesPerDraw / (width * fetches), 1.0, 65536.0));
}
}

//------------------------------------------------------------------------------
float GetLargestDepth(const ShadowCaster& caster)
{
  constexpr float darkestDepth = 6.24f;
  constexpr float thinnestShadow = 1e-6f;
  return caster.Hard ? 2.0f * std::max(caster.Enough, thinnestShadow) : darkestDepth;
}

//------------------------------------------------------------------------------
bool ShadowCache::TextureLayout::HasTextureOf(const TextureLayout& other) const
{
  return this->Texels == other.Texels && this->Components == other.Components &&
    this->ScalarType == other.ScalarType && this->Filter == other.Filter;
}

//------------------------------------------------------------------------------
bool ShadowCache::Reserve(vtkOpenGLRenderWindow* window, const TextureLayout& layout, int lights)
{
  const bool stays = this->Texture->GetHandle() && layout.HasTextureOf(this->Layout);
  if (!stays)
  {
    this->Release(window);
  }
  if (layout.Block != this->Layout.Block)
  {
    this->Held.clear();
    this->Begun.reset();
  }
  this->Layout = layout;
  this->Held.resize(lights);
  return stays || lights == 0 || this->Create(window);
}

//------------------------------------------------------------------------------
bool ShadowCache::Create(vtkOpenGLRenderWindow* window)
{
  const TextureLayout& layout = this->Layout;
  const auto& texels = layout.Texels;
  ResetTexture(this->Texture, window, layout.Filter);
  this->Framebuffer->SetContext(window);
  this->Bytes = static_cast<std::size_t>(texels[0]) * static_cast<std::size_t>(texels[1]) *
    static_cast<std::size_t>(texels[2]) *
    static_cast<std::size_t>(
      layout.Components * vtkAbstractArray::GetDataTypeSize(layout.ScalarType));
  return this->Texture->Create3DFromRaw(
    texels[0], texels[1], texels[2], layout.Components, layout.ScalarType, nullptr);
}

//------------------------------------------------------------------------------
bool ShadowCache::Update(vtkOpenGLRenderWindow* window, const DrawnScene& scene,
  const VolumeTextures& textures, double seconds)
{
  if (scene.Matter != this->Matter)
  {
    this->Begun.reset();
    std::fill(this->Held.begin(), this->Held.end(), std::nullopt);
    this->Matter = scene.Matter;
  }
  std::vector<int> changed;
  for (int slot = 0; slot < static_cast<int>(this->Held.size()); ++slot)
  {
    if (this->Held[slot] != scene.ShadowCasters[slot])
    {
      changed.push_back(slot);
    }
  }
  if (changed.empty())
  {
    this->Begun.reset();
    return true;
  }
  const double secondsBefore = this->Begun ? this->UpdateSeconds : 0.0;
  const auto before = std::chrono::steady_clock::now();
  if (!this->Fill(window, scene, textures, changed, seconds))
  {
    return false;
  }
  window->WaitForCompletion();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - before;
  this->UpdateSeconds = secondsBefore + passed.count();
  return true;
}

//------------------------------------------------------------------------------
bool ShadowCache::Fill(vtkOpenGLRenderWindow* window, const DrawnScene& scene,
  const VolumeTextures& textures, const std::vector<int>& slots, double seconds)
{
  // The window's shader cache keeps the program; a quad that is kept would outlive it.
  const std::string source = this->GetSource(scene.Requirements);
  vtkOpenGLQuadHelper quad(window, nullptr, source.c_str(), nullptr);
  if (!quad.Program)
  {
    return false;
  }
  scene.SetUniforms(quad.Program);
  textures.SetUniforms(quad.Program, scene.Placement, scene.UnitDistance);

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport savedViewport(state);
  vtkOpenGLState::ScopedglScissor savedScissor(state);
  vtkOpenGLState::ScopedglColorMask savedColorMask(state);
  vtkOpenGLState::ScopedglDepthMask savedDepthMask(state);
  vtkOpenGLState::ScopedglEnableDisable savedBlend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable savedDepthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable savedScissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable savedCulling(state, GL_CULL_FACE);
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  state->vtkglViewport(0, 0, this->GetSize()[0], this->GetSize()[1]);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_SCISSOR_TEST);
  this->FillLights({ window, &quad, &scene }, slots, seconds);
  this->Attach(0, 0);
  state->PopFramebufferBindings();
  return true;
}

//------------------------------------------------------------------------------
void ShadowCache::FillLights(const Filling& filling, const std::vector<int>& slots, double seconds)
{
  const auto start = std::chrono::steady_clock::now();
  const auto isOver = [&]
  {
    if (seconds <= 0.0)
    {
      return false;
    }
    filling.Window->WaitForCompletion();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() >
      seconds;
  };
  for (const int slot : slots)
  {
    const ShadowCaster& caster = filling.Scene->ShadowCasters[slot];
    const bool goesOn = this->Begun && this->Begun->Slot == slot && this->Begun->Caster == caster;
    const int parts = this->CountParts();
    this->Held[slot].reset();
    for (int part = goesOn ? this->Begun->NextPart : 0; part < parts; ++part)
    {
      this->FillPart(filling, slot, part);
      if (part + 1 < parts && isOver())
      {
        this->Begun = { slot, caster, part + 1 };
        return;
      }
    }
    this->Begun.reset();
    this->Held[slot] = caster;
    ++this->NumberOfUpdates;
  }
}

//------------------------------------------------------------------------------
// VTK takes another slice of a texture that is attached for the same one.
void ShadowCache::Attach(int firstSlice, int slices, vtkTextureObject* beside)
{
  for (int i = 0; i < this->Attached; ++i)
  {
    this->Framebuffer->RemoveColorAttachment(i);
  }
  for (int i = 0; i < slices; ++i)
  {
    this->Framebuffer->AddColorAttachment(i, this->Texture, firstSlice + i);
  }
  this->Attached = slices;
  if (beside)
  {
    this->Framebuffer->AddColorAttachment(this->Attached++, beside);
  }
  if (this->Attached > 0)
  {
    this->Framebuffer->ActivateDrawBuffers(this->Attached);
  }
}

//------------------------------------------------------------------------------
void ShadowCache::SetLeastStep(const Filling& filling, double spacings)
{
  const double step = std::max(
    filling.Scene->Plan.ShadowSampleDistance, spacings * filling.Scene->Placement.SmallestSpacing);
  filling.Quad->Program->SetUniformf("scene_shadowSampleDistance", static_cast<float>(step));
}

//------------------------------------------------------------------------------
void ShadowCache::SetMapRays(const Filling& filling, int slot, double spacings)
{
  const ShadowCaster& caster = filling.Scene->ShadowCasters[slot];
  const LightSpace& space = filling.Scene->LightSpaces[slot];
  vtkShaderProgram* program = filling.Quad->Program;
  SetUniform(program, "scene_lightToTexture", space.LightToTexture);
  program->SetUniformi("scene_mapProjection", static_cast<int>(space.Projection));
  SetUniform(program, "scene_mapExtent", space.Extent);
  SetUniform(program, "scene_mapLargestDepth", GetLargestDepth(caster));
  const bool sharp = caster.Hard || filling.Scene->Requirements.PreIntegrated;
  SetLeastStep(filling, sharp ? 0.0 : spacings);
}

//------------------------------------------------------------------------------
void ShadowCache::Draw(const Filling& filling, double rays)
{
  const auto [width, height] = this->GetSize();
  const int rows = CountRowsPerDraw(width, rays * CountFetches(*filling.Scene));
  for (int row = 0; row < height; row += rows)
  {
    filling.Window->GetState()->vtkglScissor(0, row, width, std::min(rows, height - row));
    filling.Quad->Render();
  }
}

//------------------------------------------------------------------------------
void ShadowCache::Activate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Activate();
  }
}

//------------------------------------------------------------------------------
void ShadowCache::Deactivate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void ShadowCache::Release(vtkOpenGLRenderWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Attached = 0;
  this->Held.clear();
  this->Begun.reset();
}

}
