#include "OpticalDepth.h"

#include "DepthEstimate.h"
#include "MatterPieces.h"
#include "RaySpans.h"

#include <cmath>

namespace penumbra::reference
{
namespace
{
constexpr int MostHalvings = 48;
// Beyond it nothing is halved any more: no ray goes on for ever.
constexpr int MostParts = 100000;

/// One a thread, as allocating it costs more than a short ray.
std::vector<double>& GetScratch()
{
  thread_local std::vector<double> scratch;
  return scratch;
}
}

//------------------------------------------------------------------------------
OpticalDepth::OpticalDepth(const VolumeMatter& matter, double tolerance, double limit)
  : Matter(matter)
  , Tolerance(tolerance)
  , Limit(limit)
  , Breaks(GetScratch())
{
}

//------------------------------------------------------------------------------
void OpticalDepth::Integrate(const VolumeRay& ray)
{
  this->TolerancePerLength = this->Tolerance / ray.Length;
  VisitSpans(this->Matter, ray, [this](const CellSpan& span) { return this->AddSpan(span); });
}

//------------------------------------------------------------------------------
bool OpticalDepth::AddSpan(const CellSpan& span)
{
  Polynomial<6> squaredGradient;
  const bool hasGradientOpacity = this->Matter.GetGradientOpacity() != nullptr;
  if (hasGradientOpacity)
  {
    squaredGradient = this->Matter.GetSquaredGradient(this->Matter.GetGradient(span));
  }
  const Polynomial<6>* squared = hasGradientOpacity ? &squaredGradient : nullptr;
  this->Breaks.clear();
  AppendMatterBreaks(this->Matter, span, squared, this->Breaks);
  return VisitPieces(this->Matter, span, squared, this->Breaks,
    [this](const MatterPiece& piece)
    { return this->AddPart(piece, piece.Begin, piece.End, MostHalvings); });
}

//------------------------------------------------------------------------------
bool OpticalDepth::IsGood(const DepthEstimate& estimate, double length) const
{
  return estimate.Error <= RoundingShare * estimate.Depth ||
    estimate.Error * std::exp(-this->Depth) <= this->TolerancePerLength * length;
}

//------------------------------------------------------------------------------
bool OpticalDepth::AddPart(const MatterPiece& piece, double begin, double end, int halvings)
{
  const DepthEstimate estimate(piece, begin, end);
  const double least = this->Depth + estimate.Depth - estimate.Error;
  if (least > this->Limit)
  {
    this->Depth = least;
    return false;
  }
  const double length = (end - begin) * piece.Span->GetLength();
  if (halvings > 0 && ++this->Parts < MostParts && !this->IsGood(estimate, length))
  {
    const double middle = 0.5 * (begin + end);
    return this->AddPart(piece, begin, middle, halvings - 1) &&
      this->AddPart(piece, middle, end, halvings - 1);
  }
  this->Error += estimate.Error * std::exp(-this->Depth);
  this->Depth += estimate.Depth;
  return !this->IsBeyondLimit();
}

}
