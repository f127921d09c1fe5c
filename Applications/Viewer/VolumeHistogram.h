/**
 * @file    VolumeHistogram.h
 * @brief   how often a volume's values and gradients occur, for charts
 */

#ifndef VolumeHistogram_h
#define VolumeHistogram_h

#include <vtkSmartPointer.h>

class vtkChartXY;
class vtkImageData;
class vtkPlot;
class vtkTable;

namespace penumbra
{

/// Two columns: the value, and the logarithm of its count over that of the largest count, 0 to 1.
vtkSmartPointer<vtkTable> MakeHistogram(vtkImageData* volume);

/**
 * The same of the gradients' lengths, from 0 to `largest`, in the volume's values per mean voxel as
 * opacity by gradient takes them. Longer ones are not counted.
 */
vtkSmartPointer<vtkTable> MakeGradientHistogram(vtkImageData* volume, double largest);

/// Shows a histogram behind all that the chart has. Returns its plot.
vtkSmartPointer<vtkPlot> AddHistogram(vtkTable* histogram, vtkChartXY* chart);

}

#endif
