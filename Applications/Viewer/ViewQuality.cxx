#include "ViewQuality.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Of a frame's time, which rays have at least.
constexpr double LeastPartOfRays = 0.25;
// Of a still frame's time, which one of what moves takes without being coarse.
constexpr double LeastPartOfStill = 0.125;
}

//------------------------------------------------------------------------------
void ViewQuality::NoteFrame(double seconds, double kept, int distance)
{
  this->SecondsOfRays = std::max(seconds - kept, 0.0) * distance * distance;
  this->SecondsOfKept = kept;
}

//------------------------------------------------------------------------------
void ViewQuality::NoteStill(double seconds)
{
  this->SecondsOfRays = std::clamp(this->SecondsOfRays, LeastPartOfStill * seconds, seconds);
}

//------------------------------------------------------------------------------
int ViewQuality::FindDistance(double rate) const
{
  const double left = std::max(1.0 / rate - this->SecondsOfKept, LeastPartOfRays / rate);
  const double distance = std::ceil(std::sqrt(this->SecondsOfRays / left));
  return static_cast<int>(std::clamp(distance, 1.0, static_cast<double>(LargestDistance)));
}

}
