#include "RadianceIntegral.h"

#include "ShadowEdge.h"

#include <algorithm>
#include <cmath>

namespace penumbra::reference
{
namespace
{
constexpr int MostDivisions = 40;
// Of the tolerance: how much may be seen of where a shadow's edge is not known.
constexpr double EdgeShare = 0.01;
}

//------------------------------------------------------------------------------
RadianceIntegral::RadianceIntegral(
  const RenderingModel& model, const VolumeRay& ray, const vtkVector3d& toEye)
  : Model(model)
  , ToEye(toEye)
  , Segments(model, ray)
  , HardShadows(model.Lighting ? model.Lighting->GetNumberOfHardShadows() : 0)
{
}

//------------------------------------------------------------------------------
ShadedSample RadianceIntegral::ComputeSample(const RaySegment& segment, double u)
{
  MatterSample sample = segment.GetSample(u);
  sample.ToEye = this->ToEye;
  const ShadedSample shaded = this->Model.Shade(sample);
  ++this->SampleCount;
  this->ShadowRayCount += shaded.ShadowRays;
  return shaded;
}

//------------------------------------------------------------------------------
void RadianceIntegral::SumCoarsely(RadianceTerm& term)
{
  for (const int node : GaussNodes)
  {
    term.Samples[node] = this->ComputeSample(term.Segment, term.Segment.GetPosition(node));
  }
  term.SumCoarsely();
}

//------------------------------------------------------------------------------
void RadianceIntegral::SumFinely(RadianceTerm& term)
{
  for (const int node : OtherNodes)
  {
    term.Samples[node] = this->ComputeSample(term.Segment, term.Segment.GetPosition(node));
  }
  term.SumFinely();
}

//------------------------------------------------------------------------------
void RadianceIntegral::Enqueue(std::size_t number)
{
  const RadianceTerm& term = this->Terms[number];
  for (int channel = 0; channel < 3; ++channel)
  {
    this->ErrorSum[channel] += term.Error[channel];
  }
  if (!term.IsFine || term.Divisions < MostDivisions)
  {
    this->Queue.push({ term.ReducibleError, number });
  }
}

//------------------------------------------------------------------------------
void RadianceIntegral::Refine(std::size_t number)
{
  const std::size_t count = this->Terms.size();
  RadianceTerm& term = this->Terms[number];
  for (int channel = 0; channel < 3; ++channel)
  {
    this->ErrorSum[channel] -= term.Error[channel];
  }
  if (!term.IsFine)
  {
    this->SumFinely(term);
  }
  else
  {
    this->Divide(number, 0.5 * (term.Segment.Piece.Begin + term.Segment.Piece.End));
  }
  this->DivideAtShadowEdges(number);
  this->Enqueue(number);
  for (std::size_t added = count; added < this->Terms.size(); ++added)
  {
    this->Enqueue(added);
  }
}

//------------------------------------------------------------------------------
void RadianceIntegral::Divide(std::size_t number, double u)
{
  RadianceTerm& first = this->Terms[number];
  ++first.Divisions;
  RadianceTerm second = first;
  first.Segment.Piece.End = second.Segment.Piece.Begin = u;
  const auto setMatter = [this](RaySegment& segment)
  {
    const DepthEstimate estimate(segment.Piece, segment.Piece.Begin, segment.Piece.End);
    segment.SetMatter(estimate, this->Model.Absorbs());
  };
  setMatter(first.Segment);
  if (this->Model.Absorbs())
  {
    second.Segment.Transmittance = first.Segment.Transmittance * std::exp(-first.Segment.Depth);
  }
  setMatter(second.Segment);
  this->SumCoarsely(first);
  this->SumCoarsely(second);
  this->Terms.push_back(second);
}

//------------------------------------------------------------------------------
double RadianceIntegral::GetResolution(const RaySegment& segment) const
{
  double density = 0.0;
  for (int node = 0; node < NumberOfNodes; ++node)
  {
    density = std::max(density, segment.Weights[node] / Rule.Weights[node]);
  }
  const double length = segment.Piece.End - segment.Piece.Begin;
  const double share = EdgeShare * this->Model.Tolerance / density;
  return length * std::min(share, 1.0);
}

//------------------------------------------------------------------------------
std::optional<double> RadianceIntegral::FindShadowEdge(const RadianceTerm& term, int shadow)
{
  std::vector<MarginSample> samples;
  for (int node = term.IsFine ? 0 : 1; node < NumberOfNodes; node += term.IsFine ? 1 : 2)
  {
    const double margin = term.Samples[node].ShadowMargins[shadow];
    if (std::isnan(margin))
    {
      return std::nullopt;
    }
    samples.push_back({ term.Segment.GetPosition(node), margin });
  }
  const auto getMargin = [&](double u)
  { return this->ComputeSample(term.Segment, u).ShadowMargins[shadow]; };
  const double begin = term.Segment.Piece.Begin;
  const double end = term.Segment.Piece.End;
  const double resolution = this->GetResolution(term.Segment);
  const auto edge = ShadowEdge(samples, begin, end).Find(getMargin, resolution);
  const bool matters = edge && *edge - begin > resolution && end - *edge > resolution;
  return matters ? edge : std::nullopt;
}

//------------------------------------------------------------------------------
std::optional<double> RadianceIntegral::FindShadowEdge(const RadianceTerm& term)
{
  std::optional<double> edge;
  for (int shadow = 0; shadow < this->HardShadows && !edge; ++shadow)
  {
    edge = this->FindShadowEdge(term, shadow);
  }
  return edge;
}

//------------------------------------------------------------------------------
void RadianceIntegral::DivideAtShadowEdges(std::size_t number)
{
  while (
    this->Terms[number].Divisions < MostDivisions && this->SampleCount < this->Model.MostSamples)
  {
    const std::optional<double> edge = this->FindShadowEdge(this->Terms[number]);
    if (!edge)
    {
      return;
    }
    this->Divide(number, *edge);
    this->DivideAtShadowEdges(this->Terms.size() - 1);
  }
}

//------------------------------------------------------------------------------
double RadianceIntegral::GetTotalError() const
{
  return *std::max_element(this->ErrorSum.begin(), this->ErrorSum.end()) +
    this->Segments.GetError();
}

//------------------------------------------------------------------------------
RayRadiance RadianceIntegral::GetSum() const
{
  RayRadiance sum;
  for (const RadianceTerm& term : this->Terms)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      sum.Radiance[channel] += term.Sum[channel];
    }
  }
  sum.Transmittance = this->Segments.GetTransmittance();
  sum.Samples = this->SampleCount;
  sum.ShadowRays = this->ShadowRayCount;
  return sum;
}

//------------------------------------------------------------------------------
RayRadiance RadianceIntegral::Compute()
{
  for (const RaySegment& segment : this->Segments.GetSegments())
  {
    RadianceTerm& term = this->Terms.emplace_back();
    term.Segment = segment;
    this->SumCoarsely(term);
  }
  const std::size_t count = this->Terms.size();
  for (std::size_t number = 0; number < count; ++number)
  {
    this->DivideAtShadowEdges(number);
  }
  for (std::size_t number = 0; number < this->Terms.size(); ++number)
  {
    this->Enqueue(number);
  }
  const double goal = this->Model.Tolerance;
  while (this->GetTotalError() > goal && !this->Queue.empty() &&
    this->SampleCount < this->Model.MostSamples)
  {
    const std::size_t number = this->Queue.top().Number;
    this->Queue.pop();
    this->Refine(number);
  }
  RayRadiance sum = this->GetSum();
  sum.Error = this->GetTotalError();
  sum.Converged = sum.Error <= goal;
  return sum;
}

}
