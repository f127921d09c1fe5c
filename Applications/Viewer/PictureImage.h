/**
 * @file    PictureImage.h
 * @brief   pictures of VTK as Qt's images
 */

#ifndef PictureImage_h
#define PictureImage_h

#include <QImage>

class vtkImageData;

namespace penumbra
{

/// The colours of an 8-bit RGBA picture, bottom row first, as an opaque image.
QImage ToQImage(vtkImageData* picture);

}

#endif
