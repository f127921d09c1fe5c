/**
 * @file ReferencePicture.h
 * @brief A scene's picture by the reference integrator, as a window would hold it.
 */
#ifndef ReferencePicture_h
#define ReferencePicture_h

#include "IlluminatedScene.h"

namespace penumbra
{
/// The scene as it was last rendered, in 8 bits a channel. Cropping is to a box.
vtkSmartPointer<vtkImageData> RenderReference(IlluminatedScene& scene);
}

#endif
