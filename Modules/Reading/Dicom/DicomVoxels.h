/**
 * @file    DicomVoxels.h
 * @brief   the voxels of a planned volume
 */

#ifndef DicomVoxels_h
#define DicomVoxels_h

#include "DicomParser.h"

#include <functional>
#include <vector>

namespace penumbra
{

struct DicomVoxels
{
  /// VTK's constant.
  int scalarType = 0;
  /// How many voxels without a measurement have got the value of another.
  std::size_t filled = 0;
};

/**
 * Where voxels go: given the scalar type, room for all of them.
 */
using VoxelRoom = std::function<void*(int scalarType)>;

/**
 * Called before a file is decoded.
 */
using FileStart = std::function<void(std::size_t file, double progress)>;

/**
 * How files are decoded.
 */
struct DicomDecoding
{
  FileStart start;
  /// Whether several threads may decode at once, and call `start`.
  bool inParallel = false;
};

/**
 * Decodes and assembles the voxels. Throws DicomFileError and what the start of a file throws.
 */
DicomVoxels ReadDicomVoxels(const std::vector<DicomFile>& files, const DicomVolumePlan& plan,
  const VoxelRoom& room, const DicomDecoding& decoding);

}

#endif
