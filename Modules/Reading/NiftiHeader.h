/**
 * @file    NiftiHeader.h
 * @brief   what must be true of a NIfTI header before VTK's reader sees it
 */

#ifndef NiftiHeader_h
#define NiftiHeader_h

#include <filesystem>

namespace penumbra
{

/// The bytes of the headers of NIfTI-1 and NIfTI-2.
constexpr int NiftiSize1 = 348;
constexpr int NiftiSize2 = 540;

/**
 * The type of the scalars, as VTK's constant. Throws VolumeReadingError for what
 * vtkNIFTIImageReader takes for another format or byte order, runs beyond its table of types for,
 * or turns to an undefined number.
 */
int CheckNiftiHeader(const std::filesystem::path& path);

}

#endif
