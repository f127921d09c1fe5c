/**
 * @file    ShadowPreparation.h
 * @brief   how a picture's shadows are computed: which are kept, where, and which are marched
 */

#ifndef ShadowPreparation_h
#define ShadowPreparation_h

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace penumbra
{

struct DrawnScene;
struct PictureRequest;
struct ShadowSettings;
class VolumeDrawing;

/// Halves the resolution of what is kept while a light with a shadow moves, until all is still.
void CoarsenMovingShadows(
  const PictureRequest& request, DrawnScene& scene, ShadowSettings& settings);

/// Chooses what is kept of the scene's shadows and makes room for it, and tells the requirements.
/// Messages say what could not be as asked, one sentence each.
void PrepareShadows(const ShadowSettings& settings, vtkOpenGLRenderWindow* window,
  DrawnScene& scene, VolumeDrawing& drawing, std::vector<std::string>& messages);

/// Tells the lights where to look their shadows up, once the scene's steps are planned.
void LookUpShadows(const ShadowSettings& settings, DrawnScene& scene);

}

#endif
