#include "ShadowingMatter.h"

#include "DrawnScene.h"
#include "ShaderSource.h"
#include "VolumeTextures.h"

#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <tuple>

namespace penumbra
{
namespace
{
auto AsTuple(const ShadowingMatter& m)
{
  return std::tie(m.Requirements, m.ScalarsTime, m.MaskTime, m.LinearInterpolation,
    m.GradientTextureBits, m.Opacity, m.GradientOpacity, m.UnitDistance, m.TextureToOwn, m.BoxLow,
    m.BoxHigh, m.ClippingPlanes, m.CroppingLow, m.CroppingHigh, m.CroppingFlags,
    m.ShadowSampleDistance);
}

std::vector<double> DescribeFunction(vtkPiecewiseFunction* function)
{
  std::vector<double> description = { static_cast<double>(function->GetClamping()),
    static_cast<double>(function->GetUseLogScale()) };
  for (int point = 0; point < function->GetSize(); ++point)
  {
    double values[4];
    function->GetNodeValue(point, values);
    description.insert(description.end(), values, values + 4);
  }
  return description;
}
}

//------------------------------------------------------------------------------
bool ShadowingMatter::operator==(const ShadowingMatter& other) const
{
  return AsTuple(*this) == AsTuple(other);
}

//------------------------------------------------------------------------------
ShadowingMatter DescribeShadowingMatter(
  const DrawnScene& scene, const VolumeTextures& textures, vtkVolumeProperty* property)
{
  ShadowingMatter matter;
  matter.Requirements = GetMatterRequirements(scene.Requirements);
  matter.ScalarsTime = textures.GetScalarsTime();
  matter.MaskTime = textures.HasMask() ? textures.GetMaskTime() : 0;
  matter.LinearInterpolation = property->GetInterpolationType() != VTK_NEAREST_INTERPOLATION;
  matter.Opacity = DescribeFunction(property->GetScalarOpacity(0));
  if (matter.Requirements.GradientOpacity)
  {
    matter.GradientOpacity = DescribeFunction(property->GetGradientOpacity(0));
    matter.GradientTextureBits = textures.GetGradientReport().Bits;
  }
  matter.UnitDistance = scene.UnitDistance;
  matter.TextureToOwn = scene.Placement.TextureToOwn;
  matter.BoxLow = scene.Placement.BoxLow;
  matter.BoxHigh = scene.Placement.BoxHigh;
  matter.ClippingPlanes = scene.ClippingPlanes;
  matter.CroppingFlags = scene.CroppingFlags;
  if (scene.CroppingFlags != 0)
  {
    matter.CroppingLow = scene.CroppingLow;
    matter.CroppingHigh = scene.CroppingHigh;
  }
  matter.ShadowSampleDistance = scene.Plan.ShadowSampleDistance;
  return matter;
}

}
