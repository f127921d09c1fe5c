/**
 * @file    TexturePreparation.h
 * @brief   loads what a picture needs of its volume onto the graphics card
 *
 * Messages say what could not be as asked, one sentence each.
 */

#ifndef TexturePreparation_h
#define TexturePreparation_h

#include <string>
#include <vector>

namespace penumbra
{

struct DrawnScene;
struct PictureRequest;
class VolumeTextures;

/// Loads scalars, mask and transfer functions. Empty, or why the volume cannot be drawn: one
/// sentence.
std::string PrepareTextures(const PictureRequest& request, DrawnScene& scene,
  VolumeTextures& textures, std::vector<std::string>& messages);

/// Finds the bricks without visible matter that rays may leap over, where they are to, or where the
/// choice of a shadow technique depends on them. Whether there are enough to leap over.
bool PrepareEmptySpace(
  const PictureRequest& request, const DrawnScene& scene, VolumeTextures& textures);

/// As the mapper asks for them, or as it leaves them to the scalars.
int GetGradientTextureBits(const PictureRequest& request, const VolumeTextures& textures);

/// Loads the gradients where the requirements ask for them; takes that back where the graphics card
/// cannot hold them.
void PrepareGradients(const PictureRequest& request, DrawnScene& scene, VolumeTextures& textures,
  std::vector<std::string>& messages);

}

#endif
