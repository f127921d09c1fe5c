/**
 * @file    LobeIntegral.h
 * @brief   surroundings seen through a cosine's power
 */

#ifndef LobeIntegral_h
#define LobeIntegral_h

#include "Surroundings.h"

namespace penumbra::reference
{

/**
 * integral of E(w) max(R.w, 0)^n dw / integral of max(R.w, 0)^n dw. Patches of the surroundings are
 * divided until they are small against the lobe, and smaller where it ends by a kink or a step;
 * each counts by the moments of its light.
 */
class LobeIntegral
{
public:
  /// Powers below 0 count as 0, those above 1e8, a lobe of a hundredth of a degree, as 1e8. The
  /// surroundings must last.
  LobeIntegral(const Surroundings& surroundings, double power);

  /// What pixels the surroundings should have for this power, in radians.
  static double GetLargestPixel(double power);

  double GetPower() const { return this->Power; }
  /// Bound on the results' error where E is at most 1.
  double GetError() const;
  /// `direction` is of unit length.
  Rgb Evaluate(const vtkVector3d& direction) const;

private:
  bool IsSmall(const SkyPatch& patch, double cosine) const;
  double Integrate(const LightMoments& light, const vtkVector3d& direction, bool isNearKink) const;

  const Surroundings& Seen;
  double Power;
  double LargestRadius;
  /// Less counts as nothing.
  double LeastCosine;
};

}

#endif
