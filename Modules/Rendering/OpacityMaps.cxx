#include "OpacityMaps.h"

#include "DrawnScene.h"
#include "MatrixUniforms.h"
#include "ShaderSource.h"
#include "TextureSampling.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace penumbra
{
//------------------------------------------------------------------------------
bool OpacityMaps::Allocate(vtkOpenGLRenderWindow* window, const OpacityMapPlan& plan)
{
  this->Plan = plan;
  return this->Reserve(window,
           { { plan.Texels, plan.Texels, plan.GetNumberOfSlices() }, plan.Layers, 2,
             VTK_UNSIGNED_CHAR, vtkTextureObject::Linear },
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
    if (!depth->Create2D(this->Plan.Texels, this->Plan.Texels, 1, VTK_FLOAT, false))
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
  const float scaleAndOffset[2] = { static_cast<float>((texels - 2.0) / texels),
    static_cast<float>(1.0 / texels) };
  if (program->IsUniformUsed("scene_opacityMapTexels"))
  {
    program->SetUniform2f("scene_opacityMapTexels", scaleAndOffset);
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
