/**
 * @class   VolumeGeometry
 * @brief   how many voxels a volume has and where they lie
 */

#ifndef VolumeGeometry_h
#define VolumeGeometry_h

#include <array>
#include <cstdint>

class vtkImageData;

namespace penumbra
{

using Vector3 = std::array<double, 3>;

struct VolumeGeometry
{
  std::array<std::int64_t, 3> dimensions{ 1, 1, 1 };
  Vector3 spacing{ 1.0, 1.0, 1.0 };
  Vector3 origin{ 0.0, 0.0, 0.0 };
  /// Row-major; its columns are the directions of the index axes.
  std::array<double, 9> direction{ 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
};

/**
 * Sets spacing and direction from the step in the world that leads from one voxel to the next along
 * each index axis. Throws VolumeReadingError where a step is not finite or 0, or where the axes are
 * sheared beyond what VolumeFile.h states.
 */
void SetSteps(VolumeGeometry& geometry, const std::array<Vector3, 3>& steps);

/**
 * Throws VolumeReadingError where dimensions, spacing, origin or direction are not those of a
 * volume.
 */
void CheckGeometry(const VolumeGeometry& geometry);

/**
 * The number of voxels. Throws VolumeReadingError where the dimensions are impossible or their
 * voxels of `scalarSize` bytes exceed 64-bit sizes.
 */
std::uint64_t NumberOfVoxels(const VolumeGeometry& geometry, std::uint64_t scalarSize);

/**
 * Gives `image` these dimensions, spacing, origin and direction.
 */
void ApplyGeometry(const VolumeGeometry& geometry, vtkImageData* image);

}

#endif
