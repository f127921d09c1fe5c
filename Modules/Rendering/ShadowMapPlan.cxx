#include "ShadowMapPlan.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr std::size_t BytesPerTexel = 4 * sizeof(float);
constexpr int FewestTexels = 4;
// More are finer than any volume that fits a graphics card.
constexpr int MostTexels = 4096;
}

//------------------------------------------------------------------------------
std::size_t ShadowMapPlan::GetBytes() const
{
  const auto texels = static_cast<std::size_t>(this->Texels);
  return texels * texels * static_cast<std::size_t>(this->GetNumberOfSlices()) * BytesPerTexel;
}

//------------------------------------------------------------------------------
ShadowMapPlan PlanShadowMaps(const ShadowMapTask& task)
{
  ShadowMapPlan plan;
  plan.Lights = std::min(task.Lights, task.LargestSize / ShadowMapPlan::SlicesPerLight);
  const double asked = std::ceil(task.Resolution * task.Span);
  const int largest = std::min(task.LargestSize, MostTexels);
  plan.Texels = static_cast<int>(std::clamp(asked, 1.0 * FewestTexels, 1.0 * largest));
  const auto bytes = static_cast<double>(plan.GetBytes());
  if (bytes > static_cast<double>(task.LargestBytes))
  {
    const double factor = std::sqrt(static_cast<double>(task.LargestBytes) / bytes);
    plan.Texels = std::max(static_cast<int>(plan.Texels * factor), FewestTexels);
  }
  plan.Coarsened = plan.Texels < asked;
  plan.Resolution = task.Span > 0.0 ? plan.Texels / task.Span : task.Resolution;
  return plan;
}

}
