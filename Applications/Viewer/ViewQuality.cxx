#include "ViewQuality.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{

//------------------------------------------------------------------------------
void ViewQuality::NoteFrame(double seconds, int distance)
{
  this->SecondsOfWholeFrame = seconds * distance * distance;
}

//------------------------------------------------------------------------------
int ViewQuality::FindDistance(double rate) const
{
  const double distance = std::ceil(std::sqrt(this->SecondsOfWholeFrame * rate));
  return static_cast<int>(std::clamp(distance, 1.0, static_cast<double>(LargestDistance)));
}

}
