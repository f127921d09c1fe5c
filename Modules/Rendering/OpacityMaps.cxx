#include "OpacityMaps.h"

#include "DrawnScene.h"
#include "MatrixUniforms.h"
#include "ShaderSource.h"
#include "TextureSampling.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace penumbra
{

//------------------------------------------------------------------------------
void OpacityMaps::ShareTexture(OpacityMapPlan& plan, std::size_t largestBytes) const
{
  // Maps that are as fine lie as they would in a texture of their own, to the bit.
  constexpr double finer = 1.5;
  constexpr std::size_t mostTimesTheBytes = 64;
  const std::size_t bytes = this->GetBytes();
  if (bytes > 0 && bytes <= std::min(largestBytes, mostTimesTheBytes * plan.GetBytes()) &&
    this->Plan.TextureTexels >= finer * plan.Texels &&
    this->Plan.TextureSlices >= plan.GetNumberOfSlices())
  {
    plan.TextureTexels = this->Plan.TextureTexels;
    plan.TextureSlices = this->Plan.TextureSlices;
  }
}

//------------------------------------------------------------------------------
bool OpacityMaps::Allocate(vtkOpenGLRenderWindow* window, const OpacityMapPlan& plan)
{
  this->Plan = plan;
  return this->Reserve(window,
           { { plan.TextureTexels, plan.TextureTexels, plan.TextureSlices },
             { plan.Texels, plan.Layers }, 2, VTK_UNSIGNED_CHAR, vtkTextureObject::Linear },
           plan.Lights) &&
    this->ReserveDepths(window);
}

//------------------------------------------------------------------------------
bool OpacityMaps::ReserveDepths(vtkOpenGLRenderWindow* window)
{
  for (const auto& depth : this->Depths)
  {
    if (this->Plan.Lights == 0 || depth->GetHandle())
    {
      continue;
    }
    ResetTexture(depth, window, vtkTextureObject::Nearest);
    if (!depth->Create2D(this->Plan.TextureTexels, this->Plan.TextureTexels, 1, VTK_FLOAT, false))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::string OpacityMaps::GetSource(const LightingRequirements& requirements) const
{
  return GetOpacityMapSource(requirements);
}

//------------------------------------------------------------------------------
std::array<int, 2> OpacityMaps::GetSize() const
{
  return { this->Plan.Texels, this->Plan.Texels };
}

//------------------------------------------------------------------------------
int OpacityMaps::CountParts() const
{
  return (this->Plan.Layers + OpacityMapPlan::LayersPerDraw - 1) / OpacityMapPlan::LayersPerDraw;
}

//------------------------------------------------------------------------------
void OpacityMaps::FillPart(const Filling& filling, int slot, int part)
{
  constexpr int perDraw = OpacityMapPlan::LayersPerDraw;
  const LightSpace& space = filling.Scene->LightSpaces[slot];
  const double spacing = this->Plan.GetSpacing(space);
  vtkShaderProgram* program = filling.Quad->Program;
  this->SetMapRays(filling, slot, spacing / filling.Scene->Placement.SmallestSpacing);
  SetUniform(program, "scene_mapTexels", this->Plan.Texels);
  SetUniform(program, "scene_mapSpacing", spacing);
  const int layer = part * perDraw;
  vtkTextureObject* before = this->Depths[part % 2];
  vtkTextureObject* after = this->Depths[1 - part % 2];
  before->Activate();
  SetSampler(program, "scene_depthBefore", before);
  program->SetUniformi("scene_mapLayer", layer);
  SetUniform(program, "scene_mapFirst", space.Nearest + (layer - 1) * spacing);
  this->Attach(this->Plan.Layers * slot + layer, perDraw, after);
  this->Draw(filling, 1.0 * perDraw / this->Plan.Layers);
  before->Deactivate();
}

//------------------------------------------------------------------------------
void OpacityMaps::SetUniforms(vtkShaderProgram* program, const DrawnScene&)
{
  SetSampler(program, "scene_opacityMaps", this->Texture);
  const double texels = this->Plan.Texels;
  const double whole = this->Plan.TextureTexels;
  const float placing[3] = { static_cast<float>((texels - 2.0) / whole),
    static_cast<float>(1.0 / whole), static_cast<float>((texels - 0.5) / whole) };
  if (program->IsUniformUsed("scene_opacityMapTexels"))
  {
    program->SetUniform3f("scene_opacityMapTexels", placing);
  }
}

//------------------------------------------------------------------------------
void OpacityMaps::Release(vtkOpenGLRenderWindow* window)
{
  ShadowCache::Release(window);
  for (const auto& depth : this->Depths)
  {
    depth->ReleaseGraphicsResources(window);
  }
}

}
