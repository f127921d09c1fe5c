#include "SpeedTimes.h"

#include "Median.h"

namespace penumbra
{
namespace
{
// Processor seconds.
constexpr double LongFrame = 1.5;

bool IsEnough(const std::vector<double>& cpu, int rounds)
{
  return static_cast<int>(cpu.size()) >= rounds || (!cpu.empty() && cpu.front() > LongFrame);
}

void TimeEdit(const SpeedVariant& variant, SpeedRendering& rendering, SceneChange change,
  std::vector<double>& cpu)
{
  if (variant.HasEdits && !IsEnough(cpu, variant.Rounds))
  {
    cpu.push_back(rendering.DrawAfter(change).CpuSeconds);
  }
}
}

//------------------------------------------------------------------------------
void SpeedTimes::AddRound(const SpeedVariant& variant, SpeedRendering& rendering)
{
  if (!IsEnough(this->Cpu, variant.Rounds))
  {
    const FrameTime time = rendering.Draw();
    this->Cpu.push_back(time.CpuSeconds);
    this->Seconds.push_back(time.Seconds);
  }
  TimeEdit(variant, rendering, SceneChange::Light, this->LightEdits);
  TimeEdit(variant, rendering, SceneChange::Opacity, this->OpacityEdits);
}

//------------------------------------------------------------------------------
void SpeedTimes::PutInto(SpeedRow& row) const
{
  row.CpuSeconds = Median(this->Cpu);
  row.Seconds = Median(this->Seconds);
  if (!this->LightEdits.empty())
  {
    row.LightEdit = Median(this->LightEdits);
  }
  if (!this->OpacityEdits.empty())
  {
    row.OpacityEdit = Median(this->OpacityEdits);
  }
}

}
