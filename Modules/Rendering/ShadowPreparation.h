/**
 * @file    ShadowPreparation.h
 * @brief   how a picture's shadows are computed: which are kept, where, and which are marched
 */

#ifndef ShadowPreparation_h
#define ShadowPreparation_h

#include "DrawnScene.h"
#include "ShadowSettings.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace penumbra
{

class VolumeDrawing;

/// Chooses what is kept of the scene's shadows and makes room for it, and tells the requirements.
/// The messages say what could not be as asked.
std::vector<std::string> PrepareShadows(const ShadowSettings& settings,
  vtkOpenGLRenderWindow* window, DrawnScene& scene, VolumeDrawing& drawing);

/// Tells the lights where to look their shadows up, once the scene's steps are planned.
void LookUpShadows(const ShadowSettings& settings, DrawnScene& scene);

}

#endif
