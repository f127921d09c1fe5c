/**
 * @file    SharedArray.h
 * @brief   a VTK array over shared memory
 */

#ifndef SharedArray_h
#define SharedArray_h

#include "SharedMemory.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataArray;

namespace penumbra
{

/**
 * An array of `count` values of `scalarType` that are in `memory`, which is kept for as long as
 * they are used. Throws VolumeReadingError where the memory is too small for them.
 */
vtkSmartPointer<vtkDataArray> MakeSharedArray(SharedMemory memory, int scalarType, vtkIdType count);

}

#endif
