/**
 * @file    VolumeFields.h
 * @brief   what a reader tells about a volume beside its voxels
 */

#ifndef VolumeFields_h
#define VolumeFields_h

#include <string>

class vtkImageData;

namespace penumbra
{

/// The text of this name in the volume's field data, such as "Modality"; empty where there is none.
std::string TextField(vtkImageData* image, const char* name);

}

#endif
