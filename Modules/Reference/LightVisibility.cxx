#include "LightVisibility.h"

#include "OpticalDepth.h"

#include <algorithm>
#include <cmath>

namespace penumbra::reference
{
namespace
{
// How much further than to a hard shadow its ray is followed, to see where the shadow ends.
constexpr double DepthBeyondShadow = 1.0;
constexpr double ShadowEdgeShare = 0.1;
constexpr double LeastTolerance = 1e-13;

VolumeRay MakeShadowRay(const VolumeFrame& frame, const LightSource& light,
  const vtkVector3d& position, const vtkVector3d& toLight)
{
  VolumeRay ray = MakeRay(frame, position, frame.DirectionToIndex(toLight));
  if (light.HasPosition)
  {
    ray.Length = frame.GetOwnLength(frame.ToIndex(light.Position) - position);
  }
  ray.Cut(light.Bias, ray.Length);
  return ray;
}

Visibility GetSoftShadow(const VolumeMatter& matter, const VolumeRay& ray, double tolerance)
{
  OpticalDepth depth(matter, tolerance, -std::log(tolerance));
  depth.Integrate(ray);
  const double share = std::exp(-depth.GetDepth());
  return { share, depth.GetError() + (depth.IsBeyondLimit() ? share : 0.0) };
}

Visibility GetHardShadow(
  const VolumeMatter& matter, const VolumeRay& ray, double threshold, double tolerance)
{
  // Where the edge is depends on the depth itself, however little light is left.
  const double ofTransmittance =
    std::max(ShadowEdgeShare * tolerance * std::exp(-threshold), LeastTolerance);
  OpticalDepth depth(matter, ofTransmittance, threshold + DepthBeyondShadow);
  depth.Integrate(ray);
  const double margin = depth.GetDepth() - threshold;
  const double error =
    depth.GetError() * std::exp(std::min(depth.GetDepth(), threshold + DepthBeyondShadow));
  return { margin > 0.0 ? 0.0 : 1.0, std::abs(margin) < error ? 1.0 : 0.0,
    std::min(margin, DepthBeyondShadow) };
}
}

//------------------------------------------------------------------------------
Visibility GetVisibility(const VolumeMatter& matter, const LightSource& light,
  const vtkVector3d& position, const vtkVector3d& toLight, double tolerance)
{
  VolumeRay ray = MakeShadowRay(matter.GetFrame(), light, position, toLight);
  if (!(ray.Length > 0.0) || !matter.GetRegion().Clip(ray))
  {
    return { 1.0, 0.0, -light.LargestDepth };
  }
  const double half = 0.5 * std::min(tolerance, 1.0);
  return light.Shadow == ShadowKind::Hard ? GetHardShadow(matter, ray, light.LargestDepth, half)
                                          : GetSoftShadow(matter, ray, half);
}

}
