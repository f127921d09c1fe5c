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
 * Sets the scene's camera so that what its opacity function and cropping leave visible fills the
 * picture, seen from the front, a little from the side and from above. Up is the head's direction
 * in a patient's axes; for .raw files, which have none, the longest axis. Returns what was chosen
 * and why.
 */
std::string ViewFromTheFront(SceneDescription& scene, vtkImageData* image);

}

#endif
