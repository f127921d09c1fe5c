/**
 * @file    SpeedBounds.h
 * @brief   what drawing may cost and how far it may be off, and whether it is so
 */

#ifndef SpeedBounds_h
#define SpeedBounds_h

#include "SpeedRow.h"

#include <optional>
#include <string>
#include <vector>

namespace penumbra
{

struct SpeedBound
{
  /// "lit", "a moved light", ...
  std::string Name;
  /// What the value is of: "median of 5 scenes", or the scene where it is largest.
  std::string Where;
  double Limit = 0.0;
  double Value = 0.0;

  bool IsHeld() const { return this->Value <= this->Limit; }
};

/**
 * Times are in unlit frames of the stock mapper, for scenes with bounds in their own size, errors
 * in grey levels of 255. A bound that nothing was measured for is not among them. Where a scene has
 * several techniques with a cache, the cheapest of those counts that are within the error's bound,
 * or the most accurate one where none is.
 */
std::vector<SpeedBound> JudgeSpeed(const std::vector<SpeedRow>& rows);

struct SpeedSummary
{
  std::string Line;
  bool WithinBounds = true;
};

/// The figures, and by name the bounds that are missed.
SpeedSummary SummarizeSpeed(const std::vector<SpeedRow>& rows);

}

#endif
