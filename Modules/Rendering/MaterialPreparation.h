/**
 * @file    MaterialPreparation.h
 * @brief   how a picture's matter reflects light
 *
 * Messages say what could not be as asked, one sentence each.
 */

#ifndef MaterialPreparation_h
#define MaterialPreparation_h

#include <string>
#include <vector>

namespace penumbra
{

struct DrawnScene;
class EnvironmentTextures;
struct PictureRequest;
class VolumeTextures;

/// Loads the material's environment map where its reflection model mirrors one. Whether there is
/// one to be mirrored.
bool PrepareEnvironment(const PictureRequest& request, EnvironmentTextures& environment,
  std::vector<std::string>& messages);

/// Once the requirements are known.
void PrepareMaterial(const PictureRequest& request, DrawnScene& scene, VolumeTextures& textures);

}

#endif
