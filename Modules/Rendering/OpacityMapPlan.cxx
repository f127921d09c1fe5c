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

void SetCells(const ShadowMapTask& task, double cells, OpacityMapPlan& plan)
{
  plan.Texels = static_cast<int>(cells) + 2 * Border;
  plan.Layers = RoundUpToDraws(cells + 1.0);
  plan.Resolution = task.Span > 0.0 ? cells / task.Span : task.Resolution;
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
  // More are finer than any volume that fits a graphics card.
  constexpr double mostCells = 4096.0;
  // Small, so that little of the memory is left unused. What does not fit has a size of these
  // steps, whatever its span: a texture need not be made anew with every change of what is visible.
  constexpr double step = 0.97;
  constexpr double coarsest = 0.25;
  const double asked = std::max(std::ceil(task.Resolution * task.Span), 1.0 * FewestTexels);
  OpacityMapPlan plan;
  for (plan.Lights = task.Lights; plan.Lights > 0; --plan.Lights)
  {
    for (double most = mostCells; most >= coarsest * asked; most *= step)
    {
      SetCells(task, std::min(asked, std::floor(most)), plan);
      if (Fits(task, plan))
      {
        plan.Coarsened = most < asked;
        plan.TextureTexels = plan.Texels;
        plan.TextureSlices = plan.GetNumberOfSlices();
        return plan;
      }
    }
  }
  return {};
}

}
