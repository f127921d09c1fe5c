/**
 * @file    MatterPieces.h
 * @brief   a span cut where its extinction is not smooth
 */

#ifndef MatterPieces_h
#define MatterPieces_h

#include "LevelCrossings.h"
#include "VolumeMatter.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace penumbra::reference
{

/// A span's extinction between two levels of the transfer functions, where it is analytic.
struct MatterPiece
{
  const CellSpan* Span = nullptr;
  const ExtinctionLine* Line = nullptr;
  /// Null: no gradient opacity.
  const PiecewiseLinear<1>::Line* Factor = nullptr;
  const Polynomial<6>* SquaredGradient = nullptr;
  /// In the span's parameter.
  double Begin = 0.0;
  double End = 1.0;

  /// Per length in the volume's own frame.
  double GetExtinction(double u) const
  {
    const double extinction = this->Line->At(this->Span->Scalar.At(u));
    return this->Factor
      ? extinction * this->Factor->At(std::sqrt(std::max(this->SquaredGradient->At(u), 0.0)))
      : extinction;
  }

  bool HasNone() const
  {
    return this->Line->IsZero() ||
      (this->Factor && this->Factor->AtStart[0] == 0.0 && this->Factor->Slope[0] == 0.0);
  }
};

/// Appends where along the span extinction is not smooth. `squaredGradient` is null where there is
/// no gradient opacity.
inline void AppendMatterBreaks(const VolumeMatter& matter, const CellSpan& span,
  const Polynomial<6>* squaredGradient, std::vector<double>& breaks)
{
  AppendCrossings(span.Scalar, matter.GetExtinction().GetLevels(), breaks);
  if (squaredGradient)
  {
    AppendCrossings(*squaredGradient, matter.GetSquaredGradientLevels(), breaks);
  }
}

/**
 * Calls visit(MatterPiece) for the pieces between breaks that have extinction, front to back, until
 * it returns false, which is returned then. Sorts the breaks.
 */
template <typename Visitor>
bool VisitPieces(const VolumeMatter& matter, const CellSpan& span,
  const Polynomial<6>* squaredGradient, std::vector<double>& breaks, Visitor visit)
{
  breaks.push_back(1.0);
  std::sort(breaks.begin(), breaks.end());
  MatterPiece piece;
  piece.Span = &span;
  piece.SquaredGradient = squaredGradient;
  for (const double end : breaks)
  {
    piece.End = end;
    const double middle = 0.5 * (piece.Begin + piece.End);
    piece.Line = &matter.GetExtinction().GetLine(span.Scalar.At(middle));
    if (squaredGradient)
    {
      const double magnitude = std::sqrt(std::max(squaredGradient->At(middle), 0.0));
      piece.Factor = &matter.GetGradientOpacity()->GetLine(magnitude);
    }
    if (piece.End > piece.Begin && !piece.HasNone() && !visit(piece))
    {
      return false;
    }
    piece.Begin = piece.End;
  }
  return true;
}

}

#endif
