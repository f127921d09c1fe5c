#include "Medium.h"

#include "EmptyBricks.h"
#include "FunctionLookup.h"
#include "GradientVoxels.h"
#include "PiecewiseCurve.h"
#include "UsableScalars.h"
#include "VoxelGrid.h"
#include "VoxelMask.h"

#include "vtkDataArray.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace penumbra
{
namespace
{
// Gradients, and how much their magnitude leaves of the opacity.
struct GradientOpacity
{
  GradientVoxels Gradients;
  FunctionLookup Opacity;

  double GetValue(const VoxelGrid& grid, const VoxelCell& cell) const
  {
    const float* values = this->Gradients.Values.data();
    const double x = grid.Interpolate<3>(values, cell, 0);
    const double y = grid.Interpolate<3>(values, cell, 1);
    const double z = grid.Interpolate<3>(values, cell, 2);
    return this->Opacity.GetValue(std::sqrt(x * x + y * y + z * z));
  }
};

// Optical depth of one unit distance.
double GetUnitDepth(double opacity)
{
  constexpr double largestOpacity = 1.0 - 1.0 / 16777216.0; // 1 - 2^-24
  return opacity > 0.0 ? -std::log1p(-std::min(opacity, largestOpacity)) : 0.0;
}

std::optional<GradientOpacity> MakeGradientOpacity(
  const UsableScalars& scalars, const MediumDescription& description)
{
  vtkVolumeProperty* property = description.Property;
  if (!property->HasGradientOpacity(0) || property->GetDisableGradientOpacity(0))
  {
    return std::nullopt;
  }
  GradientVoxels gradients =
    ComputeGradientVoxels(scalars.Array, description.Frames, description.Estimator);
  const auto curve = std::make_shared<PiecewiseCurve>(property->GetGradientOpacity(0));
  const auto opacity = [curve](double magnitude)
  { return std::clamp(curve->GetValue(magnitude), 0.0, 1.0); };
  FunctionLookup lookup(opacity, 0.0, gradients.LargestMagnitude, curve->GetKnots());
  return GradientOpacity{ std::move(gradients), std::move(lookup) };
}

//------------------------------------------------------------------------------
template <typename Scalar>
class MediumOf : public Medium
{
public:
  MediumOf(const UsableScalars& scalars, const MediumDescription& description,
    const std::shared_ptr<PiecewiseCurve>& opacity)
    : Scalars(static_cast<const Scalar*>(scalars.Array->GetVoidPointer(0)))
    , Step(description.SampleDistance)
    , PerUnitDistance(1.0 / description.Property->GetScalarOpacityUnitDistance(0))
    , Grid(description.Frames.Dimensions,
        description.Property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION)
    , UnitDepth([opacity](double value) { return GetUnitDepth(opacity->GetValue(value)); },
        scalars.Low, scalars.High, opacity->GetKnots())
    , Bricks(scalars.Array, description.Frames.Dimensions,
        [opacity](double low, double high) { return opacity->IsZeroBetween(low, high); })
    , Gradient(MakeGradientOpacity(scalars, description))
  {
    if (description.Mask)
    {
      this->Mask.emplace(description.Mask, description.Frames.Dimensions);
    }
  }

  double ComputeOpticalDepth(const ShadowRay& ray, double largestDepth) const override
  {
    const double length = ray.End - ray.Begin;
    const double wholeSteps = std::floor(length / this->Step);
    double depth = 0.0;
    double step = 0.0;
    while (step < wholeSteps && depth <= largestDepth)
    {
      const double middle = ray.Begin + (step + 0.5) * this->Step;
      const VoxelCell cell = this->Grid.Locate(ray.GetPosition(middle));
      double emptyEnd;
      if (this->Bricks.FindEmptyRun(cell.Index, ray, emptyEnd))
      {
        step = std::max(step + 1.0, this->GetFirstStepBeyond(ray, emptyEnd));
        continue;
      }
      depth += this->GetDepth(ray, cell, middle, this->Step);
      step += 1.0;
    }
    const double rest = length - wholeSteps * this->Step;
    if (rest > 0.0 && depth <= largestDepth)
    {
      const double middle = ray.End - 0.5 * rest;
      depth += this->GetDepth(ray, this->Grid.Locate(ray.GetPosition(middle)), middle, rest);
    }
    return depth;
  }

private:
  // The margin keeps rounding from taking a step whose middle lies just beyond.
  double GetFirstStepBeyond(const ShadowRay& ray, double end) const
  {
    constexpr double margin = 1e-6;
    return std::ceil((end - ray.Begin) / this->Step - 0.5 - margin);
  }

  double GetDepth(const ShadowRay& ray, const VoxelCell& cell, double middle, double length) const
  {
    double depth = this->UnitDepth.GetValue(this->Grid.Interpolate(this->Scalars, cell));
    if (depth == 0.0)
    {
      return 0.0;
    }
    if (this->Gradient)
    {
      depth *= this->Gradient->GetValue(this->Grid, cell);
    }
    if (this->Mask)
    {
      depth *= this->Mask->GetVisiblePart(
        ray.GetPosition(middle - 0.5 * length), ray.GetPosition(middle + 0.5 * length));
    }
    return depth * length * this->PerUnitDistance;
  }

  const Scalar* Scalars;
  double Step;
  double PerUnitDistance;
  VoxelGrid Grid;
  FunctionLookup UnitDepth;
  EmptyBricks Bricks;
  std::optional<GradientOpacity> Gradient;
  std::optional<VoxelMask> Mask;
};
}

//------------------------------------------------------------------------------
std::unique_ptr<const Medium> MakeMedium(
  const UsableScalars& scalars, const MediumDescription& description)
{
  const auto opacity = std::make_shared<PiecewiseCurve>(description.Property->GetScalarOpacity(0));
  switch (scalars.Array->GetDataType())
  {
    vtkTemplateMacro(return std::make_unique<MediumOf<VTK_TT>>(scalars, description, opacity));
  }
  return nullptr;
}

}
