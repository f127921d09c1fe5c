/**
 * @file    vtkIlluminatedVolumeMapperInternals.h
 * @brief   what a mapper keeps from one picture to the next
 */

#ifndef vtkIlluminatedVolumeMapperInternals_h
#define vtkIlluminatedVolumeMapperInternals_h

#include "DrawnScene.h"
#include "InteractiveResolution.h"
#include "RayCounts.h"
#include "ShadowSettings.h"
#include "VolumeDrawing.h"
#include "vtkIlluminatedVolumeMapper.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <set>
#include <string>
#include <vector>

class vtkIlluminatedVolumeMapper::Internals
{
public:
  const penumbra::EmptySpaceReport& GetEmptySpace() const
  {
    return this->Drawing.GetTextures().GetEmptySpaceReport();
  }
  const penumbra::GradientTextureReport& GetGradients() const
  {
    return this->Drawing.GetTextures().GetGradientReport();
  }

  penumbra::DrawnScene Scene;
  penumbra::ShadowSettings Shadows;
  penumbra::VolumeDrawing Drawing;
  penumbra::InteractiveResolution Resolution;
  penumbra::RayCounts Counts;       ///< of the last frame
  double ImageSampleDistance = 1.0; ///< of the last frame
  bool ShadowsComplete = true;      ///< in the last frame
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::vector<std::string> Messages;
  std::set<std::string> MessagesGiven;
};

#endif
