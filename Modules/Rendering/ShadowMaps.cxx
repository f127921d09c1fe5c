#include "ShadowMaps.h"

#include "DrawnScene.h"
#include "MatrixUniforms.h"
#include "ShaderSource.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkShaderProgram.h"

namespace penumbra
{

//------------------------------------------------------------------------------
bool ShadowMaps::Allocate(vtkOpenGLRenderWindow* window, const ShadowMapPlan& plan)
{
  this->Plan = plan;
  return this->Reserve(window,
    { { plan.Texels, plan.Texels, plan.GetNumberOfSlices() },
      { plan.Texels, ShadowMapPlan::SlicesPerLight }, 4, VTK_FLOAT, vtkTextureObject::Nearest },
    plan.Lights);
}

//------------------------------------------------------------------------------
std::string ShadowMaps::GetSource(const LightingRequirements& requirements) const
{
  return GetShadowMapSource(requirements);
}

//------------------------------------------------------------------------------
std::array<int, 2> ShadowMaps::GetSize() const
{
  return { this->Plan.Texels, this->Plan.Texels };
}

//------------------------------------------------------------------------------
int ShadowMaps::CountParts() const
{
  return 1;
}

//------------------------------------------------------------------------------
void ShadowMaps::FillPart(const Filling& filling, int slot, int)
{
  // Of the root of the optical depth over the largest: of a soft shadow's visibility a hundredth.
  constexpr double tolerance = 0.005;
  // Half of the texels take a wider tolerance, and look for the least one.
  constexpr double marches = 3.0;
  const ShadowCaster& caster = filling.Scene->ShadowCasters[slot];
  vtkShaderProgram* program = filling.Quad->Program;
  this->SetMapRays(filling, slot, 1.0 / this->Plan.Resolution);
  SetUniform(program, "scene_mapFirstHit", caster.FirstHit ? caster.Enough : -1.0);
  SetUniform(program, "scene_mapTolerance", tolerance);
  this->Attach(ShadowMapPlan::SlicesPerLight * slot, ShadowMapPlan::SlicesPerLight);
  this->Draw(filling, marches);
}

//------------------------------------------------------------------------------
void ShadowMaps::SetUniforms(vtkShaderProgram* program, const DrawnScene&)
{
  SetSampler(program, "scene_shadowMaps", this->Texture);
}

}
