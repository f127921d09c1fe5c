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

struct ReportTexts
{
  /// What was chosen for a volume without a scene, and why.
  std::vector<std::string> Choices;
  std::vector<std::string> Warnings;
};

/**
 * The report as JSON. `mapper` is null where the stock mapper rendered, which has no requirements
 * to tell.
 */
std::string WriteReport(const RenderedFrames& frames, vtkImageData* volume,
  vtkIlluminatedVolumeMapper* mapper, const ReportTexts& texts);

/// The same requirements as lines to read.
std::string ExplainRequirements(vtkIlluminatedVolumeMapper* mapper);

}

#endif
