#include "LobeIntegral.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace penumbra::reference
{
namespace
{
constexpr double LargestPower = 1e8;
// Of a patch's radius to the lobe's standard deviation.
constexpr double LargestShare = 0.17;
// Where the lobe ends by a kink or a step.
constexpr double LargestAtKink = 0.02;
// In radii, how near a patch is to that for its cosines to count as spread, not by their moments.
constexpr double NearKink = 4.0;
// Above, the lobe ends so smoothly that nothing need be done there.
constexpr double LargestPowerWithKink = 4.0;
// Measured where the result is known; below the power 1 the lobe ends by a step, or steeply.
constexpr double ErrorWithoutStep = 4e-5;
constexpr double ErrorWithStep = 3e-4;
// Of the cosines in a patch, if it is a square: 1.8 along its sides, 2.4 across them.
constexpr double Kurtosis = 2.1;
// The logarithm of the share of the lobe's height that counts as nothing.
constexpr double LogarithmOfNothing = -14.0;
}

//------------------------------------------------------------------------------
LobeIntegral::LobeIntegral(const Surroundings& surroundings, double power)
  : Seen(surroundings)
  , Power(std::clamp(power, 0.0, LargestPower))
  , LargestRadius(LargestShare / std::sqrt(Power + 1.0))
  , LeastCosine(Power > 0.0 ? std::exp(LogarithmOfNothing / Power) : 0.0)
{
}

//------------------------------------------------------------------------------
double LobeIntegral::GetLargestPixel(double power)
{
  const double radius = LargestShare / std::sqrt(std::clamp(power, 0.0, LargestPower) + 1.0);
  // Of a square that, with all that is added to be safe, has this radius.
  return 1.3 * std::min(radius, LargestAtKink);
}

//------------------------------------------------------------------------------
double LobeIntegral::GetError() const
{
  return this->Power < 1.0 ? ErrorWithStep : ErrorWithoutStep;
}

//------------------------------------------------------------------------------
bool LobeIntegral::IsSmall(const SkyPatch& patch, double cosine) const
{
  const bool hasKink = this->Power < LargestPowerWithKink && std::abs(cosine) < patch.Radius;
  return patch.Radius <= (hasKink ? LargestAtKink : this->LargestRadius);
}

//------------------------------------------------------------------------------
double LobeIntegral::Integrate(
  const LightMoments& light, const vtkVector3d& direction, bool isNearKink) const
{
  if (light.Flux == 0.0)
  {
    return 0.0;
  }
  const double n = this->Power;
  const double mean = direction.Dot(light.First) / light.Flux;
  const double variance = std::max(light.GetSecond(direction) / light.Flux - mean * mean, 0.0);
  if (isNearKink)
  {
    // As if the cosine were equally distributed, with this variance.
    const double half = std::sqrt(3.0 * variance);
    const double high = std::max(mean + half, 0.0);
    const double low = std::max(mean - half, 0.0);
    return half == 0.0
      ? 0.0
      : light.Flux * (std::pow(high, n + 1.0) - std::pow(low, n + 1.0)) / (2.0 * half * (n + 1.0));
  }
  if (mean <= 0.0)
  {
    return 0.0;
  }
  const double value = std::pow(mean, n);
  const double curvature = n * (n - 1.0) / (mean * mean);
  const double fourth = curvature * (n - 2.0) * (n - 3.0) / (mean * mean);
  return light.Flux * value *
    (1.0 + variance * (0.5 * curvature + Kurtosis / 24.0 * fourth * variance));
}

//------------------------------------------------------------------------------
Rgb LobeIntegral::Evaluate(const vtkVector3d& direction) const
{
  Rgb sum{};
  this->Seen.VisitPatches(
    [&](const SkyPatch& patch)
    {
      const double cosine = direction.Dot(patch.Center);
      if (cosine + patch.Radius <= this->LeastCosine)
      {
        return false;
      }
      if (!this->IsSmall(patch, cosine))
      {
        return true;
      }
      const bool isNearKink =
        this->Power < LargestPowerWithKink && std::abs(cosine) < NearKink * patch.Radius;
      for (int channel = 0; channel < 3; ++channel)
      {
        sum[channel] += this->Integrate(patch.Light[channel], direction, isNearKink);
      }
      return false;
    });
  for (double& value : sum)
  {
    value *= (this->Power + 1.0) / (2.0 * vtkMath::Pi());
  }
  return sum;
}

}
