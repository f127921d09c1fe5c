#include "ShadowChoice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace penumbra
{
namespace
{
// Errors of rays, volume and deep map.
using TechniqueErrors = std::array<double, 3>;

struct MeasuredErrors
{
  double VoxelDepth;
  TechniqueErrors Soft;
  TechniqueErrors Hard;
};

// Ascending in the voxel depth.
constexpr MeasuredErrors SmoothMatter[] = {
#include "ShadowErrors.inc"
};

// Of transfer functions that jump within a step.
constexpr MeasuredErrors SteepMatter[] = {
#include "SteepShadowErrors.inc"
};

constexpr std::array<ShadowTechnique, 3> Techniques = { ShadowTechnique::Rays,
  ShadowTechnique::Volume, ShadowTechnique::DeepMap };

// A map of first hits, which is never chosen, counts as a deep map.
std::size_t IndexOf(ShadowTechnique technique)
{
  switch (technique)
  {
    case ShadowTechnique::Rays:
      return 0;
    case ShadowTechnique::Volume:
      return 1;
    default:
      return 2;
  }
}

double GetError(const MeasuredErrors& measured, std::size_t technique, const ShadowChoiceTask& task)
{
  return std::max(task.SoftLights > 0 ? measured.Soft[technique] : 0.0,
    task.HardLights > 0 ? measured.Hard[technique] : 0.0);
}

// Linear over the logarithm of the voxel depth, constant beyond what was measured.
template <std::size_t Size>
double Interpolate(
  const MeasuredErrors (&measured)[Size], std::size_t technique, const ShadowChoiceTask& task)
{
  std::size_t next = 0;
  while (next < Size && measured[next].VoxelDepth < task.VoxelDepth)
  {
    ++next;
  }
  if (next == 0 || next == Size)
  {
    return GetError(measured[next == 0 ? 0 : Size - 1], technique, task);
  }
  const MeasuredErrors& low = measured[next - 1];
  const MeasuredErrors& high = measured[next];
  const double part =
    std::log(task.VoxelDepth / low.VoxelDepth) / std::log(high.VoxelDepth / low.VoxelDepth);
  return (1.0 - part) * GetError(low, technique, task) + part * GetError(high, technique, task);
}

// Samples of a pixel that are lit before what lies behind them is hidden.
double CountLitSamples(const ShadowChoiceTask& task)
{
  constexpr double hiddenBehind = 8.0;
  // Matter of half the largest depth.
  return std::clamp(
    2.0 * hiddenBehind / std::max(task.VoxelDepth, 1e-6), 2.0, task.VoxelsAcross * task.Occupied);
}
}

//------------------------------------------------------------------------------
double PredictShadowError(ShadowTechnique technique, const ShadowChoiceTask& task)
{
  const std::size_t index = IndexOf(technique);
  const double error = task.SteepOpacity ? Interpolate(SteepMatter, index, task)
                                         : Interpolate(SmoothMatter, index, task);
  // A volume's texels are as far apart as voxels.
  const double coarseness = technique == ShadowTechnique::Volume ? task.SpacingRatio : 1.0;
  // Errors of several lights add up by their squares.
  return coarseness * error * std::sqrt(std::max(task.SoftLights + task.HardLights, 1));
}

//------------------------------------------------------------------------------
double PredictShadowCost(ShadowTechnique technique, const ShadowChoiceTask& task)
{
  // What is kept serves about a second of moving pictures.
  constexpr double pictures = 32.0;
  // Rays end, or leap, well before the far side.
  constexpr double marchedPart = 0.25;
  constexpr double volumeLookUp = 5.0;
  constexpr double mapLookUp = 9.0;
  const double lights = task.SoftLights + task.HardLights;
  const double samples = lights * task.Pixels * CountLitSamples(task);
  const double ray = marchedPart * task.VoxelsAcross;
  switch (technique)
  {
    case ShadowTechnique::Volume:
      return samples * volumeLookUp + lights * task.Voxels * task.Occupied * 2.0 * ray / pictures;
    case ShadowTechnique::Map:
    case ShadowTechnique::DeepMap:
      return samples * mapLookUp +
        lights * task.VoxelsAcross * task.VoxelsAcross * 4.0 * task.VoxelsAcross / pictures;
    default:
      return samples * ray;
  }
}

//------------------------------------------------------------------------------
ShadowChoice ChooseShadowTechnique(const ShadowChoiceTask& task)
{
  ShadowChoice choice;
  if (task.SoftLights + task.HardLights == 0)
  {
    choice.Reason = "no light casts a shadow";
    return choice;
  }
  const auto error = [&](ShadowTechnique technique) { return PredictShadowError(technique, task); };
  const auto cost = [&](ShadowTechnique technique) { return PredictShadowCost(technique, task); };
  const auto cheaper = [&](ShadowTechnique a, ShadowTechnique b)
  {
    const bool aWithin = error(a) <= task.Tolerance;
    const bool bWithin = error(b) <= task.Tolerance;
    if (aWithin != bWithin)
    {
      return aWithin;
    }
    return aWithin ? cost(a) < cost(b) : error(a) < error(b);
  };
  choice.Technique = *std::min_element(Techniques.begin(), Techniques.end(), cheaper);
  choice.PredictedError = error(choice.Technique);
  const bool within = choice.PredictedError <= task.Tolerance;
  std::ostringstream reason;
  reason << std::fixed << std::setprecision(2) << "predicted error of " << choice.PredictedError
         << " of 255, " << (within ? "the cheapest within" : "the least, though beyond")
         << " the tolerance of " << task.Tolerance;
  choice.Reason = reason.str();
  return choice;
}

}
