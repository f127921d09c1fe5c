#include "GradientOpacityTexture.h"

#include "EmptySpace.h"
#include "MatrixUniforms.h"
#include "ScalarRange.h"
#include "TextureSampling.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr int LargestTableSize = 8192;

// In scalar units per mean voxel: the largest difference a voxel along each axis, and half as much
// again for what float rounding adds.
double BoundGradient(const ScalarRange& range, const double spacing[3], GradientEstimator estimator)
{
  const bool oneSided = estimator == GradientEstimator::ForwardDifferences ||
    estimator == GradientEstimator::BackwardDifferences;
  const double mean = (std::abs(spacing[0]) + std::abs(spacing[1]) + std::abs(spacing[2])) / 3.0;
  const double perVoxel = (oneSided ? 1.5 : 0.75) * (range.High - range.Low);
  return perVoxel * std::hypot(mean / spacing[0], mean / spacing[1], mean / spacing[2]);
}
}

//------------------------------------------------------------------------------
void GradientOpacityTexture::Load(vtkOpenGLRenderWindow* window, vtkVolumeProperty* property,
  const ScalarRange& range, const double spacing[3], GradientEstimator estimator)
{
  if (!property->HasGradientOpacity(0) || property->GetDisableGradientOpacity(0))
  {
    this->Texture->ReleaseGraphicsResources(window);
    return;
  }
  this->BoundPerScalar = BoundGradient({ 0.0, 1.0 }, spacing, estimator);
  this->Table = MakeGradientOpacityTable(property->GetGradientOpacity(0),
    std::min(LargestTableSize, vtkTextureObject::GetMaximumTextureSize(window)),
    BoundGradient(range, spacing, estimator));
  ResetTexture(this->Texture, window, vtkTextureObject::Linear);
  this->Texture->Create1DFromRaw(static_cast<unsigned int>(this->Table.Opacity.size()), 1,
    VTK_FLOAT, this->Table.Opacity.data());
}

//------------------------------------------------------------------------------
void GradientOpacityTexture::Describe(BrickVisibility& visibility) const
{
  if (this->Texture->GetHandle())
  {
    visibility.LeastGradient = FindLeastVisibleGradient(this->Table);
    visibility.GradientBound = this->BoundPerScalar;
  }
}

//------------------------------------------------------------------------------
void GradientOpacityTexture::SetUniforms(
  vtkShaderProgram* program, const VolumePlacement& placement, double scalarUnit) const
{
  SetSampler(program, "scene_gradientOpacity", this->Texture);
  if (this->Table.Opacity.empty())
  {
    return;
  }
  const double range = this->Table.High - this->Table.Low;
  Matrix3 toTable = placement.GetGradientToMagnitude();
  for (double& element : toTable)
  {
    element *= scalarUnit / range;
  }
  SetUniform(program, "scene_gradientToTable", toTable);
  SetUniform(program, "scene_gradientTableOffset", -this->Table.Low / range);
}

//------------------------------------------------------------------------------
void GradientOpacityTexture::Release(vtkOpenGLRenderWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}

}
