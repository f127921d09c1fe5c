/**
 * @file    SpeedVoxels.h
 * @brief   the volumes of the speed study, in every size
 */

#ifndef SpeedVoxels_h
#define SpeedVoxels_h

#include "SceneVolume.h"
#include "SpeedGrid.h"

#include <filesystem>

namespace penumbra
{

/**
 * The cell's volume in its size, within the same bounds, and without a mirror where the stock
 * mapper can be helped to draw it by that. `dicomParser` as in VoxelReading.
 * @throw InputError where it cannot be read.
 */
SceneVoxels ReadSpeedVoxels(const SpeedCell& cell, const std::filesystem::path& dicomParser);

}

#endif
