#include "VolumeDrawing.h"

#include "MatrixUniforms.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{

//------------------------------------------------------------------------------
VolumeDrawing::VolumeDrawing()
{
  this->Pass->SetUniforms = [this](vtkShaderProgram* program) { this->SetUniforms(program); };
}

//------------------------------------------------------------------------------
void VolumeDrawing::SetUniforms(vtkShaderProgram* program)
{
  const auto& viewport = this->Current.Viewport;
  const float origin[2] = { static_cast<float>(viewport.X), static_cast<float>(viewport.Y) };
  const float scale[2] = { 2.0f / static_cast<float>(viewport.Width),
    2.0f / static_cast<float>(viewport.Height) };
  program->SetUniform2f("scene_viewportOrigin", origin);
  program->SetUniform2f("scene_viewportScale", scale);
  program->SetUniformi("scene_firstStep", this->Current.FirstStep);
  program->SetUniformi("scene_lastStep", this->Current.LastStep);
  SetUniform(program, "scene_boxToClip", this->Box.GetBoxToClip(this->Scene->Rays.TextureToClip));
  if (this->Scene->Requirements.EmptySpaceSkipping)
  {
    this->SetTiles(program);
  }
  this->Scene->SetUniforms(program);
  this->Textures.SetUniforms(program, this->Scene->Placement, this->Scene->UnitDistance);
  this->Environment.SetUniforms(program);
  for (ShadowCache* cache : this->GetCaches())
  {
    cache->SetUniforms(program, *this->Scene);
  }
  if (this->Gathering)
  {
    program->SetUniformi("scene_accumulated", this->Accumulation.GetPreviousTextureUnit());
    this->Accumulation.PreparePrimitives(this->Window);
  }
}

//------------------------------------------------------------------------------
void VolumeDrawing::SetTiles(vtkShaderProgram* program)
{
  const auto& viewport = this->Current.Viewport;
  const ViewTiles tiles =
    this->Textures.FindViewTiles(this->Scene->Rays.TextureToClip, viewport.Width, viewport.Height);
  const int count = static_cast<int>(tiles.Rectangles.size());
  program->SetUniformi("scene_tiles", tiles.Everywhere ? -1 : count);
  if (count > 0)
  {
    program->SetUniform4fv(
      "scene_tile", count, reinterpret_cast<const float(*)[4]>(tiles.Rectangles.data()));
  }
}

//------------------------------------------------------------------------------
std::array<ShadowCache*, 3> VolumeDrawing::GetCaches()
{
  return { &this->VolumeOfShadows, &this->MapsOfShadows, &this->LayersOfShadows };
}

//------------------------------------------------------------------------------
std::array<const ShadowCache*, 3> VolumeDrawing::GetCaches() const
{
  return { &this->VolumeOfShadows, &this->MapsOfShadows, &this->LayersOfShadows };
}

//------------------------------------------------------------------------------
bool VolumeDrawing::AreShadowsComplete() const
{
  const auto caches = this->GetCaches();
  return std::all_of(
    caches.begin(), caches.end(), [](const ShadowCache* cache) { return cache->IsComplete(); });
}

//------------------------------------------------------------------------------
ShadowReport VolumeDrawing::GetShadowReport() const
{
  ShadowReport report;
  for (const ShadowCache* cache : this->GetCaches())
  {
    report.Bytes += cache->GetBytes();
    report.Updates += cache->GetNumberOfUpdates();
    // One of them at most is in use.
    report.UpdateSeconds = cache->GetBytes() > 0 ? cache->GetUpdateSeconds() : report.UpdateSeconds;
  }
  return report;
}

//------------------------------------------------------------------------------
bool VolumeDrawing::UpdateShadows()
{
  const auto caches = this->GetCaches();
  return std::all_of(caches.begin(), caches.end(),
    [&](ShadowCache* cache)
    { return cache->Update(this->Window, *this->Scene, this->Textures, this->ShadowSeconds); });
}

//------------------------------------------------------------------------------
void VolumeDrawing::DrawPart(vtkRenderer* renderer, const Part& part)
{
  this->Current = part;
  this->Box.Draw(renderer, this->Pass);
}

//------------------------------------------------------------------------------
bool VolumeDrawing::Gather(
  vtkRenderer* renderer, const AccumulationBuffer::Viewport& viewport, double imageSampleDistance)
{
  const auto reduced = [&](int pixels)
  { return std::max(1, static_cast<int>(std::lround(pixels / imageSampleDistance))); };
  const AccumulationBuffer::Viewport gathered = { 0, 0, reduced(viewport.Width),
    reduced(viewport.Height) };
  const MarchingPlan& plan = this->Scene->Plan;
  return this->Accumulation.Gather(this->Window, viewport, gathered.Width, gathered.Height,
    plan.Draws,
    [&](int draw)
    {
      const int first = draw * plan.StepsPerDraw;
      this->DrawPart(renderer, { gathered, first, first + plan.StepsPerDraw });
    });
}

//------------------------------------------------------------------------------
std::string VolumeDrawing::DrawWith(vtkRenderer* renderer, const DrawnScene& scene,
  const std::function<bool(const AccumulationBuffer::Viewport&)>& draw)
{
  const char* const noProgram = "The volume is not drawn: its shader program could not be built.";
  this->Scene = &scene;
  this->Window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->Box.Place(scene.Placement);
  this->Pass->ExpectDraw();
  this->Textures.Activate();
  const bool updated = this->UpdateShadows();
  if (!updated || !this->AreShadowsComplete())
  {
    this->Textures.Deactivate();
    this->Scene = nullptr;
    return updated ? "" : noProgram;
  }
  this->Environment.Activate(this->Window);
  for (ShadowCache* cache : this->GetCaches())
  {
    cache->Activate();
  }
  AccumulationBuffer::Viewport viewport;
  renderer->GetTiledSizeAndOrigin(&viewport.Width, &viewport.Height, &viewport.X, &viewport.Y);
  const bool drawn = draw(viewport);
  this->Textures.Deactivate();
  this->Environment.Deactivate();
  for (ShadowCache* cache : this->GetCaches())
  {
    cache->Deactivate();
  }
  this->Scene = nullptr;
  if (!drawn)
  {
    return "The volume is not drawn: the picture is made in parts, which needs a float framebuffer "
           "that the graphics card does not have.";
  }
  return this->Pass->GetProgramFailed() ? noProgram : "";
}

//------------------------------------------------------------------------------
std::string VolumeDrawing::Draw(
  vtkRenderer* renderer, const DrawnScene& scene, double imageSampleDistance)
{
  this->Gathering = scene.Plan.Draws > 1 || imageSampleDistance != 1.0;
  this->Pass->Select(scene.Requirements, this->Gathering);
  return this->DrawWith(renderer, scene,
    [&](const AccumulationBuffer::Viewport& viewport)
    {
      if (!this->Gathering)
      {
        this->DrawPart(renderer, { viewport, 0, scene.Plan.Steps });
        return true;
      }
      if (!this->Gather(renderer, viewport, imageSampleDistance))
      {
        return false;
      }
      this->Accumulation.Composite(this->Window, viewport);
      return true;
    });
}

//------------------------------------------------------------------------------
std::string VolumeDrawing::Count(
  vtkRenderer* renderer, const DrawnScene& scene, double imageSampleDistance, RayCounts& counts)
{
  LightingRequirements needs = scene.Requirements;
  needs.Counting = true;
  this->Gathering = true;
  this->Pass->Select(needs, this->Gathering);
  return this->DrawWith(renderer, scene,
    [&](const AccumulationBuffer::Viewport& viewport)
    {
      if (!this->Gather(renderer, viewport, imageSampleDistance))
      {
        return false;
      }
      const auto [samples, shaded, shadowSteps] = this->Accumulation.Sum();
      counts = { samples, shaded, shadowSteps };
      return true;
    });
}

//------------------------------------------------------------------------------
void VolumeDrawing::Release(vtkOpenGLRenderWindow* window)
{
  this->Box.Release(window);
  this->Textures.Release(window);
  this->Environment.Release(window);
  for (ShadowCache* cache : this->GetCaches())
  {
    cache->Release(window);
  }
  this->Accumulation.Release(window);
}

}
