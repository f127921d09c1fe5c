#include "ShadowChoice.h"

#include "OpacityMapPlan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace penumbra
{
namespace
{
constexpr std::size_t NumberOfOptions = 14;

// Of the options, in their order.
using OptionErrors = std::array<double, NumberOfOptions>;

struct MeasuredErrors
{
  double VoxelDepth;
  OptionErrors Soft;
  OptionErrors Hard;
};

// Ascending in the voxel depth.
constexpr MeasuredErrors SmoothMatter[] = {
#include "ShadowErrors.inc"
};

// Of transfer functions that jump within a step.
constexpr MeasuredErrors SteepMatter[] = {
#include "SteepShadowErrors.inc"
};

struct OptionSettings
{
  ShadowTechnique Technique;
  double Resolution;
  int NearSteps;
};

// In the order of the options.
constexpr OptionSettings Settings[NumberOfOptions] = { { ShadowTechnique::Rays, 1.0, 0 },
  { ShadowTechnique::Volume, 0.5, 0 }, { ShadowTechnique::Volume, 0.75, 0 },
  { ShadowTechnique::DeepMap, 1.0, 0 }, { ShadowTechnique::Volume, 1.0, 4 },
  { ShadowTechnique::DeepMap, 1.0, 4 }, { ShadowTechnique::OpacityMap, 1.0, 0 },
  { ShadowTechnique::OpacityMap, 1.0, 2 }, { ShadowTechnique::OpacityMap, 1.25, 3 },
  { ShadowTechnique::OpacityMap, 1.5, 4 }, { ShadowTechnique::Volume, 1.0, 0 },
  { ShadowTechnique::OpacityMap, 1.0, 1 }, { ShadowTechnique::OpacityMap, 1.25, 0 },
  { ShadowTechnique::Volume, 1.0, 1 } };

const OptionSettings& GetSettings(ShadowOption option)
{
  return Settings[static_cast<std::size_t>(option)];
}

double GetError(const MeasuredErrors& measured, std::size_t option, const ShadowChoiceTask& task)
{
  return std::max(task.SoftLights > 0 ? measured.Soft[option] : 0.0,
    task.HardLights > 0 ? measured.Hard[option] : 0.0);
}

// Linear over the logarithm of the voxel depth, constant beyond what was measured.
template <std::size_t Size>
double Interpolate(
  const MeasuredErrors (&measured)[Size], std::size_t option, const ShadowChoiceTask& task)
{
  std::size_t next = 0;
  while (next < Size && measured[next].VoxelDepth < task.VoxelDepth)
  {
    ++next;
  }
  if (next == 0 || next == Size)
  {
    return GetError(measured[next == 0 ? 0 : Size - 1], option, task);
  }
  const MeasuredErrors& low = measured[next - 1];
  const MeasuredErrors& high = measured[next];
  const double part =
    std::log(task.VoxelDepth / low.VoxelDepth) / std::log(high.VoxelDepth / low.VoxelDepth);
  return (1.0 - part) * GetError(low, option, task) + part * GetError(high, option, task);
}

// How many times as many texels of a volume a long voxel has as a short one (ShadowVolumePlan).
double GetTexelRatio(const OptionSettings& settings, const ShadowChoiceTask& task)
{
  constexpr double mostOfLongVoxels = 2.0;
  return std::min(task.SpacingRatio, mostOfLongVoxels / settings.Resolution);
}

// Texels a voxel of the opacity maps of so many lights, as far as memory goes.
double GetOpacityMapResolution(const OptionSettings& settings, const ShadowChoiceTask& task)
{
  const double lights = task.SoftLights + task.HardLights;
  const double texels =
    static_cast<double>(task.LargestBytes) / (OpacityMapPlan::BytesPerTexel * lights);
  return std::min(settings.Resolution, std::cbrt(texels) / std::max(task.MatterAcross, 1.0));
}

// Of its error to that of what was measured.
double GetCoarseness(const OptionSettings& settings, const ShadowChoiceTask& task)
{
  // Measured: between linear interpolation of a smooth function and of a kink.
  constexpr double order = 1.5;
  switch (settings.Technique)
  {
    case ShadowTechnique::Volume:
      return task.SpacingRatio / GetTexelRatio(settings, task);
    case ShadowTechnique::OpacityMap:
      return std::pow(settings.Resolution / GetOpacityMapResolution(settings, task), order);
    default:
      return 1.0;
  }
}

// Errors grow with what they are errors of.
double GetBrightnessFactor(const ShadowChoiceTask& task)
{
  // Of the light and the material that were measured.
  constexpr double measured = 0.92;
  return task.Brightness / measured;
}

// Samples of a pixel that are lit before what lies behind them is hidden.
double CountLitSamples(const ShadowChoiceTask& task)
{
  constexpr double hiddenBehind = 8.0;
  // Matter of half the largest depth.
  return std::clamp(
    2.0 * hiddenBehind / std::max(task.VoxelDepth, 1e-6), 2.0, task.VoxelsAcross * task.Occupied);
}

double CountMarchedSteps(const OptionSettings& settings, const ShadowChoiceTask& task)
{
  // What is kept serves about a second of moving pictures.
  constexpr double pictures = 32.0;
  // Rays end, or leap, well before the far side.
  constexpr double marchedPart = 0.25;
  constexpr double volumeLookUp = 1.0;
  constexpr double mapLookUp = 5.0;
  constexpr double layerLookUp = 1.25;
  // Every layer is written, matter or not.
  constexpr double layer = 2.0;
  // In a row, with no look for an earlier end.
  constexpr double nearStep = 0.5;
  const double lights = task.SoftLights + task.HardLights;
  const double samples = lights * task.Pixels * CountLitSamples(task);
  const double ray = marchedPart * task.VoxelsAcross;
  if (settings.Technique == ShadowTechnique::Rays)
  {
    return samples * ray;
  }
  if (settings.Technique == ShadowTechnique::DeepMap)
  {
    return samples * (mapLookUp + nearStep * settings.NearSteps) +
      lights * task.VoxelsAcross * task.VoxelsAcross * task.VoxelsAcross / pictures;
  }
  if (settings.Technique == ShadowTechnique::OpacityMap)
  {
    return samples * (layerLookUp + nearStep * settings.NearSteps) +
      layer * lights * std::pow(GetOpacityMapResolution(settings, task) * task.MatterAcross, 3) /
      pictures;
  }
  const double texels = lights * task.Voxels * task.Occupied * std::pow(settings.Resolution, 3) *
    GetTexelRatio(settings, task);
  // One look-up tells of four lights.
  const double lookUp = volumeLookUp * std::ceil(lights / 4.0) / lights;
  return samples * (lookUp + nearStep * settings.NearSteps) +
    texels * 2.0 * ray * settings.Resolution / pictures;
}
}

//------------------------------------------------------------------------------
double PredictShadowError(ShadowOption option, const ShadowChoiceTask& task)
{
  const auto index = static_cast<std::size_t>(option);
  const double error = task.SteepOpacity ? Interpolate(SteepMatter, index, task)
                                         : Interpolate(SmoothMatter, index, task);
  if (option == ShadowOption::Rays)
  {
    // Measured at steps of a voxel. Behind a jump in opacity the error falls no faster.
    return error * task.ShadowStep * GetBrightnessFactor(task);
  }
  return GetCoarseness(GetSettings(option), task) * error * GetBrightnessFactor(task);
}

//------------------------------------------------------------------------------
double PredictShadowCost(ShadowOption option, const ShadowChoiceTask& task)
{
  // A few milliseconds of one processor, which other things of a picture take too.
  constexpr double negligible = 3e6;
  return std::max(CountMarchedSteps(GetSettings(option), task), negligible);
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
  const auto error = [&](ShadowOption option) { return PredictShadowError(option, task); };
  const auto cost = [&](ShadowOption option) { return PredictShadowCost(option, task); };
  const auto cheaper = [&](ShadowOption a, ShadowOption b)
  {
    const bool aWithin = error(a) <= task.Tolerance;
    const bool bWithin = error(b) <= task.Tolerance;
    if (aWithin != bWithin)
    {
      return aWithin;
    }
    return aWithin && cost(a) != cost(b) ? cost(a) < cost(b) : error(a) < error(b);
  };
  std::array<ShadowOption, NumberOfOptions> options;
  for (std::size_t index = 0; index < options.size(); ++index)
  {
    options[index] = static_cast<ShadowOption>(index);
  }
  choice.Option = *std::min_element(options.begin(), options.end(), cheaper);
  const OptionSettings& settings = GetSettings(choice.Option);
  choice.Technique = settings.Technique;
  choice.Resolution = settings.Resolution;
  choice.NearSteps = settings.NearSteps;
  choice.PredictedError = error(choice.Option);
  const bool within = choice.PredictedError <= task.Tolerance;
  std::ostringstream reason;
  reason << std::fixed << std::setprecision(2) << "predicted error of " << choice.PredictedError
         << " of 255, " << (within ? "the cheapest within" : "the least, though beyond")
         << " the tolerance of " << task.Tolerance;
  choice.Reason = reason.str();
  return choice;
}

}
