/**
 * @file    LightPreparation.h
 * @brief   what a picture's lighting requires, and its lights
 */

#ifndef LightPreparation_h
#define LightPreparation_h

#include <string>
#include <vector>

namespace penumbra
{

struct DrawnScene;
struct PictureRequest;
class VolumeDrawing;

/// Computes the requirements, once the volume's textures are loaded, and the lights. Messages say
/// what could not be as asked, one sentence each.
void PrepareLights(const PictureRequest& request, DrawnScene& scene, VolumeDrawing& drawing,
  std::vector<std::string>& messages);

}

#endif
