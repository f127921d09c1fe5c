/**
 * @file    DefaultTransferFunction.h
 * @brief   a transfer function for a volume of which nothing is known
 */

#ifndef DefaultTransferFunction_h
#define DefaultTransferFunction_h

#include "SceneDescription.h"

class vtkImageData;

namespace penumbra
{

/**
 * Clear below the value that best separates the voxels into a background and an object (Otsu 1979),
 * and in the colours of bone, denser with rising value, above it. The unit distance is the mean
 * spacing. It depends on the voxels and the spacing alone.
 */
TransferFunctionDescription ChooseTransferFunction(vtkImageData* image);

}

#endif
