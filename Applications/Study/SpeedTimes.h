/**
 * @class   SpeedTimes
 * @brief   how long a variant's frames take, round by round
 */

#ifndef SpeedTimes_h
#define SpeedTimes_h

#include "SpeedRendering.h"
#include "SpeedRow.h"

#include <vector>

namespace penumbra
{

class SpeedTimes
{
public:
  /// A frame, and one after each edit where the variant has edits. What takes long is timed once,
  /// and nothing more often than the variant asks for.
  void AddRound(const SpeedVariant& variant, SpeedRendering& rendering);

  /// Medians.
  void PutInto(SpeedRow& row) const;

private:
  std::vector<double> Cpu;
  std::vector<double> Seconds;
  std::vector<double> LightEdits;
  std::vector<double> OpacityEdits;
};

}

#endif
