/**
 * @file    RawLayout.h
 * @brief   what a .raw file's voxels may be, by its size and its name
 */

#ifndef RawLayout_h
#define RawLayout_h

#include "Vector3.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace penumbra
{

struct RawLayout
{
  std::array<int, 3> Dimensions = { 1, 1, 1 };
  /// One of ScalarTypeNames().
  std::string ScalarType = "uint8";
  Vector3 Spacing = { 1.0, 1.0, 1.0 };
  bool BigEndian = false;
  std::uint64_t HeaderBytes = 0;

  /// Of header and voxels together.
  std::uint64_t Bytes() const;

  /// As keys of a scene, see SceneSettings.h.
  std::vector<std::string> ToSettings() const;
};

/// Bytes of one voxel.
int BytesOf(const std::string& scalarType);

/**
 * Layouts that fill a file of so many bytes exactly, the most likely ones first: what the file's
 * name says ("head_256x256x128_uint16.raw"), then cubes and stacks of square slices of usual sizes.
 */
std::vector<RawLayout> ProposeLayouts(const std::string& fileName, std::uint64_t bytes);

}

#endif
