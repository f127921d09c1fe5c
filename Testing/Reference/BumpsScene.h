/**
 * @file    BumpsScene.h
 * @brief   a scene with a little of everything, whose picture is not known in closed form
 */

#ifndef BumpsScene_h
#define BumpsScene_h

#include "ReferenceScenes.h"

namespace penumbra
{

/// A smooth field of 8 x 8 x 8 voxels with values from 20 to 230.
vtkSmartPointer<vtkImageData> MakeBumps();

/// Of the bumps: semi-transparent, with steep and flat parts and a step, shaded, lit from two sides
/// with soft shadows; 16 x 16 pixels.
ReferenceScene MakeBumpsScene();

}

#endif
