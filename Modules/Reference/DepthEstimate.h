/**
 * @file    DepthEstimate.h
 * @brief   the optical depth of a part of a piece of matter by one application of the rule
 */

#ifndef DepthEstimate_h
#define DepthEstimate_h

#include "MatterPieces.h"
#include "QuadratureRule.h"

#include <cmath>

namespace penumbra::reference
{

struct DepthEstimate
{
  double Depth = 0.0;
  /// Bound, where the extinction is smooth.
  double Error = 0.0;
  NodeValues Extinction;

  /// From `begin` to `end` in the span's parameter.
  DepthEstimate(const MatterPiece& piece, double begin, double end)
  {
    double gauss = 0.0;
    for (int i = 0; i < NumberOfNodes; ++i)
    {
      this->Extinction[i] = piece.GetExtinction(begin + (end - begin) * Rule.Nodes[i]);
      this->Depth += Rule.Weights[i] * this->Extinction[i];
    }
    for (int j = 0; j < NumberOfGaussNodes; ++j)
    {
      gauss += Rule.GaussWeights[j] * this->Extinction[GaussNodes[j]];
    }
    const double length = (end - begin) * piece.Span->GetLength();
    this->Error = std::abs(this->Depth - gauss) * length;
    this->Depth *= length;
  }
};

/// Beyond this share of a result its rounding errors are what is left.
constexpr double RoundingShare = 1e-14;

}

#endif
