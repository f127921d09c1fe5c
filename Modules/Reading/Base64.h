/**
 * @file    Base64.h
 * @brief   bytes that are written as base64 text
 */

#ifndef Base64_h
#define Base64_h

#include <memory>

namespace penumbra
{

class ByteStream;

/**
 * What `text` stands for, up to its end or to the next XML tag. Blanks do not count. Padding does
 * not end it: VTK may pad the header of voxels and the voxels each on their own. Reading throws
 * VolumeReadingError where the text is not base64.
 */
std::unique_ptr<ByteStream> DecodeBase64(std::unique_ptr<ByteStream> text);

}

#endif
