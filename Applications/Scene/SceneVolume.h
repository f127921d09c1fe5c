/**
 * @file    SceneVolume.h
 * @brief   a scene's volume: its voxels and the mapper that draws it
 */

#ifndef SceneVolume_h
#define SceneVolume_h

#include "SceneDescription.h"
#include "SceneMaterial.h"

#include <vtkSmartPointer.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

class vtkGPUVolumeRayCastMapper;
class vtkImageData;

namespace penumbra
{

/// What a scene names by file.
struct SceneVoxels
{
  vtkSmartPointer<vtkImageData> Volume;
  /// Bytes, in the volume's geometry; 0 hides. Null: no mask.
  vtkSmartPointer<vtkImageData> Mask;
  EnvironmentImages Environment{};
};

/// How files are read.
struct VoxelReading
{
  /// The program penumbra-dicom-parser. Empty: DICOM is parsed in this process.
  std::filesystem::path DicomParser;
  /// Told how much is done, 0 to 1; returns whether to go on. Empty: nobody is told.
  std::function<bool(double)> Progress;
};

/**
 * Reads volume and mask. What a user should know of them is appended to `warnings`.
 * @throw InputError where they cannot be read or do not go together.
 */
SceneVoxels ReadVoxels(
  const VolumeDescription& volume, const VoxelReading& reading, std::vector<std::string>& warnings);

/**
 * The mapper that a resolved scene asks for, with its input, steps, cropping, mask and clipping
 * planes. What the stock mapper cannot do is left out and told in `warnings`.
 */
vtkSmartPointer<vtkGPUVolumeRayCastMapper> MakeMapper(
  const SceneDescription& scene, const SceneVoxels& voxels, std::vector<std::string>& warnings);

/**
 * Gives a mapper of MakeMapper's, for a scene of the same renderer and voxels, all that this scene
 * asks of it.
 */
void ApplyToMapper(const SceneDescription& scene, vtkGPUVolumeRayCastMapper* mapper,
  std::vector<std::string>& warnings);

}

#endif
