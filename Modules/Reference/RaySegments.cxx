#include "RaySegments.h"

#include "RaySpans.h"

#include <cmath>

namespace penumbra::reference
{
namespace
{
constexpr int MostHalvings = 60;
// Beyond it nothing is halved any more: no ray goes on for ever.
constexpr int MostParts = 100000;
constexpr double LargestDepth = 1.0;
}

//------------------------------------------------------------------------------
MatterSample RaySegment::GetSample(double u) const
{
  const CellSpan& span = this->Seen->Span;
  MatterSample sample;
  const double scalar = span.Scalar.At(u);
  for (int axis = 0; axis < 3; ++axis)
  {
    sample.Position[axis] = span.Cell[axis] + (span.Start[axis] + span.Step[axis] * u);
    sample.Gradient[axis] = this->Seen->Gradient[axis].At(u);
    sample.Color[axis] = this->Color->At(scalar, axis);
  }
  return sample;
}

//------------------------------------------------------------------------------
void RaySegment::SetMatter(const DepthEstimate& estimate, bool absorbs)
{
  const double length = (this->Piece.End - this->Piece.Begin) * this->Piece.Span->GetLength();
  this->Depth = estimate.Depth;
  for (int i = 0; i < NumberOfNodes; ++i)
  {
    double depth = 0.0;
    for (int k = 0; absorbs && k < NumberOfNodes; ++k)
    {
      depth += length * Rule.WeightsToNode[i][k] * estimate.Extinction[k];
    }
    this->Weights[i] =
      this->Transmittance * length * Rule.Weights[i] * estimate.Extinction[i] * std::exp(-depth);
  }
}

//------------------------------------------------------------------------------
RaySegments::RaySegments(const RenderingModel& model, const VolumeRay& ray)
  : Model(model)
  , TolerancePerLength(DepthShare * model.Tolerance / ray.Length)
  , ToEye(-ray.Direction)
{
  VisitSpans(model.Matter, ray, [this](const CellSpan& span) { return this->AddSpan(span); });
}

//------------------------------------------------------------------------------
bool RaySegments::AddSpan(const CellSpan& span)
{
  const VolumeMatter& matter = this->Model.Matter;
  const bool hasGradientOpacity = matter.GetGradientOpacity() != nullptr;
  ViewSpan& seen = this->Spans.emplace_back();
  seen.Span = span;
  if (hasGradientOpacity || this->Model.Lighting)
  {
    seen.Gradient = matter.GetGradient(span);
  }
  if (hasGradientOpacity)
  {
    seen.SquaredGradient = matter.GetSquaredGradient(seen.Gradient);
  }
  const Polynomial<6>* squared = hasGradientOpacity ? &seen.SquaredGradient : nullptr;
  this->Breaks.clear();
  AppendMatterBreaks(matter, seen.Span, squared, this->Breaks);
  AppendCrossings(seen.Span.Scalar, this->Model.Colors.GetLevels(), this->Breaks);
  if (this->Model.Lighting)
  {
    this->Model.Lighting->AppendBreaks(seen.Span, seen.Gradient, this->ToEye, this->Breaks);
  }
  return VisitPieces(matter, seen.Span, squared, this->Breaks,
    [&](const MatterPiece& piece) { return this->AddPart(piece, seen, MostHalvings); });
}

//------------------------------------------------------------------------------
bool RaySegments::IsGood(const DepthEstimate& estimate, double length) const
{
  if (this->Model.Absorbs() && this->Model.HasColors() && estimate.Depth > LargestDepth)
  {
    return false;
  }
  return this->Transmittance * estimate.Error <= this->TolerancePerLength * length ||
    estimate.Error <= RoundingShare * estimate.Depth;
}

//------------------------------------------------------------------------------
bool RaySegments::AddPart(MatterPiece piece, const ViewSpan& seen, int halvings)
{
  const DepthEstimate estimate(piece, piece.Begin, piece.End);
  const double length = (piece.End - piece.Begin) * seen.Span.GetLength();
  if (halvings > 0 && ++this->Parts < MostParts && !this->IsGood(estimate, length))
  {
    MatterPiece second = piece;
    piece.End = second.Begin = 0.5 * (piece.Begin + piece.End);
    return this->AddPart(piece, seen, halvings - 1) && this->AddPart(second, seen, halvings - 1);
  }
  this->AddSegment(piece, seen, estimate);
  this->Cut = this->Transmittance <= RemainderShare * this->Model.Tolerance;
  return !this->Cut;
}

//------------------------------------------------------------------------------
void RaySegments::AddSegment(
  const MatterPiece& piece, const ViewSpan& seen, const DepthEstimate& estimate)
{
  this->Error += this->Transmittance * estimate.Error;
  if (this->Model.HasColors())
  {
    RaySegment& segment = this->Segments.emplace_back();
    segment.Seen = &seen;
    segment.Piece = piece;
    segment.Color =
      &this->Model.Colors.GetLine(seen.Span.Scalar.At(0.5 * (piece.Begin + piece.End)));
    segment.Transmittance = this->Transmittance;
    segment.SetMatter(estimate, this->Model.Absorbs());
  }
  if (this->Model.Absorbs())
  {
    this->Transmittance *= std::exp(-estimate.Depth);
  }
}

}
