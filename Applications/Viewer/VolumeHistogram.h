/**
 * @file    VolumeHistogram.h
 * @brief   how often the values of a volume occur, for a chart
 */

#ifndef VolumeHistogram_h
#define VolumeHistogram_h

#include <vtkSmartPointer.h>

class vtkImageData;
class vtkTable;

namespace penumbra
{

/// Two columns: the value, and the logarithm of its count over that of the largest count, 0 to 1.
vtkSmartPointer<vtkTable> MakeHistogram(vtkImageData* volume);

}

#endif
