/**
 * @file    SheetPicture.h
 * @brief   a contact sheet as a picture
 */

#ifndef SheetPicture_h
#define SheetPicture_h

#include "SheetDescription.h"

#include <vtkSmartPointer.h>

class vtkImageData;

namespace penumbra
{

/**
 * The sheet in 8-bit RGB, bottom row first. Pictures that are larger than a cell are scaled down to
 * fit into it, smaller ones stay as they are, in its middle.
 * @throw InputError where a picture is no whole PNG file, or the sheet would be too
 * large.
 */
vtkSmartPointer<vtkImageData> MakeSheetPicture(const SheetDescription& sheet);

}

#endif
