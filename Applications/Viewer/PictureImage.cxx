#include "PictureImage.h"

#include <vtkImageData.h>

namespace penumbra
{

//------------------------------------------------------------------------------
QImage ToQImage(vtkImageData* picture)
{
  const int* size = picture->GetDimensions();
  const QImage image(static_cast<const uchar*>(picture->GetScalarPointer()), size[0], size[1],
    4 * size[0], QImage::Format_RGBX8888);
  return image.mirrored().convertToFormat(QImage::Format_RGB32);
}

}
