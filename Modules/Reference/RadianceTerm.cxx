#include "RadianceTerm.h"

#include <algorithm>
#include <cmath>

namespace penumbra::reference
{
namespace
{
constexpr double SafetyFactor = 2.0;
// Of the colours of three samples: where they are equal, a narrow shadow may still be between them.
constexpr double LeastSpreadInShadows = 0.01;

using GaussValues = std::array<double, NumberOfGaussNodes>;
using NodeSamples = std::array<ShadedSample, NumberOfNodes>;

GaussValues GetGaussValues(const NodeSamples& samples, int channel)
{
  GaussValues values;
  for (int j = 0; j < NumberOfGaussNodes; ++j)
  {
    values[j] = samples[GaussNodes[j]].Color[channel];
  }
  return values;
}

/// The quadratic polynomial through the values at Gauss's nodes.
double GetQuadratic(const GaussValues& values, int node)
{
  return values[0] * Rule.QuadraticBasis[0][node] + values[1] * Rule.QuadraticBasis[1][node] +
    values[2] * Rule.QuadraticBasis[2][node];
}
}

//------------------------------------------------------------------------------
void RadianceTerm::SumCoarsely()
{
  const bool hasShadows = std::any_of(GaussNodes.begin(), GaussNodes.end(),
    [this](int node) { return this->Samples[node].ShadowRays > 0; });
  const double leastSpread = hasShadows ? LeastSpreadInShadows : 0.0;
  for (int channel = 0; channel < 3; ++channel)
  {
    const GaussValues values = GetGaussValues(this->Samples, channel);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    this->Sum[channel] = this->Error[channel] = 0.0;
    for (int node = 0; node < NumberOfNodes; ++node)
    {
      this->Sum[channel] += this->Segment.Weights[node] * GetQuadratic(values, node);
      this->Error[channel] += this->Segment.Weights[node] * std::max(*high - *low, leastSpread);
    }
  }
  this->IsFine = false;
  this->AddShadowErrors();
}

//------------------------------------------------------------------------------
void RadianceTerm::SumFinely()
{
  for (int channel = 0; channel < 3; ++channel)
  {
    const GaussValues values = GetGaussValues(this->Samples, channel);
    this->Sum[channel] = this->Error[channel] = 0.0;
    for (int node = 0; node < NumberOfNodes; ++node)
    {
      const double weight = this->Segment.Weights[node];
      const double value = this->Samples[node].Color[channel];
      this->Sum[channel] += weight * value;
      this->Error[channel] += SafetyFactor * weight * std::abs(value - GetQuadratic(values, node));
    }
  }
  this->IsFine = true;
  this->AddShadowErrors();
}

//------------------------------------------------------------------------------
void RadianceTerm::AddShadowErrors()
{
  this->ReducibleError = *std::max_element(this->Error.begin(), this->Error.end());
  for (int node = 0; node < NumberOfNodes; ++node)
  {
    const int nearest = this->IsFine ? node : std::min(node | 1, GaussNodes.back());
    for (double& error : this->Error)
    {
      error += this->Segment.Weights[node] * this->Samples[nearest].Error;
    }
  }
}

}
