/**
 * @file    ShadowChoice.h
 * @brief   the cheapest shadow technique whose predicted error is within a tolerance
 *
 * A function of the scene alone, never of a clock: the same scene has the same shadows everywhere.
 * Errors are predicted by measured ones (ShadowErrors.inc, which
 * Data/study/measure-shadow-errors.py makes), costs by counting the steps that are marched.
 */

#ifndef ShadowChoice_h
#define ShadowChoice_h

#include "LightingRequirements.h"
#include "PenumbraRenderingModule.h" // For export macro

#include <cstddef>
#include <string>

namespace penumbra
{

struct ShadowChoiceTask
{
  int SoftLights = 0;
  int HardLights = 0;
  /// Root of the sum of squares of what these lights add at most, of white.
  double Brightness = 1.0;
  /// Optical depth over a voxel of the densest matter of a brick, on average.
  double VoxelDepth = 0.0;
  /// Of a shadow ray, in smallest spacings.
  double ShadowStep = 1.0;
  /// Of the largest spacing to the smallest.
  double SpacingRatio = 1.0;
  /// The transfer functions change much within a step.
  bool SteepOpacity = false;
  double Pixels = 0.0;       ///< that rays are cast from
  double VoxelsAcross = 0.0; ///< the visible box's diagonal, in voxels
  double Voxels = 0.0;       ///< in the visible box
  double MatterAcross = 0.0; ///< diagonal of the box around visible matter, in voxels
  std::size_t LargestBytes = std::size_t(512) << 20; ///< that what is kept may take
  /// Part of the volume near visible matter, 0 to 1.
  double Occupied = 1.0;
  double Tolerance = 1.0; ///< root mean square error in grey levels of 255
};

/// What there is to choose from: rays; volumes of a half and of three quarters of the data's
/// resolution; deep maps; a volume of its full resolution and deep maps, with the first steps
/// marched; opacity maps, with the first steps marched too, and two finer ones; a volume of its
/// full resolution without marched steps; an opacity map with a single step marched, and a finer
/// one with none; a volume of its full resolution with a single step marched.
enum class ShadowOption
{
  Rays,
  CoarseVolume,
  MediumVolume,
  DeepMap,
  MarchedVolume,
  MarchedDeepMap,
  OpacityMap,
  MarchedOpacityMap,
  FineOpacityMap,
  FinestOpacityMap,
  Volume,
  OneStepOpacityMap,
  UnmarchedFineOpacityMap,
  OneStepVolume
};

struct ShadowChoice
{
  ShadowOption Option = ShadowOption::Rays;
  ShadowTechnique Technique = ShadowTechnique::Rays;
  double Resolution = 1.0; ///< of what is kept, to be multiplied by the resolution that is asked
  int NearSteps = 0;       ///< that are marched
  double PredictedError = 0.0; ///< in grey levels of 255
  std::string Reason;          ///< one clause
};

/// Predicted root mean square error of a picture against shadow rays of half the step.
PENUMBRARENDERING_EXPORT double PredictShadowError(
  ShadowOption option, const ShadowChoiceTask& task);

/// Predicted cost of a picture's shadows, in marched steps; of what is kept a part, as if it served
/// several pictures. Costs too low to be noticed are one and the same.
PENUMBRARENDERING_EXPORT double PredictShadowCost(
  ShadowOption option, const ShadowChoiceTask& task);

/// Where none is within the tolerance, or several cost the same, the one of the least error.
PENUMBRARENDERING_EXPORT ShadowChoice ChooseShadowTechnique(const ShadowChoiceTask& task);

}

#endif
