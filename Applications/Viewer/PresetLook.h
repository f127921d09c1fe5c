/**
 * @file    PresetLook.h
 * @brief   presets put into an open scene, and made of one
 */

#ifndef PresetLook_h
#define PresetLook_h

#include "SceneDescription.h"
#include "VolumeStatistics.h"

#include <filesystem>
#include <string>
#include <vector>

class vtkImageData;

namespace penumbra
{

struct PresetName
{
  std::string Name;
  std::string Description;
};

/// The presets that come with Penumbra and suit the modality; of an unknown modality all.
std::vector<PresetName> ListPresets(const std::string& modality);

/**
 * Gives the scene the transfer function, material and cropping of a preset: one of ListPresets, or
 * a file's name in `folder`. Lights and camera stay.
 * @throw InputError where there is no such preset.
 */
void ApplyPreset(const std::string& name, const std::filesystem::path& folder, vtkImageData* image,
  const VolumeStatistics& statistics, SceneDescription& scene);

/// Transfer function and material, which are the same where these texts are.
///@{
std::string LookOf(const SceneDescription& scene);
std::string LookOfPreset(const std::string& name, vtkImageData* image,
  const VolumeStatistics& statistics, SceneDescription scene);
///@}

/// The look of a scene as the text of a preset's file.
std::string WritePreset(const SceneDescription& scene, const std::string& name);

/// Moves all points of the transfer function by `shift` after stretching their distances from
/// `center` by `factor`, which is more than 0.
void ShiftAndStretch(
  TransferFunctionDescription& function, double shift, double factor, double center);

}

#endif
