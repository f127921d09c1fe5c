#include "StepFigures.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace penumbra
{
namespace
{
struct Figures
{
  double Step;
  double Error;
  double Time;
};

constexpr Figures Study[] = { { 4.0, 8.675, 0.142 }, { 2.0, 4.225, 0.225 }, { 1.0, 1.45, 0.417 },
  { 0.5, 0.42, 1.0 }, { 0.25, 0.265, 2.51 }, { 0.125, 0.205, 7.44 }, { 0.0625, 0.18, 24.9 } };

// What `get` is where `of` is `value`; beyond the study's ends as at them.
double LookUp(double value, double Figures::*of, double Figures::*get)
{
  const auto isPast = [=](const Figures& row) { return row.*of < value; }; // steps and errors fall
  const Figures* below = std::find_if(std::begin(Study), std::end(Study), isPast);
  if (below == std::begin(Study))
  {
    return below->*get;
  }
  if (below == std::end(Study))
  {
    return (below - 1)->*get;
  }
  const Figures* above = below - 1;
  const double part = std::log(value / (above->*of)) / std::log((below->*of) / (above->*of));
  return above->*get * std::pow((below->*get) / (above->*get), part);
}
}

//------------------------------------------------------------------------------
double TypicalError(double step)
{
  return LookUp(step, &Figures::Step, &Figures::Error);
}

//------------------------------------------------------------------------------
double StepOfTypicalError(double error)
{
  return std::clamp(LookUp(error, &Figures::Error, &Figures::Step), ShortestStep, LongestStep);
}

//------------------------------------------------------------------------------
double TypicalTime(double step)
{
  return LookUp(step, &Figures::Step, &Figures::Time);
}

}
