/**
 * @file    PicturePreparation.h
 * @brief   all that precedes the drawing of a picture, in its order
 */

#ifndef PicturePreparation_h
#define PicturePreparation_h

#include <string>
#include <vector>

namespace penumbra
{

struct DrawnScene;
struct PictureRequest;
struct ShadowSettings;
class VolumeDrawing;

/// Brings the scene, its shadows' settings and the drawing's textures to what is requested. Empty,
/// or why the volume cannot be drawn: one sentence. Messages say what could not be as asked, one
/// sentence each.
std::string PreparePicture(const PictureRequest& request, DrawnScene& scene,
  ShadowSettings& shadows, VolumeDrawing& drawing, std::vector<std::string>& messages);

}

#endif
