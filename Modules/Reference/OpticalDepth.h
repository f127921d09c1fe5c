/**
 * @file    OpticalDepth.h
 * @brief   the integral of extinction along a ray
 */

#ifndef OpticalDepth_h
#define OpticalDepth_h

#include "VolumeMatter.h"

#include <vector>

namespace penumbra::reference
{

struct DepthEstimate;
struct MatterPiece;

/**
 * Integrates front to back, smooth piece by smooth piece, each halved until its share of the error
 * of the transmittance exp(-depth) is below the tolerance's. It stops where the depth certainly
 * exceeds a limit.
 */
class OpticalDepth
{
public:
  /// The tolerance is one of the transmittance.
  OpticalDepth(const VolumeMatter& matter, double tolerance, double limit);

  /// Along all of the ray, which is within the volume.
  void Integrate(const VolumeRay& ray);

  /// Where it is beyond the limit, what it is at least.
  double GetDepth() const { return this->Depth; }
  bool IsBeyondLimit() const { return this->Depth > this->Limit; }
  /// A bound on the error of the transmittance, so far as it was integrated.
  double GetError() const { return this->Error; }

private:
  bool AddSpan(const CellSpan& span);
  bool AddPart(const MatterPiece& piece, double begin, double end, int halvings);
  bool IsGood(const DepthEstimate& estimate, double length) const;

  const VolumeMatter& Matter;
  double Tolerance;
  double Limit;
  double TolerancePerLength = 0.0;
  double Depth = 0.0;
  double Error = 0.0;
  int Parts = 0;
  std::vector<double>& Breaks;
};

}

#endif
