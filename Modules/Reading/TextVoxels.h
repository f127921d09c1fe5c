/**
 * @file    TextVoxels.h
 * @brief   voxels that are written as numbers separated by blanks
 */

#ifndef TextVoxels_h
#define TextVoxels_h

#include <cstdint>

namespace penumbra
{

class ByteStream;

/**
 * Reads all of `stream`, which must be `count` numbers, to `destination` as values of `scalarType`.
 * Throws VolumeReadingError where there are more, or fewer, or where one is not a value of the
 * type.
 */
void ReadTextVoxels(ByteStream& stream, int scalarType, std::uint64_t count, void* destination);

}

#endif
