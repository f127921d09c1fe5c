/**
 * @file    VoxelArray.h
 * @brief   memory for voxels, and voxels turned to other values
 */

#ifndef VoxelArray_h
#define VoxelArray_h

#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;

namespace penumbra
{

/**
 * An array of `count` scalars that are not set yet. Throws VolumeReadingError where there is not
 * enough memory.
 */
vtkSmartPointer<vtkDataArray> AllocateVoxels(int scalarType, std::uint64_t count);

/**
 * Turns `count` voxels of `scalarSize` bytes from the given byte order to the machine's.
 */
void SwapToMachine(void* voxels, std::uint64_t count, std::uint64_t scalarSize, bool bigEndian);

/**
 * slope * v + intercept for every v of `voxels`: as float32 if that holds every value of their
 * type, else as float64.
 */
vtkSmartPointer<vtkDataArray> Rescaled(vtkDataArray* voxels, double slope, double intercept);

/**
 * `voxels`, or float64 in their place, and a warning, where they are integers of 64 bits.
 */
vtkSmartPointer<vtkDataArray> WithoutLongIntegers(
  vtkDataArray* voxels, std::vector<std::string>& warnings);

/**
 * Throws VolumeReadingError where `bytes` are more than the memory of this machine.
 */
void CheckMemory(std::uint64_t bytes);

}

#endif
