/**
 * @file    StepPreparation.h
 * @brief   how long the steps of a picture's rays are
 */

#ifndef StepPreparation_h
#define StepPreparation_h

#include <string>
#include <vector>

class vtkIlluminatedVolumeMapper;

namespace penumbra
{

struct DrawnScene;
class VolumeTextures;

/// Of view rays and of shadow rays, in the volume's own coordinates, more than 0.
struct SampleDistances
{
  double View = 1.0;
  double Shadow = 2.0;
};

/// Those the mapper was given, or their defaults.
SampleDistances GetSampleDistances(vtkIlluminatedVolumeMapper* mapper);

/// Shorter than asked where lit matter's functions change much within a step.
SampleDistances ShortenSteepSteps(const SampleDistances& asked, const DrawnScene& scene);

/// Plans the marching, once it is known which shadows are kept. nearSteps: steps of a kept shadow's
/// ray that are marched. Messages say what could not be as asked, one sentence each.
void PrepareSteps(const SampleDistances& asked, int nearSteps, DrawnScene& scene,
  const VolumeTextures& textures, std::vector<std::string>& messages);

}

#endif
