/**
 * @file    BareVolume.h
 * @brief   what is chosen for a volume that comes without a scene
 */

#ifndef BareVolume_h
#define BareVolume_h

#include "SceneDescription.h"
#include "SceneFile.h"

#include <string>
#include <vector>

class vtkImageData;

namespace penumbra
{

/**
 * The scene of a volume that was named alone, as good as it can be guessed: a preset by what its
 * values are, cropping to the patient's body where the preset asks for it, and a camera before the
 * front of what is visible. What the settings say stays. Each choice is told in `choices` with its
 * reason, one line each.
 * @throw InputError as SceneSource::Describe does.
 */
SceneDescription ArrangeBareVolume(
  const SceneSource& source, vtkImageData* image, std::vector<std::string>& choices);

/// A preset by which a bare volume's settings can be checked before its values are known.
std::string PresetForChecking(const SceneSource& source);

}

#endif
