#include "OpacityMapPlan.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr int Border = 1;
constexpr int FewestTexels = 4;

int RoundUpToDraws(double layers)
{
  return OpacityMapPlan::LayersPerDraw *
    static_cast<int>(std::ceil(layers / OpacityMapPlan::LayersPerDraw));
}

void SetResolution(const ShadowMapTask& task, double resolution, OpacityMapPlan& plan)
{
  const double cells = std::max(std::ceil(resolution * task.Span), 1.0 * FewestTexels);
  plan.Texels = static_cast<int>(cells) + 2 * Border;
  plan.Layers = RoundUpToDraws(cells + 1.0);
  plan.Resolution = task.Span > 0.0 ? cells / task.Span : resolution;
}

bool Fits(const ShadowMapTask& task, const OpacityMapPlan& plan)
{
  return plan.Texels <= task.LargestSize && plan.GetNumberOfSlices() <= task.LargestSize &&
    plan.GetBytes() <= task.LargestBytes;
}
}

//------------------------------------------------------------------------------
std::size_t OpacityMapPlan::GetBytes() const
{
  const auto texels = static_cast<std::size_t>(this->Texels);
  return texels * texels * static_cast<std::size_t>(this->GetNumberOfSlices()) * BytesPerTexel;
}

//------------------------------------------------------------------------------
OpacityMapPlan PlanOpacityMaps(const ShadowMapTask& task)
{
  constexpr double step = 0.97; // small, so that little of the memory is left unused
  constexpr double coarsest = 0.25;
  OpacityMapPlan plan;
  for (plan.Lights = task.Lights; plan.Lights > 0; --plan.Lights)
  {
    for (double part = 1.0; part >= coarsest; part *= step)
    {
      SetResolution(task, part * task.Resolution, plan);
      if (Fits(task, plan))
      {
        plan.Coarsened = part < 1.0;
        return plan;
      }
    }
  }
  return {};
}

}
