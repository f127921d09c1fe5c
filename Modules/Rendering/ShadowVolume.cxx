#include "ShadowVolume.h"

#include "DrawnScene.h"
#include "MatrixUniforms.h"
#include "ShaderSource.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace penumbra
{

//------------------------------------------------------------------------------
bool ShadowVolume::Allocate(vtkOpenGLRenderWindow* window, const ShadowVolumePlan& plan)
{
  this->Plan = plan;
  return this->Reserve(window,
    { { plan.Texels[0], plan.Texels[1], plan.GetNumberOfSlices() },
      { plan.Texels[0], plan.Texels[2] }, plan.Components, VTK_UNSIGNED_CHAR,
      vtkTextureObject::Linear },
    plan.Lights);
}

//------------------------------------------------------------------------------
std::string ShadowVolume::GetSource(const LightingRequirements& requirements) const
{
  return GetShadowVolumeSource(requirements);
}

//------------------------------------------------------------------------------
std::array<int, 2> ShadowVolume::GetSize() const
{
  return { this->Plan.Texels[0], this->Plan.Texels[1] };
}

//------------------------------------------------------------------------------
int ShadowVolume::CountParts() const
{
  return this->Plan.Texels[2];
}

//------------------------------------------------------------------------------
void ShadowVolume::FillPart(const Filling& filling, int slot, int part)
{
  constexpr int lightsPerBlock = 4;
  const auto& texels = this->Plan.Texels;
  const ShadowCaster& caster = filling.Scene->ShadowCasters[slot];
  const float ray[2] = { caster.Begin, GetLargestDepth(caster) };
  vtkShaderProgram* program = filling.Quad->Program;
  SetUniform(
    program, "scene_shadowTexels", Vector3{ 1.0 * texels[0], 1.0 * texels[1], 1.0 * texels[2] });
  program->SetUniform4f("scene_shadowLight", caster.Place.data());
  program->SetUniform2f("scene_shadowRay", ray);
  // What lies between texels is interpolated: finer steps would not tell more.
  this->SetLeastStep(filling, 1.0 / this->Plan.Resolution);
  const int component = slot % lightsPerBlock;
  filling.Window->GetState()->vtkglColorMask(
    component == 0, component == 1, component == 2, component == 3);
  this->Attach(part + slot / lightsPerBlock * texels[2], 1);
  program->SetUniformf("scene_shadowSlice", static_cast<float>(part));
  this->Draw(filling, 1.0);
}

//------------------------------------------------------------------------------
void ShadowVolume::SetUniforms(vtkShaderProgram* program, const DrawnScene& scene)
{
  SetSampler(program, "scene_shadowVolume", this->Texture);
  Vector3 scale;
  Vector3 offset;
  const VolumePlacement& placement = scene.Placement;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int texels = this->Plan.Texels[axis];
    const int blocks = axis == 2 ? this->Plan.Blocks : 1;
    const double length = placement.BoxHigh[axis] - placement.BoxLow[axis];
    scale[axis] = length > 0.0 ? (texels - 1.0) / (texels * blocks * length) : 0.0;
    offset[axis] = 0.5 / (texels * blocks) - placement.BoxLow[axis] * scale[axis];
  }
  SetUniform(program, "scene_shadowVolumeScale", scale);
  SetUniform(program, "scene_shadowVolumeOffset", offset);
}

}
