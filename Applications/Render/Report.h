/**
 * @file    Report.h
 * @brief   what penumbra-render tells about a rendering, for programs and for people
 */

#ifndef Report_h
#define Report_h

#include "Frames.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkIlluminatedVolumeMapper;

namespace penumbra
{

/**
 * The report as JSON. `mapper` is null where the stock mapper rendered, which has no requirements
 * to tell.
 */
std::string WriteReport(const RenderedFrames& frames, vtkImageData* volume,
  vtkIlluminatedVolumeMapper* mapper, const std::vector<std::string>& warnings);

/// The same requirements as lines to read.
std::string ExplainRequirements(vtkIlluminatedVolumeMapper* mapper);

}

#endif
