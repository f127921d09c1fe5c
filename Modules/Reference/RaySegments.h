/**
 * @file    RaySegments.h
 * @brief   a view ray cut into segments of smooth matter, with the light that gets through to each
 */

#ifndef RaySegments_h
#define RaySegments_h

#include "DepthEstimate.h"
#include "RenderingModel.h"

#include <deque>
#include <vector>

namespace penumbra::reference
{

/// A span as the eye sees it.
struct ViewSpan
{
  CellSpan Span;
  SpanGradient Gradient;
  Polynomial<6> SquaredGradient;
};

/**
 * Between breaks of everything that is known to be not smooth, and at most of optical depth 1:
 * samples at the rule's nodes see enough of it.
 */
struct RaySegment
{
  const ViewSpan* Seen = nullptr;
  /// Begin and End are those of the segment.
  MatterPiece Piece;
  const PiecewiseLinear<3>::Line* Color = nullptr;
  /// From the eye to its beginning.
  double Transmittance = 1.0;
  double Depth = 0.0;
  /// Of the colours at the rule's nodes in the picture: T s dt. Their sum is T (1 - exp(-depth)).
  NodeValues Weights{};

  double GetPosition(int node) const
  {
    return this->Piece.Begin + (this->Piece.End - this->Piece.Begin) * Rule.Nodes[node];
  }
  MatterSample GetSample(double u) const;
  void SetMatter(const DepthEstimate& estimate, bool absorbs);
};

class RaySegments
{
public:
  /// The ray is within the volume.
  RaySegments(const RenderingModel& model, const VolumeRay& ray);

  std::vector<RaySegment>& GetSegments() { return this->Segments; }
  /// What is left of the light from behind the volume.
  double GetTransmittance() const { return this->Transmittance; }
  /// Bound on the transmittance's error, and on what lies beyond the last segment.
  double GetError() const { return this->Error + (this->Cut ? this->Transmittance : 0.0); }

private:
  bool AddSpan(const CellSpan& span);
  bool AddPart(MatterPiece piece, const ViewSpan& seen, int halvings);
  bool IsGood(const DepthEstimate& estimate, double length) const;
  void AddSegment(const MatterPiece& piece, const ViewSpan& seen, const DepthEstimate& estimate);

  const RenderingModel& Model;
  double TolerancePerLength;
  vtkVector3d ToEye;
  std::deque<ViewSpan> Spans;
  std::vector<RaySegment> Segments;
  std::vector<double> Breaks;
  double Transmittance = 1.0;
  double Error = 0.0;
  int Parts = 0;
  /// Whether the rest of the ray was left out, as too little of it is seen.
  bool Cut = false;
};

}

#endif
