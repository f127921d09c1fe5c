/**
 * @file    VisibilityOutput.h
 * @brief   images as the pipeline describes them, and the arrays of visibility
 */

#ifndef VisibilityOutput_h
#define VisibilityOutput_h

#include "OutputGrid.h"
#include "VisibilityTask.h"

class vtkImageData;
class vtkInformation;

namespace penumbra
{

/// The whole image that the pipeline's information promises.
ImageGeometry GetImageGeometry(vtkInformation* information);
/// Promises that image, of floats.
void SetImageGeometry(const ImageGeometry& geometry, vtkInformation* information);

/// Makes the output that the information asks for, with one array for each of the task's lights or
/// a packed one, and lets the task fill it.
void AllocateVisibility(
  vtkInformation* information, bool packed, vtkImageData* output, VisibilityTask& task);

}

#endif
