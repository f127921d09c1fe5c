#include "InteractiveResolution.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Distances that differ by less are not worth another size of the picture.
constexpr double Coarseness = 0.25;
}

//------------------------------------------------------------------------------
bool InteractiveResolution::IsInteractive(double allocatedSeconds)
{
  return allocatedSeconds > 0.0 && allocatedSeconds < LongestInteractiveFrame;
}

//------------------------------------------------------------------------------
double InteractiveResolution::FindDistance(double allocatedSeconds) const
{
  if (!IsInteractive(allocatedSeconds))
  {
    return 1.0;
  }
  const double distance = std::sqrt(this->FullFrameSeconds / allocatedSeconds);
  return std::clamp(std::ceil(distance / Coarseness) * Coarseness, 1.0, LargestDistance);
}

//------------------------------------------------------------------------------
void InteractiveResolution::Measure(double distance, double seconds)
{
  this->FullFrameSeconds = seconds * distance * distance;
}

}
