/**
 * @file    RadianceTerm.h
 * @brief   what one segment of a view ray adds to its pixel
 */

#ifndef RadianceTerm_h
#define RadianceTerm_h

#include "RaySegments.h"

namespace penumbra::reference
{

/**
 * The integral of s c T over a segment. Where s and T are known, c costs by far the most: at first
 * there are 3 samples of it, Gauss's, between which it is taken as quadratic, and then the
 * rule's 7. The 3 are trusted only as far as they are equal; the error bound of the 7 is how far
 * they are off the quadratic through the 3, summed without regard to sign and doubled, as a kink
 * between nodes can make it larger than they show.
 */
struct RadianceTerm
{
  RaySegment Segment;
  std::array<ShadedSample, NumberOfNodes> Samples;
  /// Whether there are samples at all nodes, or at Gauss's.
  bool IsFine = false;
  /// How often the ray's segment was divided for this one.
  int Divisions = 0;
  Rgb Sum{};
  /// Bound on it.
  Rgb Error{};
  /// Of the channels, but for what comes from the shadows: this is what more samples reduce.
  double ReducibleError = 0.0;

  /// From the samples at Gauss's nodes.
  void SumCoarsely();
  /// From the samples at all nodes.
  void SumFinely();

private:
  void AddShadowErrors();
};

/// The rule's nodes that are not Gauss's.
constexpr std::array<int, NumberOfNodes - NumberOfGaussNodes> OtherNodes = { 0, 2, 4, 6 };

}

#endif
