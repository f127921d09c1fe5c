/**
 * @file    VisibleView.h
 * @brief   a camera before what is visible of a volume
 */

#ifndef VisibleView_h
#define VisibleView_h

#include "SceneDescription.h"

#include <string>

class vtkImageData;

namespace penumbra
{

/**
 * Sets the camera of a scene, whose transfer function is resolved, so that what its opacity
 * function and cropping leave visible fills the picture, seen from the front, a little from the side
 * and from above. Up is the head's direction in a patient's axes. Volumes without an orientation
 * stand on their heavy end where they have one; else a .raw file's longest axis is up, or z. Returns
 * what was chosen and why.
 */
std::string ViewFromTheFront(SceneDescription& scene, vtkImageData* image);

}

#endif
