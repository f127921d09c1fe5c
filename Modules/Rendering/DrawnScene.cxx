#include "DrawnScene.h"

#include "MatrixUniforms.h"

#include "vtkShaderProgram.h"

namespace penumbra
{
namespace
{
Matrix3 GetLinearPart(const Matrix4& m)
{
  return { m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10] };
}
}

//------------------------------------------------------------------------------
void DrawnScene::SetUniforms(vtkShaderProgram* program) const
{
  this->SetGeometryUniforms(program);
  this->SetRayUniforms(program);
  this->SetVisibilityUniforms(program);
  this->Lights.Set(program);
  this->Material.Set(program);
}

//------------------------------------------------------------------------------
void DrawnScene::SetGeometryUniforms(vtkShaderProgram* program) const
{
  Vector3 voxel;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int count = this->Placement.Dimensions[axis];
    voxel[axis] = count > 1 ? 1.0 / count : 0.0;
  }
  SetUniform(program, "scene_voxel", voxel);
  SetUniform(program, "scene_textureToOwn", GetLinearPart(this->Placement.TextureToOwn));
  SetUniform(program, "scene_textureToWorld", GetLinearPart(this->Placement.TextureToWorld));
  SetUniform(program, "scene_gradientToWorld", this->Placement.GetGradientToWorld());
  SetUniform(program, "scene_sampleDistance", this->Plan.SampleDistance);
  SetUniform(program, "scene_shadowSampleDistance", this->Plan.ShadowSampleDistance);
}

//------------------------------------------------------------------------------
void DrawnScene::SetRayUniforms(vtkShaderProgram* program) const
{
  SetUniform(program, "scene_opaqueEnough", this->OpaqueEnough);
  SetUniform(program, "scene_rayBase", this->Rays.Base);
  SetUniform(program, "scene_rayDirection", this->Rays.Direction);
  SetUniform(program, "scene_rayEye", this->Rays.EyeParameter);
  SetUniform(program, "scene_clipDepth", this->Rays.ClipDepth);
  SetUniform(program, "scene_clipW", this->Rays.ClipW);
}

//------------------------------------------------------------------------------
void DrawnScene::SetVisibilityUniforms(vtkShaderProgram* program) const
{
  SetUniform(program, "scene_boxLow", this->Placement.BoxLow);
  SetUniform(program, "scene_boxHigh", this->Placement.BoxHigh);
  SetUniform(program, "scene_croppingLow", this->CroppingLow);
  SetUniform(program, "scene_croppingHigh", this->CroppingHigh);
  program->SetUniformi("scene_croppingFlags", this->CroppingFlags);
  if (!this->ClippingPlanes.empty())
  {
    std::vector<float> planes;
    for (const auto& plane : this->ClippingPlanes)
    {
      planes.insert(planes.end(), plane.begin(), plane.end());
    }
    program->SetUniform4fv(
      "scene_clippingPlanes", static_cast<int>(this->ClippingPlanes.size()), planes.data());
  }
}

}
