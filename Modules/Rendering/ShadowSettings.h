/**
 * @file    ShadowSettings.h
 * @brief   how a picture's shadows are to be computed: as asked, or as chosen for the scene
 */

#ifndef ShadowSettings_h
#define ShadowSettings_h

#include "LightingRequirements.h"

#include <cstddef>
#include <string>

namespace penumbra
{

struct DrawnScene;
struct PictureRequest;
class VolumeTextures;

/// The numbers mean what they mean in vtkIlluminatedVolumeMapper.
struct ShadowSettings
{
  ShadowTechnique Technique = ShadowTechnique::Rays;
  double Resolution = 1.0;
  int NearSteps = 0;
  int MemoryLimit = 0; ///< in MiB
  bool Chosen = false; ///< for the scene, not asked
  std::string Reason;  ///< of the technique: one clause

  std::size_t GetLargestBytes() const { return static_cast<std::size_t>(this->MemoryLimit) << 20; }
};

/// The mapper's settings; where they leave it to Auto, ShadowChoice.h chooses for the scene, whose
/// requirements are known and whose matter is loaded.
ShadowSettings DecideShadows(
  const PictureRequest& request, const DrawnScene& scene, const VolumeTextures& textures);

}

#endif
