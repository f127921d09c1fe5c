/**
 * @file    Preset.h
 * @brief   presets and named materials, read and brought into a scene
 */

#ifndef Preset_h
#define Preset_h

#include "SceneDescription.h"
#include "VolumeStatistics.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace penumbra
{

/// What the first number of a preset's points is, see AppearancePreset.h.
enum class PresetScale
{
  Scalars,
  Percentiles,
  AllPercentiles,
  Threshold
};

struct Preset
{
  std::string Name;
  std::string Description;
  std::vector<std::string> Modalities;
  /// In mm around a patient's body, outside of which nothing is shown. Empty: all is.
  std::optional<double> CropMargin;
  PresetScale Scale = PresetScale::Scalars;
  TransferFunctionDescription TransferFunction;
  /// The sections "material" and "lights" of a scene file.
  std::shared_ptr<const nlohmann::json> Material;
  std::shared_ptr<const nlohmann::json> Lights;
};

/**
 * The preset of this name, or of the file of this name (which ends in .json) in `folder`.
 * @throw InputError where there is none, or where its document is no preset.
 */
Preset FindPreset(const std::string& name, const std::filesystem::path& folder);

/// One line for each preset: its name and what it shows.
std::string DescribePresets();

/// A preset, and why it.
struct PresetChoice
{
  std::string Name;
  std::string Reason;
};

/// By modality, unit and range of the values.
PresetChoice ChoosePreset(vtkImageData* image, const VolumeStatistics& statistics);

/**
 * The preset's transfer function in the volume's own scalars and lengths.
 */
TransferFunctionDescription ScaleToVolume(
  const Preset& preset, vtkImageData* image, const VolumeStatistics& statistics);

/**
 * The material of this name, as a section of a scene file.
 * @throw InputError where there is none; `path` is the key that names it.
 */
nlohmann::json FindMaterial(const std::string& name, const std::string& path);

}

#endif
